package cz.paprsek.cli.input;

import cz.paprsek.cli.value.LayerNames;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.film.Film.Layer;
import java.util.List;
import picocli.CommandLine.Option;

/** What the user wants to know of pixels beside their light. */
public final class PixelWishes {
    @Option(names = "--transparent", description = {
        "Leaves the background away: the picture is transparent where nothing is hit, and at edges in part. For png and exr. What is mirrored, or seen through "
                + "glass, stays; glass is opaque."})
    private boolean transparent;

    @Option(names = "--aov", paramLabel = "LAYER", split = ",", completionCandidates = LayerNames.class, description = {
        "Layers beside the light, for programs that go on with the picture, in one exr file: ${COMPLETION-CANDIDATES}, one or several with commas between. "
                + "Normals and distances are of what is seen first, in scene units."})
    private List<Layer> layers = List.of();

    @Option(names = "--denoise", description =
            "Takes the noise out of a picture of --integrator path once it is whole, led by colours, normals, distances and by how sure each pixel is. Layers stay as they are.")
    private boolean denoised;

    public boolean isDenoised() {
        return denoised;
    }

    public boolean isTransparent() {
        return transparent;
    }

    public boolean haveLayers() {
        return !layers.isEmpty();
    }

    /** @throws IllegalArgumentException if the mode is none of light, or a layer is wished for twice */
    public RenderOptions applyTo(RenderOptions options) {
        RenderOptions layered = options.withLayers(layers);
        RenderOptions seen = transparent ? layered.withTransparency() : layered;
        return denoised ? seen.withDenoiser() : seen;
    }
}
