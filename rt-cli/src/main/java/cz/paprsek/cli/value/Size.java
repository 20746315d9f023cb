package cz.paprsek.cli.value;

import cz.paprsek.scene.RenderSettings;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.TypeConversionException;

/** A picture's width and height in pixels, as in {@code 1280x720}. */
public record Size(int width, int height) {
    private static final Pattern FORM = Pattern.compile("(\\d{1,5})[xX\u00d7](\\d{1,5})");

    public static Size parse(String text) {
        Matcher found = FORM.matcher(text);
        if (!found.matches()) {
            throw new TypeConversionException("expected WIDTHxHEIGHT such as 1280x720, but found '" + text + "'");
        }
        Size size = new Size(Integer.parseInt(found.group(1)), Integer.parseInt(found.group(2)));
        try {
            RenderSettings.DEFAULT.withSize(size.width, size.height);
        } catch (IllegalArgumentException refused) {
            throw new TypeConversionException(refused.getMessage());
        }
        return size;
    }

    /** Picocli asks for it whenever an option is given; what the record brings along takes 20 ms the first time. */
    @Override
    public String toString() {
        return width + "x" + height;
    }
}
