package cz.paprsek.cli.output;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashSet;
import java.util.Set;

/**
 * Which frames of a film are written already, in a file beside them: for each a line with a digest of all that it depends on, so that a frame of another scene, or of other settings, is rendered anew.
 */
final class FrameLedger {
    private final Path file;
    private final Set<String> done;

    private FrameLedger(Path file, Set<String> done) {
        this.file = file;
        this.done = done;
    }

    /** @param pattern the name of the pictures, with {@code {frame}} in it */
    static FrameLedger of(Path pattern) throws IOException {
        Path file = Checkpoint.fileFor(pattern);
        return new FrameLedger(file, Files.exists(file) ? new HashSet<>(Files.readAllLines(file, StandardCharsets.UTF_8)) : new HashSet<>());
    }

    /** Whether a picture is there, and was noted as that frame's. */
    boolean has(Path picture, String digest) {
        return done.contains(line(picture, digest)) && Files.exists(picture);
    }

    void add(Path picture, String digest) throws IOException {
        if (done.add(line(picture, digest))) {
            Files.writeString(file, line(picture, digest) + "\n", StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        }
    }

    /** All frames are there. */
    void discard() throws IOException {
        Files.deleteIfExists(file);
    }

    private static String line(Path picture, String digest) {
        return digest + " " + picture.getFileName();
    }
}
