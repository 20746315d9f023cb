package cz.paprsek.cli.value;

import java.util.regex.Pattern;
import picocli.CommandLine.TypeConversionException;

/**
 * One of the shares into which the work on a picture is divided.
 *
 * @param number which, from 1
 * @param count how many there are, 1–{@value #MOST}
 */
public record Shard(int number, int count) {
    public static final int MOST = 1_000_000;
    private static final Pattern FORM = Pattern.compile("\\d{1,7}/\\d{1,7}");

    /** @throws IllegalArgumentException if there is no such share */
    public Shard {
        if (count < 1 || count > MOST || number < 1 || number > count) {
            throw new IllegalArgumentException("shard " + number + "/" + count + " must be one of 1/N to N/N, with N from 1 to " + MOST);
        }
    }

    public static Shard parse(String text) {
        if (!FORM.matcher(text).matches()) {
            throw new TypeConversionException("expected I/N, the share I of N, such as 3/8, but found '" + text + "'");
        }
        int slash = text.indexOf('/');
        try {
            return new Shard(Integer.parseInt(text.substring(0, slash)), Integer.parseInt(text.substring(slash + 1)));
        } catch (IllegalArgumentException refused) {
            throw new TypeConversionException(String.valueOf(refused.getMessage()));
        }
    }

    @Override
    public String toString() {
        return number + "/" + count;
    }
}
