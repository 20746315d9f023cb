package cz.paprsek.cli.value;

import cz.paprsek.scene.RenderSettings;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.TypeConversionException;

/** How many rays each pixel gets along a side: {@code 3} for a grid, {@code 2..8} for as many as it needs, the most being 0 for a grid. */
public record Samples(int least, int most) {
    private static final Pattern FORM = Pattern.compile("(\\d{1,4})(?:\\.\\.(\\d{1,4}))?");

    public static Samples parse(String text) {
        Matcher found = FORM.matcher(text);
        // A written 0 is none: it would stand for a grid.
        if (!found.matches() || (found.group(2) != null && Integer.parseInt(found.group(2)) == 0)) {
            throw new TypeConversionException("expected a number from 1 to " + RenderSettings.MOST_SAMPLES + " or two such as 2..8, but found '" + text + "'");
        }
        Samples samples = new Samples(Integer.parseInt(found.group(1)), found.group(2) == null ? 0 : Integer.parseInt(found.group(2)));
        try {
            RenderSettings.DEFAULT.withSamples(samples.least, samples.most);
        } catch (IllegalArgumentException refused) {
            throw new TypeConversionException(refused.getMessage());
        }
        return samples;
    }
}
