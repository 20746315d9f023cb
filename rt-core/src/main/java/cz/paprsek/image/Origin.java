package cz.paprsek.image;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * Where a picture comes from, to be told in its file. Nothing that would differ if it were made again: no clock, no machine, no number of
 * threads. What is empty is left away.
 *
 * @param scene the scene's name
 * @param digest of the scene, by which it can be told from others
 * @param program what computed it, with its version
 * @param settings how it was computed
 */
public record Origin(String scene, String digest, String program, String settings) {
    /** Tells nothing. */
    public static final Origin UNTOLD = new Origin("", "", "", "");

    public Origin {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(digest, "digest");
        Objects.requireNonNull(program, "program");
        Objects.requireNonNull(settings, "settings");
    }

    /** What is told, by the words that PNG has for it. */
    Map<String, String> texts() {
        Map<String, String> texts = new LinkedHashMap<>();
        put(texts, "Title", scene);
        put(texts, "Source", digest);
        put(texts, "Software", program);
        put(texts, "Comment", settings);
        return texts;
    }

    /** As lines of printable ASCII, for comments in heads of files. */
    List<String> lines() {
        List<String> lines = new ArrayList<>();
        texts().forEach((word, text) -> {
            StringBuilder line = new StringBuilder(word + ": ");
            text.codePoints().forEach(c -> line.append(c >= ' ' && c <= '~' ? Character.toString(c) : String.format("\\u%04x", c)));
            lines.add(line.toString());
        });
        return lines;
    }

    private static void put(Map<String, String> texts, String word, String text) {
        if (!text.isEmpty()) {
            texts.put(word, text);
        }
    }
}
