package cz.paprsek.cli.value;

import cz.paprsek.render.Tile;
import java.util.Arrays;
import java.util.regex.Pattern;
import picocli.CommandLine.TypeConversionException;

/** A part of a picture as a user writes it: column and row of its top left pixel, width, height. */
public final class Region {
    private static final Pattern FORM = Pattern.compile("\\d{1,5}(,\\d{1,5}){3}");

    private Region() {}

    public static Tile parse(String text) {
        if (!FORM.matcher(text).matches()) {
            throw new TypeConversionException("expected X,Y,WIDTH,HEIGHT in pixels such as 100,50,320,200, but found '" + text + "'");
        }
        int[] numbers = Arrays.stream(text.split(",", -1)).mapToInt(Integer::parseInt).toArray();
        try {
            return new Tile(numbers[0], numbers[1], numbers[2], numbers[3]);
        } catch (IllegalArgumentException refused) {
            throw new TypeConversionException(refused.getMessage());
        }
    }
}
