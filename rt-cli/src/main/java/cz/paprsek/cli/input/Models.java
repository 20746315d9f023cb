package cz.paprsek.cli.input;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.ForeignFormat;
import cz.paprsek.format.ForeignScene;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/** Files of other programs that are read as scenes. */
public final class Models {
    private Models() {}

    /** Which format it is in; none for scenes of ours, whatever they are called, and what cannot be read. */
    public static Optional<ForeignFormat> format(Path file) {
        if (!Files.isRegularFile(file)) {
            return Optional.empty();
        }
        try (InputStream input = Files.newInputStream(file)) {
            byte[] head = input.readNBytes(ForeignFormat.HEAD);
            return Foreign.isMarkup(head) ? Optional.empty() : ForeignFormat.of(name(file), head);
        } catch (IOException unreadable) {
            // Whoever reads it will say why.
            return ForeignFormat.ofName(name(file));
        }
    }

    static String name(Path file) {
        return String.valueOf(Objects.requireNonNullElse(file.getFileName(), file));
    }

    /**
     * What it shows.
     *
     * @throws IOException if it cannot be read; in one line without the file's name
     */
    public static ForeignScene read(Path file, ForeignFormat format) throws IOException {
        String prefix = '"' + name(file) + "\": ";
        try {
            return ForeignScene.read(name(file), format, Assets.beside(file));
        } catch (IOException e) {
            String sentence = String.valueOf(e.getMessage());
            throw sentence.startsWith(prefix) ? new IOException(sentence.substring(prefix.length()), e) : e;
        }
    }
}
