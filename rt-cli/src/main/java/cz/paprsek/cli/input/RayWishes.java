package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.Filters;
import cz.paprsek.cli.value.Integrators;
import cz.paprsek.cli.value.Part;
import cz.paprsek.cli.value.Samples;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import java.util.Optional;
import picocli.CommandLine.Option;

/** What the user wants of the rays of a pixel, otherwise than the scenes say. */
public final class RayWishes {
    /** Rays along a side by which a pixel can be judged. */
    private static final int FEWEST = 2;

    @Option(names = "--integrator", paramLabel = "INTEGRATOR", completionCandidates = Integrators.class, description = {
        "How light is gathered: ${COMPLETION-CANDIDATES}. whitted follows mirrors, glass and the lights; path all ways that light can come. Default: the scene's."})
    private Optional<Integrator> integrator = Optional.empty();

    @Option(names = "--samples", paramLabel = "N|A..B", description = {
        "Rays along each side of a pixel, 1-16: N x N in a grid. A..B: A x A random ones, and more, at most B x B, until the error is small. "
                + "With the integrator path, paths in a pixel, 1-1000000, or at least A and at most B. Default: the scene's, or of another integrator than its own 1, and 64 paths."})
    private Optional<Samples> samples = Optional.empty();

    @Option(names = "--error", paramLabel = "X", description =
            "How far the value shown may be from the true one, 1 being from black to white; 1/255 is a step. Of a scene whose samples are a grid, N, it makes "
                    + "N..16, at least 2..16; of one whose paths are a number, 64..1000000, or to the number that --samples says. Default: the scene's.")
    private Optional<Part> error = Optional.empty();

    @Option(names = "--confidence", paramLabel = "P", description = "How probable it is to be that close, above 0 and below 1. Makes samples of a grid as --error does. Default: the scene's.")
    private Optional<Double> confidence = Optional.empty();

    @Option(names = "--filter", paramLabel = "FILTER", completionCandidates = Filters.class, description =
            "How a pixel's rays are strewn around its centre: ${COMPLETION-CANDIDATES}. Default: the scene's.")
    private Optional<PixelFilter> filter = Optional.empty();

    @Option(names = "--sampler", paramLabel = "SAMPLER", defaultValue = "scrambled", description = {
        "${COMPLETION-CANDIDATES}: what is random, other in every pixel or the same in all, as 'convert' writes it for POV-Ray. Default: scrambled."})
    private Sampler sampler = Sampler.scrambled;

    /** Where random numbers come from. */
    public enum Sampler { scrambled, fixed }

    boolean isFixed() {
        return sampler == Sampler.fixed;
    }

    /** Whether a number of samples is said. */
    public boolean haveSamples() {
        return samples.isPresent();
    }

    /** @throws IllegalArgumentException if a number is out of range */
    RenderSettings applyTo(RenderSettings scene) {
        RenderSettings settings = scene.withIntegrator(integrator.orElse(scene.integrator()));
        boolean isNear = error.isPresent() || confidence.isPresent();
        RenderSettings wished = samples.map(s -> settings.withSamples(s.least(), s.most())).orElse(settings);
        wished = isNear && !wished.isAdaptive() && (samples.isEmpty() || settings.isPath()) ? adaptive(wished) : wished;
        wished = wished.withError(error.map(Part::value).orElse(wished.error())).withConfidence(confidence.orElse(wished.confidence()))
                .withFilter(filter.orElse(wished.filter()));
        if (isNear && !wished.isAdaptive()) {
            throw new WrongUsage("--error and --confidence are for --samples A..B, such as 2..8");
        }
        return wished;
    }

    /** Who says how near a pixel shall be wants as many rays as that takes; those of a grid are not judged. */
    private RenderSettings adaptive(RenderSettings settings) {
        return settings.isPath() ? settings.withSamples(Math.min(settings.samples(), RenderSettings.USUAL_PATHS), samples.map(Samples::least).orElse(RenderSettings.MOST_PATHS))
                : settings.withSamples(Math.max(FEWEST, settings.samples()), RenderSettings.MOST_SAMPLES);
    }
}
