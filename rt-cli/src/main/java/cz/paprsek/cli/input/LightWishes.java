package cz.paprsek.cli.input;

import cz.paprsek.cli.value.Tones;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.scene.RenderSettings;
import java.util.Optional;
import picocli.CommandLine.Option;

/** How the user wants light to be shown, otherwise than the scenes say. */
public final class LightWishes {
    @Option(names = "--exposure", paramLabel = "STOPS", description =
            "Brightens the picture as it is written; each stop doubles the light. Default: the scene's.")
    private Optional<Double> exposure = Optional.empty();

    @Option(names = "--tone", paramLabel = "TONE", completionCandidates = Tones.class, description = {
        "How light is fitted to a screen: ${COMPLETION-CANDIDATES}. With none, what is brighter than white is white; "
                + "filmic bends highlights towards white as film does, and darkens shadows a little. Default: the scene's."})
    private Optional<Tone> tone = Optional.empty();

    /**
     * For a picture that is there.
     *
     * @throws IllegalArgumentException if the exposure is out of range
     */
    public ImageOptions applyTo(ImageOptions options) {
        return options.withExposure(exposure.orElse(options.exposure())).withTone(tone.orElse(options.tone()));
    }

    /** Whether something is wished for. */
    public boolean areSaid() {
        return exposure.isPresent() || tone.isPresent();
    }

    /** @throws IllegalArgumentException if the exposure is out of range */
    RenderSettings applyTo(RenderSettings settings) {
        return settings.withExposure(exposure.orElse(settings.exposure())).withTone(tone.orElse(settings.tone()));
    }
}
