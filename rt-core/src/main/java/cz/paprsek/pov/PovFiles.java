package cz.paprsek.pov;

import cz.paprsek.io.AtomicFile;
import cz.paprsek.scene.Scene;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * Writes scenes as POV-Ray 3.7 reads them, such that it computes the same light at every pixel. POV-Ray's own tolerances are absolute, so
 * scenes should be about 1 to 100 units large. The picture's size is not in the file: it is an argument of {@code povray}.
 */
public final class PovFiles {
    private PovFiles() {}

    /** What a file that a scene names must be called beside POV-Ray's: it finds none whose name has other letters than those of ASCII. */
    public static String nameOf(String file) {
        StringBuilder name = new StringBuilder();
        file.codePoints().forEach(letter -> name.append(letter < 128 ? Character.toString(letter) : "_" + Integer.toHexString(letter)));
        return name.toString();
    }

    /**
     * Writes a scene.
     *
     * @return a sentence for everything that POV-Ray will not show exactly as we do; empty if all is exact
     */
    public static List<String> write(Scene scene, Appendable out) throws IOException {
        Scene shown = scene.shown();
        new PovWriter(shown, out).write();
        return PovWarnings.of(shown, !scene.animations().isEmpty());
    }

    /**
     * Writes a scene to a file, whole or not at all.
     *
     * @return as {@link #write(Scene, Appendable)}
     */
    public static List<String> write(Scene scene, Path file) throws IOException {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(file, "file");
        List<String> warnings = new ArrayList<>();
        AtomicFile.write(file, out -> {
            BufferedWriter text = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
            warnings.addAll(write(scene, text));
            text.flush();
        });
        return warnings;
    }
}
