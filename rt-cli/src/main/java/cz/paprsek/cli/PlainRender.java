package cz.paprsek.cli;

import cz.paprsek.cli.value.Size;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.TypeConversionException;

/**
 * What most calls of {@code render} say: scenes, and at most an output, a size, a number of threads, and to be quiet. It is understood here, since picocli takes as long
 * to be loaded as a small picture to be rendered. All other words are picocli's, also those that are wrong.
 *
 * @param isQuiet whether only errors are told
 */
record PlainRender(List<String> scenes, Optional<String> output, Optional<Size> size, Optional<Integer> threads, boolean isQuiet) {
    private static final int MOST_DIGITS = 4;

    /** What the words of a call say; nothing if it is not as plain. */
    static Optional<PlainRender> of(String... words) {
        if (words.length == 0 || !words[0].equals("render")) {
            return Optional.empty();
        }
        List<String> scenes = new ArrayList<>();
        Map<String, String> values = new HashMap<>();
        boolean isQuiet = false;
        for (int i = 1; i < words.length; i++) {
            String word = words[i];
            boolean isNew = true;
            if (word.equals("-q") || word.equals("--quiet")) {
                isNew = !isQuiet;
                isQuiet = true;
            } else if (isOfValue(word)) {
                i++;
                isNew = i < words.length && isPlain(words[i]) && values.put(word.equals("--output") ? "-o" : word, words[i]) == null;
            } else {
                scenes.add(word);
                isNew = isPlain(word);
            }
            if (!isNew) {
                return Optional.empty();
            }
        }
        return scenes.isEmpty() ? Optional.empty() : of(scenes, values, isQuiet);
    }

    private static Optional<PlainRender> of(List<String> scenes, Map<String, String> values, boolean isQuiet) {
        String threads = values.getOrDefault("--threads", "");
        if (!isNumber(threads)) {
            return Optional.empty();
        }
        try {
            Optional<Size> size = values.containsKey("--size") ? Optional.of(Size.parse(values.getOrDefault("--size", ""))) : Optional.empty();
            return Optional.of(new PlainRender(List.copyOf(scenes), Optional.ofNullable(values.get("-o")), size,
                    threads.isEmpty() ? Optional.empty() : Optional.of(Integer.valueOf(threads)), isQuiet));
        } catch (TypeConversionException wrong) {
            return Optional.empty();
        }
    }

    private static boolean isOfValue(String word) {
        return word.equals("-o") || word.equals("--output") || word.equals("--size") || word.equals("--threads");
    }

    /** Whether it is no option, nor the name of a file with more words. */
    private static boolean isPlain(String word) {
        return !word.isEmpty() && word.charAt(0) != '-' && word.charAt(0) != '@';
    }

    private static boolean isNumber(String word) {
        boolean isNumber = word.length() <= MOST_DIGITS;
        for (int i = 0; i < word.length(); i++) {
            isNumber &= word.charAt(i) >= '0' && word.charAt(i) <= '9';
        }
        return isNumber;
    }
}
