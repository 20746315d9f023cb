package cz.paprsek.image;

import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * Planes of numbers of one size, each with a name: {@code R}, {@code G}, {@code B} and {@code A} for the picture and its opacity, and for what
 * else is known of its pixels, a layer's name before a dot, as {@code albedo.R} or {@code normal.X}. Each plane is row by row from the top left.
 */
public final class Layers {
    private static final int LONGEST_NAME = 200;

    private final int width;
    private final int height;
    private final Map<String, float[]> planes;
    private final ImageOptions written;

    private Layers(int width, int height, Map<String, float[]> planes, ImageOptions written) {
        this.width = width;
        this.height = height;
        this.planes = planes;
        this.written = written;
    }

    /** No planes yet. */
    public static Layers ofSize(int width, int height) {
        Image.requireRoom(width, height);
        return new Layers(width, height, Map.of(), ImageOptions.DEFAULT);
    }

    /** The picture as R, G and B. */
    public static Layers of(Image image) {
        return ofSize(image.width(), image.height()).with("", image);
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /** The names of all planes, in the order they came. */
    public List<String> names() {
        return List.copyOf(planes.keySet());
    }

    /**
     * Another plane.
     *
     * @param values are copied
     * @throws IllegalArgumentException if there is one of that name, the name is empty or longer than 200 characters, or the number of values
     *     is not that of the pixels
     */
    public Layers with(String name, float[] values) {
        Require.that(values.length == width * height, "a plane of " + values.length + " values does not fit " + width + " × " + height + " pixels");
        return withOwn(name, values.clone());
    }

    /**
     * Another layer of three channels: {@code layer.R}, {@code layer.G} and {@code layer.B}.
     *
     * @param layer empty for the picture itself
     * @throws IllegalArgumentException as above, or if the sizes differ
     */
    public Layers with(String layer, Image image) {
        Require.that(image.width() == width && image.height() == height,
                "a layer of " + image.width() + " × " + image.height() + " pixels does not fit " + width + " × " + height);
        float[] red = new float[width * height];
        float[] green = new float[width * height];
        float[] blue = new float[width * height];
        for (int i = 0; i < red.length; i++) {
            red[i] = image.red(i % width, i / width);
            green[i] = image.green(i % width, i / width);
            blue[i] = image.blue(i % width, i / width);
        }
        String prefix = layer.isEmpty() ? "" : layer + ".";
        return withOwn(prefix + "R", red).withOwn(prefix + "G", green).withOwn(prefix + "B", blue);
    }

    /** A plane that nobody else will change. */
    Layers withOwn(String name, float[] values) {
        Require.that(!name.isEmpty() && name.length() <= LONGEST_NAME && name.indexOf(0) < 0, "the name of a plane must have from 1 to " + LONGEST_NAME + " characters");
        Require.that(!planes.containsKey(name), "there are two planes named " + name);
        Map<String, float[]> all = new LinkedHashMap<>(planes);
        all.put(name, values);
        return new Layers(width, height, Collections.unmodifiableMap(all), written);
    }

    /** @param options of the picture among them: only its exposure, tone and origin are kept */
    Layers writtenAs(ImageOptions options) {
        return new Layers(width, height, planes, ImageOptions.shown(options.exposure(), options.tone()).withOrigin(options.origin()));
    }

    /** How the picture among these planes was exposed and toned, as no other layer is, and where it comes from, that left away: what a file tells of it, if it is one of ours. */
    public ImageOptions written() {
        return written;
    }

    /**
     * The value of a plane at a pixel.
     *
     * @throws IllegalArgumentException if there is no such plane
     */
    public float at(String name, int x, int y) {
        return plane(name)[y * width + x];
    }

    /** Copies a row of a plane. */
    void copy(String name, int y, float[] into) {
        System.arraycopy(plane(name), y * width, into, 0, width);
    }

    /**
     * Three planes as a picture: those of a layer, or of the picture itself if its name is empty; if there are no colours, its brightness Y.
     *
     * @throws IllegalArgumentException if there is no such layer
     */
    public Image image(String layer) {
        String prefix = layer.isEmpty() ? "" : layer + ".";
        List<float[]> channels = new ArrayList<>();
        for (String channel : planes.containsKey(prefix + "R") ? List.of("R", "G", "B") : List.of("Y", "Y", "Y")) {
            channels.add(plane(prefix + channel));
        }
        Image image = new Image(width, height);
        for (int i = 0; i < width * height; i++) {
            image.set(i % width, i / width, channels.get(0)[i], channels.get(1)[i], channels.get(2)[i]);
        }
        return image;
    }

    /** Which lights there are layers of, in red, green and blue, by the words that layers have for them: {@code lamp} of {@code light.lamp.R}; last {@code rest}, for all that comes from none. */
    public List<String> lights() {
        return LightMix.lights(this);
    }

    /**
     * A picture whose lights are made brighter, darker or of another colour afterwards: what each of them brings is taken as often as is wished.
     *
     * @param picture of which these are the layers
     * @param shares by the words of {@link #lights}, for red, green and blue, in linear light: 0 for nothing, 1 for what there is; lights that are not named stay as they are.
     *     If all are 1, the picture is the same to the last bit
     * @throws IllegalArgumentException if there is no such light, a share is negative or above the largest float, or the sizes differ
     */
    public Image mixed(Image picture, Map<String, Vec3> shares) {
        return LightMix.of(Objects.requireNonNull(picture, "picture"), this, Objects.requireNonNull(shares, "shares"));
    }

    /**
     * As above, of the picture among these planes: as light, neither exposed nor toned, whatever {@link #written} tells of it. If it was either, it is put together from what all lights bring.
     *
     * @throws IllegalArgumentException as above, or if there is no picture
     */
    public Image mixed(Map<String, Vec3> shares) {
        boolean isLight = written.exposure() == 0 && written.tone() == Tone.NONE;
        return mixed(isLight ? image("") : LightMix.sum(this), shares);
    }

    /**
     * Which of these layers hold for a picture whose lights are mixed otherwise: each light's, as bright as it is there, and what has nothing to do with light: normals, albedo, distances, objects, counts of
     * samples. If all shares are 1, all but the picture itself.
     *
     * @throws IllegalArgumentException as above
     */
    public Layers ofMix(Map<String, Vec3> shares) {
        return LightMix.layers(this, Objects.requireNonNull(shares, "shares"));
    }

    /** Its own values, which nobody may change. */
    float[] plane(String name) {
        float[] values = planes.get(name);
        if (values == null) {
            throw new IllegalArgumentException("there is no plane named " + name + " among " + String.join(", ", planes.keySet()));
        }
        return values;
    }
}
