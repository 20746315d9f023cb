package cz.paprsek.cli.output;

import cz.paprsek.resume.Checkpoint;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Which frames of a film are written already, in a file beside them: for each a line with a digest of all that it depends on, so that a frame of another scene, or of other settings, is rendered anew, and with its size and time, so that
 * one is as well which somebody has put something else in the place of.
 * Of several lines of a picture the last is true; none is true of a picture that is about to be replaced.
 */
final class FrameLedger {
    /** In place of what is known of a picture that may be any. */
    private static final String UNKNOWN = "- -";

    private final Path file;
    private final Map<String, String> noted = new HashMap<>();

    private FrameLedger(Path file) {
        this.file = file;
    }

    /** @param pattern the name of the pictures, with {@code {frame}} in it */
    static FrameLedger of(Path pattern) throws IOException {
        FrameLedger ledger = new FrameLedger(Checkpoint.fileFor(pattern));
        if (Files.exists(ledger.file)) {
            String text = new String(Files.readAllBytes(ledger.file), StandardCharsets.UTF_8);
            if (!text.isEmpty() && !text.endsWith("\n")) {
                // Torn: the next line must be one of its own.
                ledger.append("\n");
            }
            text.lines().map(line -> line.split(" ", 3)).filter(line -> line.length == 3).forEach(line -> ledger.noted.put(line[2], line[0] + " " + line[1]));
        }
        return ledger;
    }

    /** Whether a picture is there, and was noted as that frame's. */
    boolean has(Path picture, String digest) throws IOException {
        return Files.exists(picture) && (digest + " " + state(picture)).equals(noted.get(name(picture)));
    }

    void add(Path picture, String digest) throws IOException {
        note(picture, digest + " " + state(picture));
    }

    private void note(Path picture, String what) throws IOException {
        noted.put(name(picture), what);
        append(what + " " + name(picture) + "\n");
    }

    /** Changes when its file does. */
    private static String state(Path picture) throws IOException {
        BasicFileAttributes now = Files.readAttributes(picture, BasicFileAttributes.class);
        return now.size() + "-" + now.lastModifiedTime().toMillis();
    }

    /** Before a picture is replaced. */
    void forget(Path picture) throws IOException {
        if (noted.containsKey(name(picture))) {
            note(picture, UNKNOWN);
        }
    }

    /** Some frames are there: of a film of these nothing need be remembered. */
    void done(Set<Path> pictures) throws IOException {
        if (pictures.stream().map(FrameLedger::name).collect(Collectors.toSet()).containsAll(noted.keySet())) {
            Files.deleteIfExists(file);
        }
    }

    private void append(String text) throws IOException {
        Files.writeString(file, text, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
    }

    private static String name(Path picture) {
        return String.valueOf(picture.getFileName());
    }
}
