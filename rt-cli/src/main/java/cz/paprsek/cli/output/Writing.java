package cz.paprsek.cli.output;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.origin.Origins;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.mistake.Mistake;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** How pictures are written, and what they tell of themselves. */
public record Writing(Optional<Integer> bits, boolean uncompressed) {
    /** @throws WrongUsage if a picture's format cannot have as many bits */
    public void check(List<ImageFormat> formats) {
        for (ImageFormat format : formats) {
            if (uncompressed && format != ImageFormat.EXR) {
                throw new WrongUsage("--uncompressed is for exr, not for " + format.extension());
            }
        }
        try {
            formats.forEach(options()::bitsOf);
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(String.valueOf(refused.getMessage()));
        }
    }

    /** @param scene as it was read, whatever of it is shown */
    ImageOptions of(Scene scene, RenderOptions render, View view, ImageFormat format) {
        return of(scene, new Digest(scene, format), render, view, format);
    }

    /** @param digest of the scene */
    ImageOptions of(Scene scene, Digest digest, RenderOptions render, View view, ImageFormat format) {
        RenderSettings settings = render.settings();
        ImageOptions shown = view.mode() == RenderMode.SHADED ? options().withExposure(settings.exposure()).withTone(settings.tone()) : options();
        Origin origin = Origins.areToldIn(format) ? Origins.of(scene, digest.text(), render, view.camera(), view.light()) : Origin.UNTOLD;
        boolean isRight = view.mistakes().equals(Mistakes.NONE) || origin.equals(Origin.UNTOLD);
        String mistakes = view.mistakes().all().stream().map(Mistake::toString).collect(Collectors.joining(","));
        return shown.withOrigin(isRight ? origin : new Origin(origin.scene(), origin.digest(), origin.program(), origin.settings() + " --mistake " + mistakes));
    }

    /** As the user wishes. */
    public ImageOptions options() {
        ImageOptions options = bits.map(ImageOptions.DEFAULT::withBits).orElse(ImageOptions.DEFAULT);
        return uncompressed ? options.withoutCompression() : options;
    }
}
