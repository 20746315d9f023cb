package cz.paprsek.cli.output;

import cz.paprsek.cli.input.Cameras;
import cz.paprsek.cli.input.PixelWishes;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.drawing.Legend;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.render.mode.RenderMode.HeatScale;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * What a picture is to show, if not just the scene as it is.
 *
 * @param camera the one that sees it: its name, or its number from 1
 * @param light the only light to shine: its name, or its number from 1
 * @param legend whether a heat map gets its scale below it
 * @param pixels what of pixels beside their light
 * @param mistakes what is done wrong, by the plain tracer; none for the renderer
 */
public record View(RenderMode mode, Optional<String> camera, Optional<String> light, boolean legend, PixelWishes pixels, Mistakes mistakes) {

    /** @throws WrongUsage if a picture's format cannot hold what is to be known of its pixels, or that is asked for twice */
    public void check(List<Target> targets) {
        for (Target target : targets) {
            String format = target.format().extension();
            if (pixels.haveLayers() && target.format() != ImageFormat.EXR) {
                throw new WrongUsage(format + " has no layers; --aov needs a picture in exr");
            }
            if (pixels.isTransparent() && !target.format().isTransparent()) {
                throw new WrongUsage(format + " has no opacity; --transparent needs a picture in png or exr");
            }
        }
        try {
            // Which integrator a scene has is not known yet: there is none with more layers than this.
            applyTo(RenderOptions.of(RenderSettings.DEFAULT.withIntegrator(Integrator.PATH)), ImageFormat.EXR);
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(String.valueOf(refused.getMessage()));
        }
    }

    /** @throws WrongUsage if the scene has no such camera or light */
    Scene of(Scene scene) {
        Scene seen = Cameras.through(scene, camera);
        return light.isEmpty() ? seen : seen.litBy(chosen(seen, light.get()));
    }

    /** Programs read depths and counts as they are, eyes see them as brightness and colours. */
    public RenderOptions applyTo(RenderOptions options, ImageFormat format) {
        if (!mistakes.equals(Mistakes.NONE)) {
            return RenderOptions.of(options.settings().withSamples(options.settings().samples()));
        }
        RenderOptions shown = pixels.applyTo(options.withMode(mode));
        return isNumbers(format) ? shown.withNumbers() : shown;
    }

    /** What a picture of parts shows, of which the rest has been done already. */
    public static View ofParts(RenderMode mode, boolean legend) {
        return new View(mode, Optional.empty(), Optional.empty(), legend, new PixelWishes(), Mistakes.NONE);
    }

    /** How the picture is written: brightness as text has 256 steps, numbers have as many as they need. */
    public ImageFormat written(ImageFormat format) {
        return format == ImageFormat.TXT && isNumbers(format) ? ImageFormat.RAW : format;
    }

    /** With as many digits as numbers need, unless fewer were asked for. */
    public ImageOptions written(ImageFormat format, ImageOptions how) {
        return format == ImageFormat.EXR && isNumbers(format) && how.bits().isEmpty() ? how.withBits(Float.SIZE) : how;
    }

    /** Whether the picture's format shows numbers as they are. */
    public boolean isNumbers(ImageFormat format) {
        return mode.isNumber() && switch (format) {
            case EXR, PFM, TXT, RAW -> true;
            case PNG, JPG, TIF, BMP, HDR, PPM, PPM16, PGM -> false;
        };
    }

    /** The picture as it is written. */
    public Image finished(Image image, ImageFormat format) {
        return scale(format).map(scale -> Legend.below(image, scale)).orElse(image);
    }

    /** The scale of colours that goes below the picture. */
    Optional<HeatScale> scale(ImageFormat format) {
        return legend && !isNumbers(format) ? mode.scale() : Optional.empty();
    }

    private static int chosen(Scene scene, String word) {
        List<Light> lights = scene.lights();
        return IntStream.range(0, lights.size()).filter(i -> lights.get(i).name().equals(word)).boxed().findFirst()
                .or(() -> IntStream.range(0, lights.size()).filter(i -> word.equals(Integer.toString(i + 1))).boxed().findFirst())
                .orElseThrow(() -> new WrongUsage("there is no light \"" + word + "\"; this scene has " + known(lights)));
    }

    private static String known(List<Light> lights) {
        if (lights.isEmpty()) {
            return "none";
        }
        List<String> names = lights.stream().map(Light::name).filter(name -> !name.isEmpty()).toList();
        return (lights.size() == 1 ? "one light, number 1" : "lights 1 to " + lights.size()) + (names.isEmpty() ? "" : ", named " + String.join(", ", names));
    }
}
