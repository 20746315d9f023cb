package cz.paprsek.cli.shard;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** The line that makes parts again, for a shell to be pasted into. */
public final class Again {
    private static final List<String> LONG = List.of("--shard", "--output");
    private static final List<String> FRAMES = List.of("--frames", "--frame");
    private static final String SHORT = "-o";
    private static final String PLAIN = "[A-Za-z0-9_@%+=:,./-]+";

    private Again() {}

    /** The words of a command line but those that say whose work it is and where it goes. */
    public static List<String> shared(List<String> words) {
        List<String> shared = new ArrayList<>();
        for (int i = 0; i < words.size(); i++) {
            String word = words.get(i);
            if (LONG.contains(word) || word.equals(SHORT)) {
                i++;
            } else if (LONG.stream().noneMatch(name -> word.startsWith(name + "=")) && !word.startsWith(SHORT)) {
                shared.add(word);
            }
        }
        return shared;
    }

    /** The words with other frames of the film. */
    static List<String> ofFrames(List<String> words, Span span) {
        List<String> other = new ArrayList<>();
        for (int i = 0; i < words.size(); i++) {
            String word = words.get(i);
            if (FRAMES.contains(word)) {
                i++;
            } else if (FRAMES.stream().noneMatch(name -> word.startsWith(name + "="))) {
                other.add(word);
            }
        }
        other.addAll(List.of("--frames", span.first() + "-" + span.last()));
        return other;
    }

    /** The line for some shares of so many. */
    static String line(List<String> words, List<Integer> numbers, int count, Path folder) {
        boolean isOne = numbers.size() == 1;
        String command = "paprsek " + words.stream().map(Again::quoted).collect(Collectors.joining(" ")) + " --shard " + (isOne ? numbers.get(0) : "$i") + "/" + count + " -o "
                + quoted(folder.toString());
        return isOne ? command : "for i in " + numbers.stream().map(String::valueOf).collect(Collectors.joining(" ")) + "; do " + command + "; done";
    }

    /** A word as a shell takes it for one. */
    public static String quoted(String word) {
        return word.matches(PLAIN) ? word : "'" + word.replace("'", "'\\''") + "'";
    }
}
