package cz.paprsek.cli.value;

import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.TypeConversionException;

/**
 * How many rays each pixel gets along a side: {@code 3} for a grid, {@code 2..8} for as many as it needs, the most being 0 for a grid. Of paths how many
 * there are, or how many at least and at most.
 */
public record Samples(int least, int most) {
    private static final Pattern FORM = Pattern.compile("(\\d{1,9})(?:\\.\\.(\\d{1,9}))?");

    public static Samples parse(String text) {
        Matcher found = FORM.matcher(text);
        // A written 0 is none: it would stand for a grid.
        if (!found.matches() || (found.group(2) != null && Integer.parseInt(found.group(2)) == 0)) {
            throw new TypeConversionException("expected a number from 1 to " + RenderSettings.MOST_SAMPLES + ", of paths to " + RenderSettings.MOST_PATHS
                    + ", or two such as 2..8, but found '" + text + "'");
        }
        Samples samples = new Samples(Integer.parseInt(found.group(1)), found.group(2) == null ? 0 : Integer.parseInt(found.group(2)));
        try {
            // Which integrator it is for is known when the scene is.
            RenderSettings.DEFAULT.withIntegrator(Integrator.PATH).withSamples(samples.least, samples.most);
        } catch (IllegalArgumentException refused) {
            throw new TypeConversionException(refused.getMessage());
        }
        return samples;
    }
}
