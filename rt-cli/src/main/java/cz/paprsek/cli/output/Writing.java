package cz.paprsek.cli.output;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.Samples;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.text.Numbers;
import cz.paprsek.xml.SceneFiles;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;

/** How pictures are written, and what they tell of themselves. */
public record Writing(Optional<Integer> bits, boolean uncompressed) {
    /** To write down more of them would take longer than to render them. */
    private static final int MOST_DIGESTED = 100_000;

    /** @throws WrongUsage if a picture's format cannot have as many bits */
    public void check(List<Target> targets) {
        for (Target target : targets) {
            if (uncompressed && target.format() != ImageFormat.EXR) {
                throw new WrongUsage("--uncompressed is for exr, not for " + target.format().extension());
            }
        }
        try {
            for (Target target : targets) {
                options().bitsOf(target.format());
            }
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(String.valueOf(refused.getMessage()));
        }
    }

    /** @param scene as it was read, whatever of it is shown */
    ImageOptions of(Scene scene, RenderOptions render, View view, ImageFormat format) {
        RenderSettings settings = render.settings();
        ImageOptions shown = view.mode() == RenderMode.SHADED ? options().withExposure(settings.exposure()).withTone(settings.tone()) : options();
        return shown.withOrigin(switch (format) {
            // Portable maps could hold comments, but many a reader of them understands none.
            case BMP, PFM, TXT, RAW, PPM, PPM16, PGM -> Origin.UNTOLD;
            case PNG, JPG, TIF, HDR, EXR -> new Origin(scene.name(), digest(scene), program(), settings(render, view));
        });
    }

    private ImageOptions options() {
        ImageOptions options = bits.map(ImageOptions.DEFAULT::withBits).orElse(ImageOptions.DEFAULT);
        return uncompressed ? options.withoutCompression() : options;
    }

    private static String program() {
        return "Paprsek " + Objects.requireNonNullElse(Writing.class.getPackage().getImplementationVersion(), "(development)");
    }

    /** Of the scene as {@code convert} writes it: that it was written differently changes no picture. */
    private static String digest(Scene scene) {
        if (scene.objects().size() > MOST_DIGESTED) {
            return "";
        }
        try {
            byte[] text = SceneFiles.format(scene).getBytes(StandardCharsets.UTF_8);
            return "scene sha256 " + HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(text));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    private String settings(RenderOptions render, View view) {
        RenderSettings settings = render.settings();
        StringBuilder text = new StringBuilder("--size " + settings.width() + "x" + settings.height() + " --samples " + Samples.text(settings)
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
        if (!render.layers().isEmpty()) {
            text.append(" --aov ").append(render.layers().stream().map(Layer::toString).collect(Collectors.joining(",")));
        }
        text.append(view.mode() == RenderMode.SHADED ? "" : " --mode " + view.mode());
        view.camera().ifPresent(camera -> text.append(" --camera ").append(camera));
        view.light().ifPresent(light -> text.append(" --light ").append(light));
        text.append(settings.exposure() == 0 ? "" : " --exposure " + Numbers.text(settings.exposure()));
        text.append(settings.tone() == Tone.NONE ? "" : " --tone " + settings.tone());
        return text.toString();
    }
}
