package cz.paprsek.cli.output;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Which frames of a film are written already, in a file beside them: for each a line with a digest of all that it depends on, so that a frame of another scene, or of other settings, is rendered anew.
 * Of several lines of a picture the last is true; none is true of a picture that is about to be replaced.
 */
final class FrameLedger {
    /** In place of the digest of a picture that may be any. */
    private static final String UNKNOWN = "-";

    private final Path file;
    private final Map<String, String> digests = new HashMap<>();

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
            text.lines().map(line -> line.split(" ", 2)).filter(line -> line.length == 2).forEach(line -> ledger.digests.put(line[1], line[0]));
        }
        return ledger;
    }

    /** Whether a picture is there, and was noted as that frame's. */
    boolean has(Path picture, String digest) {
        return digest.equals(digests.get(name(picture))) && Files.exists(picture);
    }

    void add(Path picture, String digest) throws IOException {
        digests.put(name(picture), digest);
        append(digest + " " + name(picture) + "\n");
    }

    /** Before a picture is replaced. */
    void forget(Path picture) throws IOException {
        if (digests.containsKey(name(picture))) {
            add(picture, UNKNOWN);
        }
    }

    /** Some frames are there: of a film of these nothing need be remembered. */
    void done(Set<Path> pictures) throws IOException {
        if (pictures.stream().map(FrameLedger::name).collect(Collectors.toSet()).containsAll(digests.keySet())) {
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
