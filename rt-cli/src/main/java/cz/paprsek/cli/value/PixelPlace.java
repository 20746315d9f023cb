package cz.paprsek.cli.value;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.TypeConversionException;

/** Column and row of a pixel, from 0 at the top left, as in {@code 320,180}. */
public record PixelPlace(int column, int row) {
    private static final Pattern FORM = Pattern.compile("(\\d{1,5}),(\\d{1,5})");

    public static PixelPlace parse(String text) {
        Matcher found = FORM.matcher(text);
        if (!found.matches()) {
            throw new TypeConversionException("expected COLUMN,ROW of a pixel such as 320,180, but found '" + text + "'");
        }
        return new PixelPlace(Integer.parseInt(found.group(1)), Integer.parseInt(found.group(2)));
    }
}
