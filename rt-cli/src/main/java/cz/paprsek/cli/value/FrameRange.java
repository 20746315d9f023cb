package cz.paprsek.cli.value;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.TypeConversionException;

/** Frames of a film, from 1, as a user writes them: {@code 1-100}, or {@code 7} for one. */
public record FrameRange(int first, int last) {
    private static final Pattern FORM = Pattern.compile("(\\d{1,7})(?:-(\\d{1,7}))?");

    public static FrameRange parse(String text) {
        Matcher found = FORM.matcher(text);
        if (!found.matches()) {
            throw new TypeConversionException("expected frames such as 1-100, or 7, but found '" + text + "'");
        }
        int first = Integer.parseInt(found.group(1));
        int last = found.group(2) == null ? first : Integer.parseInt(found.group(2));
        if (first < 1 || last < first) {
            throw new TypeConversionException("frames begin with 1 and go from the lower to the higher number, but here they go from " + first + " to " + last);
        }
        return new FrameRange(first, last);
    }

    public int count() {
        return last - first + 1;
    }

    /** A number with zeros in front, so that names sort as frames follow each other. */
    public String padded(int frame) {
        return String.format(Locale.ROOT, "%0" + Math.max(4, String.valueOf(last).length()) + "d", frame);
    }
}
