package cz.paprsek.cli.shard;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Lines of a key and a value each, in a fixed order, as the heads of part files have them. */
final class Fields {
    private static final Pattern ESCAPED = Pattern.compile("\\\\(.)");

    private final List<String> lines;
    private int at;

    Fields(List<String> lines) {
        this.lines = lines;
    }

    /** Appends a line; what would end it is escaped. */
    static void put(StringBuilder text, String key, Object value) {
        text.append(key).append(' ').append(value.toString().replace("\\", "\\\\").replace("\n", "\\n").replace("\r", "\\r")).append('\n');
    }

    /** The value of the next line, which must have this key. */
    String next(String key) throws IOException {
        if (at == lines.size() || !lines.get(at).startsWith(key + " ")) {
            throw new IOException("its head has no " + key + " where that should be");
        }
        Matcher escaped = ESCAPED.matcher(lines.get(at++).substring(key.length() + 1));
        return escaped.replaceAll(found -> Matcher.quoteReplacement(found.group(1).equals("n") ? "\n" : found.group(1).equals("r") ? "\r" : found.group(1)));
    }

    /** The values of all lines that follow with this key. */
    List<String> all(String key) throws IOException {
        List<String> values = new ArrayList<>();
        while (at < lines.size() && lines.get(at).startsWith(key + " ")) {
            values.add(next(key));
        }
        return values;
    }

    /** So many whole numbers with a space between. */
    int[] numbers(String key, int count) throws IOException {
        String[] words = next(key).split(" ", -1);
        int[] numbers = new int[count];
        try {
            for (int i = 0; i < count; i++) {
                numbers[i] = Integer.parseInt(words[i]);
            }
        } catch (NumberFormatException | ArrayIndexOutOfBoundsException wrong) {
            throw new IOException("its head has no " + count + " whole numbers for " + key, wrong);
        }
        return numbers;
    }
}
