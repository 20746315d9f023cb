package cz.paprsek.origin;

import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.text.Numbers;
import cz.paprsek.xml.SceneFiles;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;

/** What the files of pictures tell of where they come from, whoever rendered them. */
public final class Origins {
    /** To write down more bodies would take longer than to render them. */
    private static final int MOST_DIGESTED = 100_000;

    private Origins() {}

    /**
     * Of a picture in a file of a format. Nothing if the format holds no text; portable maps could hold comments, but many a reader of them understands none.
     *
     * @param scene as it was read, whatever of it is shown
     * @param camera the one that sees it, if not the first: its name, or its number from 1
     * @param light the only light that shines: its name, or its number from 1
     */
    public static Origin of(Scene scene, RenderOptions render, Optional<String> camera, Optional<String> light, ImageFormat format) {
        return areToldIn(format) ? of(scene, digest(scene), render, camera, light) : Origin.UNTOLD;
    }

    /**
     * The same, of a picture in a file that holds text.
     *
     * @param digest of the scene, as {@link #digest} says it
     */
    public static Origin of(Scene scene, String digest, RenderOptions render, Optional<String> camera, Optional<String> light) {
        return new Origin(scene.name(), digest, program(), settings(render, camera, light));
    }

    /** Whether a format holds text. */
    public static boolean areToldIn(ImageFormat format) {
        return switch (format) {
            case BMP, PFM, TXT, RAW, PPM, PPM16, PGM -> false;
            case PNG, JPG, TIF, HDR, EXR -> true;
        };
    }

    private static String program() {
        return "Paprsek " + Objects.requireNonNullElse(Origins.class.getPackage().getImplementationVersion(), "(development)");
    }

    /** Of the scene as {@code convert} writes it: that it was written differently changes no picture. Empty if it is too large for that. Takes a while for one of thousands of bodies. */
    public static String digest(Scene scene) {
        long bodies = 0;
        for (int i = 0; i < scene.objects().size(); i++) {
            bodies += Body.of(scene.objects().get(i)).primitives(MOST_DIGESTED + 1);
            if (bodies > MOST_DIGESTED) {
                return "";
            }
        }
        try {
            byte[] text = SceneFiles.format(scene).getBytes(StandardCharsets.UTF_8);
            return "scene sha256 " + HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(text));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    /** In the words of the command line. */
    private static String settings(RenderOptions render, Optional<String> camera, Optional<String> light) {
        RenderSettings settings = render.settings();
        StringBuilder text = new StringBuilder("--size " + settings.width() + "x" + settings.height() + (settings.isPath() ? " --integrator path" : "") + " --samples " + samples(settings)
                + " --max-depth " + settings.maxDepth());
        if (settings.isAdaptive()) {
            text.append(" --error ").append(Numbers.text(settings.error())).append(" --confidence ").append(Numbers.text(settings.confidence()));
        }
        text.append(settings.filter() == PixelFilter.BOX ? "" : " --filter " + settings.filter());
        text.append(render.fixedSampler() ? " --sampler fixed" : "");
        if (render.region().width() != settings.width() || render.region().height() != settings.height()) {
            text.append(" --region ").append(render.region().x()).append(',').append(render.region().y()).append(',')
                    .append(render.region().width()).append(',').append(render.region().height());
        }
        text.append(render.transparent() ? " --transparent" : "");
        text.append(render.denoised() ? " --denoise" : "");
        if (!render.layers().isEmpty()) {
            text.append(" --aov ").append(render.layers().stream().map(Layer::toString).collect(Collectors.joining(",")));
        }
        text.append(render.mode() == RenderMode.SHADED ? "" : " --mode " + render.mode());
        camera.ifPresent(one -> text.append(" --camera ").append(one));
        light.ifPresent(one -> text.append(" --light ").append(one));
        text.append(settings.exposure() == 0 ? "" : " --exposure " + Numbers.text(settings.exposure()));
        text.append(settings.tone() == Tone.NONE ? "" : " --tone " + settings.tone());
        return text.toString();
    }

    private static String samples(RenderSettings settings) {
        return settings.samples() + (settings.isAdaptive() ? ".." + settings.mostSamples() : "");
    }
}
