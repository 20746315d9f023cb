package cz.paprsek.fx.view.render.fields;

import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** What a user answered last to questions that are asked again, by their names: kept for the next start, but for what counts only as long as the program runs. */
public final class Remembered {
    private final Consumer<String> keep;
    private final Set<String> forNow;
    private final ReadOnlyObjectWrapper<Map<String, String>> answers;

    private Remembered(Optional<String> before, Consumer<String> keep, Set<String> forNow) {
        this.keep = keep;
        this.forNow = forNow;
        this.answers = new ReadOnlyObjectWrapper<>(before.map(Remembered::parsed).orElse(Map.of()));
    }

    /**
     * What is kept as a text.
     *
     * @param before the text that was kept last
     * @param keep keeps another one
     * @param forNow the names of what is forgotten when the program ends
     */
    public static Remembered kept(Optional<String> before, Consumer<String> keep, Set<String> forNow) {
        return new Remembered(before, keep, forNow);
    }

    /** What is forgotten with the program. */
    public static Remembered forNow() {
        return new Remembered(Optional.empty(), text -> {}, Set.of());
    }

    /** All answers by their names. */
    public Map<String, String> answers() {
        return answers.get();
    }

    /** All answers, to be followed. */
    public ReadOnlyObjectProperty<Map<String, String>> answersProperty() {
        return answers.getReadOnlyProperty();
    }

    /** Remembers these answers, and no others. */
    public void set(Map<String, String> now) {
        if (!now.equals(answers())) {
            answers.set(Map.copyOf(now));
            keep.accept(text());
        }
    }

    /** Remembers another answer as well. */
    public void put(String name, String answer) {
        Map<String, String> now = new TreeMap<>(answers());
        now.put(name, answer);
        set(now);
    }

    /** Remembers it no more, if it was answered at all. */
    public void forget(String name) {
        Map<String, String> now = new TreeMap<>(answers());
        now.remove(name);
        set(now);
    }

    private String text() {
        return new TreeMap<>(answers()).entrySet().stream().filter(answer -> !forNow.contains(answer.getKey()))
                .map(answer -> answer.getKey() + "=" + URLEncoder.encode(answer.getValue(), StandardCharsets.UTF_8)).collect(Collectors.joining("&"));
    }

    /** What can be read of it, which somebody may have edited. */
    private static Map<String, String> parsed(String text) {
        Map<String, String> read = new TreeMap<>();
        for (String part : text.split("&", -1)) {
            int at = part.indexOf('=');
            if (at > 0) {
                try {
                    read.put(part.substring(0, at), URLDecoder.decode(part.substring(at + 1), StandardCharsets.UTF_8));
                } catch (IllegalArgumentException garbled) {
                    // As if it had never been answered.
                }
            }
        }
        return Map.copyOf(read);
    }
}
