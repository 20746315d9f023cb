package cz.paprsek.cli.shard;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Tile;
import cz.paprsek.render.join.JoinedNoise;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.resume.SceneDigest;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/**
 * Which picture, or film, parts are of. Two parts belong together if their cards are the same to the letter: of the same scene with the same files beside it, by the same
 * version with the same options, whatever machine, Java and number of threads there was.
 *
 * @param program what renders it, with its version
 * @param settings how it is rendered, in the words of the command line
 * @param exposure in stops, as the picture is written
 * @param tone likewise
 * @param mode what the picture shows
 * @param numbers whether that are numbers, and not brightness and colours
 * @param legend whether its scale of colours goes below it, if it has one
 * @param transparent whether it has opacity
 * @param region the part of the picture that is the image
 * @param planes the names of what else is known of each pixel, last of all what a denoiser goes by
 * @param passes into how many passes, each a part of its own, it can be divided; 0 if it cannot
 * @param filter what paths are strewn by, which says what is kept of a pass
 * @param scene digest of the scene, and of all files that it needs
 * @param options digest of how it is rendered
 */
public record Card(String program, String settings, double exposure, Tone tone, RenderMode mode, boolean numbers, boolean legend, boolean transparent, Tile region, List<String> planes,
        int passes, PixelFilter filter, String scene, String options) {
    private static final int MOST_PASSES = RenderSettings.MOST_PATHS / RenderSettings.USUAL_PATHS;

    public Card {
        planes = List.copyOf(planes);
    }

    /**
     * That of a picture which is to be rendered.
     *
     * @param scene what is shown, whose files are in the assets already; of a film, all of it
     * @param isFilm whether it is a film, of which also counts how it is made
     * @param how the picture will be written in a format that tells its origin
     */
    public static Card of(Scene scene, boolean isFilm, Assets assets, RenderOptions options, ImageOptions how, boolean legend) {
        String content = isFilm ? SceneDigest.of(scene, assets, "film " + scene.recipe().text()) : SceneDigest.of(scene, assets);
        String settings = SceneDigest.ofText(options.withThreads(1).toString());
        List<String> planes = options.ofPart(options.region()).planes(scene);
        int passes = indivisible(options).isPresent() ? 0 : options.passes();
        return new Card(how.origin().program(), how.origin().settings(), how.exposure(), how.tone(), options.mode(), options.numbers(), legend, options.transparent(), options.region(), planes, passes,
                options.settings().filter(), content, settings);
    }

    /** Why a picture cannot be divided into passes; empty if it can. */
    static Optional<String> indivisible(RenderOptions options) {
        RenderSettings settings = options.settings();
        return !settings.isPath() ? Optional.of("this picture is not of --integrator path")
                : options.mode() != RenderMode.SHADED ? Optional.of("--mode " + options.mode() + " shows none")
                : settings.isAdaptive() ? Optional.of("with --error, how many a pixel gets is known only when those before are there")
                : settings.samples() % RenderSettings.USUAL_PATHS != 0 ? Optional.of("--samples " + settings.samples() + " is no multiple of 64")
                : !options.layers().isEmpty() || options.transparent() || options.denoised() ? Optional.of("--aov, --transparent and --denoise are more") : Optional.empty();
    }

    /** The names of the layers of the picture. */
    public List<String> layers() {
        return planes.stream().filter(plane -> !JoinedNoise.has(plane)).toList();
    }

    /** How many numbers each pixel has. */
    int channels() {
        return (transparent ? 4 : 3) + planes.size();
    }

    /** The picture is written like this, by the format's own wishes beside it. */
    public ImageOptions applyTo(ImageOptions how) {
        return how.withExposure(exposure).withTone(tone);
    }

    /** In what the picture of this card differs from that of another one. */
    String difference(Card other) {
        return !program.equals(other.program) ? "made by " + program + ", and not by " + other.program
                : !scene.equals(other.scene) ? "of another scene, or of other files beside it"
                : !settings.equals(other.settings) ? "rendered with " + settings + ", and not with " + other.settings
                : "of another picture";
    }

    String text() {
        StringBuilder text = new StringBuilder();
        Fields.put(text, "program", program);
        Fields.put(text, "settings", settings);
        Fields.put(text, "exposure", exposure);
        Fields.put(text, "tone", tone.name());
        Fields.put(text, "mode", mode.name());
        Fields.put(text, "numbers", numbers);
        Fields.put(text, "legend", legend);
        Fields.put(text, "transparent", transparent);
        Fields.put(text, "region", text(region));
        planes.forEach(plane -> Fields.put(text, "plane", plane));
        Fields.put(text, "passes", passes);
        Fields.put(text, "filter", filter.name());
        Fields.put(text, "scene", scene);
        Fields.put(text, "options", options);
        return text.toString();
    }

    /** @throws IllegalArgumentException if a value is none that its kind has, or there can be no such picture, or not in so many passes */
    static Card read(Fields fields) throws IOException {
        String program = fields.next("program");
        String settings = fields.next("settings");
        ImageOptions how = ImageOptions.shown(Double.parseDouble(fields.next("exposure")), Tone.valueOf(fields.next("tone")));
        RenderMode mode = RenderMode.valueOf(fields.next("mode"));
        boolean numbers = Boolean.parseBoolean(fields.next("numbers"));
        boolean legend = Boolean.parseBoolean(fields.next("legend"));
        boolean transparent = Boolean.parseBoolean(fields.next("transparent"));
        Tile region = tile(fields, "region");
        Image.requireRoom(region.width(), region.height());
        List<String> planes = fields.all("plane");
        if (!JoinedNoise.areWhole(planes) || (mode != RenderMode.SHADED && planes.stream().anyMatch(JoinedNoise::has))) {
            throw new IllegalArgumentException("what it knows of noise is not all there, or not in order, or of a picture that has none");
        }
        int passes = fields.numbers("passes", 1)[0];
        boolean isOfLight = mode == RenderMode.SHADED && !transparent && planes.isEmpty();
        if (passes < 0 || passes > (isOfLight ? MOST_PASSES : 0)) {
            throw new IllegalArgumentException(isOfLight ? "a picture has no more than " + MOST_PASSES + " passes, and not " + passes : "only a picture of light alone is in passes, and this one is more");
        }
        PixelFilter filter = PixelFilter.valueOf(fields.next("filter"));
        return new Card(program, settings, how.exposure(), how.tone(), mode, numbers, legend, transparent, region, planes, passes, filter, fields.next("scene"), fields.next("options"));
    }

    static String text(Tile tile) {
        return tile.x() + " " + tile.y() + " " + tile.width() + " " + tile.height();
    }

    static Tile tile(Fields fields, String key) throws IOException {
        int[] numbers = fields.numbers(key, 4);
        return new Tile(numbers[0], numbers[1], numbers[2], numbers[3]);
    }
}
