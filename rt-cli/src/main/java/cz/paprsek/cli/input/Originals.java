package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Collection;

/** Files that a command reads, and so must not write over. */
public final class Originals {
    private Originals() {}

    /**
     * Before anything is computed.
     *
     * @param what is to be written, as {@code the new file}
     * @param kind of the originals, as {@code the scene}
     * @throws WrongUsage if the target is one of them, by another name or through a link, too
     */
    public static void spare(Path target, String what, String kind, Collection<Path> originals) {
        Path place = real(target);
        for (Path original : originals) {
            if (real(original).equals(place)) {
                throw new WrongUsage(what + " would overwrite " + kind + " " + original + "; name another place");
            }
        }
    }

    /** Where a file really is, as far as it is there. */
    public static Path real(Path file) {
        try {
            return file.toRealPath();
        } catch (IOException none) {
            return file.toAbsolutePath().normalize();
        }
    }
}
