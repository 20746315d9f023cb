package cz.paprsek.render.film;

import cz.paprsek.image.Image;
import cz.paprsek.scene.Light;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * What the light of a picture, or of a part of one, falls on, addressed by the pixels of the whole picture; beside the light, planes of whatever
 * else is to be known of each pixel. Several workers may use it at once, each for pixels of its own.
 *
 * <p>Who keeps tiles ({@code TileStore}) is told the pass, and writes down {@linkplain #channel all channels} of a pixel that a film has.
 */
public final class Film {
    private static final int LIGHT = 3;

    private final Image image;
    private final int left;
    private final int top;
    private final float[][] planes;
    private final int kept;
    /** By rows: of a large picture they are more numbers than one array holds. */
    private final float[][] sums;
    private final AtomicInteger wanting = new AtomicInteger();

    /**
     * @param image what becomes of it
     * @param left which column of the picture is the image's first
     * @param top likewise which row
     */
    public Film(Image image, int left, int top) {
        this(image, left, top, 0);
    }

    /** @param planes how many planes there are beside the image */
    public Film(Image image, int left, int top, int planes) {
        this(image, left, top, planes, 0);
    }

    /**
     * A film of a picture that is made in passes.
     *
     * @param planes how many planes there are beside the image
     * @param kept how many numbers of each pixel are kept from one pass to the next
     */
    public Film(Image image, int left, int top, int planes, int kept) {
        this.image = Objects.requireNonNull(image, "image");
        this.left = left;
        this.top = top;
        this.planes = new float[planes][image.width() * image.height()];
        this.kept = kept;
        this.sums = new float[image.height()][kept * image.width()];
    }

    /** Whether something is kept of each pixel from one pass to the next. */
    public boolean isInPasses() {
        return kept > 0;
    }

    /** Which column of the picture is the image's first. */
    public int left() {
        return left;
    }

    /** Likewise which row. */
    public int top() {
        return top;
    }

    /** Puts there what is kept of a pixel: zeros at first. */
    public void kept(int x, int y, float[] into) {
        Objects.requireNonNull(into, "into");
        System.arraycopy(sums[y - top], kept * (x - left), into, 0, kept);
    }

    /** Keeps that of a pixel. */
    public void keep(int x, int y, float[] numbers) {
        Objects.requireNonNull(numbers, "numbers");
        System.arraycopy(numbers, 0, sums[y - top], kept * (x - left), kept);
    }

    /** So many pixels are to get more in another pass. */
    public void wantMore(int pixels) {
        wanting.addAndGet(pixels);
    }

    /** How many pixels are to get more in another pass, as far as is known. */
    public int wanting() {
        return wanting.get();
    }

    /** How many pixels were to get more in another pass, which begins: now none is known to get more in that after it. */
    public int beginPass() {
        return wanting.getAndSet(0);
    }

    private int at(int x, int y) {
        return (y - top) * image.width() + x - left;
    }

    /** Sets the light of a pixel of the picture, linear. */
    public void set(int x, int y, double red, double green, double blue) {
        image.set(x - left, y - top, red, green, blue);
    }

    /** Likewise on a film with opacity: the light of the covered part, times the share that is covered, and that share. */
    public void set(int x, int y, double red, double green, double blue, double opacity) {
        image.set(x - left, y - top, red, green, blue, opacity);
    }

    /** Sets a pixel's value on a plane, counted from 0. */
    public void setPlane(int plane, int x, int y, double value) {
        planes[plane][at(x, y)] = (float) value;
    }

    /** Sets a pixel's values on three planes that follow each other, the first counted from 0. */
    public void setPlanes(int plane, int x, int y, double first, double second, double third) {
        setPlane(plane, x, y, first);
        setPlane(plane + 1, x, y, second);
        setPlane(plane + 2, x, y, third);
    }

    /** The light of a pixel of the picture, linear; 0 as long as it has not been set. */
    public float red(int x, int y) {
        return image.red(x - left, y - top);
    }

    /** As {@link #red}. */
    public float green(int x, int y) {
        return image.green(x - left, y - top);
    }

    /** As {@link #red}. */
    public float blue(int x, int y) {
        return image.blue(x - left, y - top);
    }

    /** The values of a plane, row by row from the top left; not a copy. */
    public float[] plane(int plane) {
        return planes[plane];
    }

    /** How many numbers a pixel has: red, green and blue, with opacity that, one of each plane, and those that are kept. */
    public int channels() {
        return lights() + planes.length + kept;
    }

    private int lights() {
        return image.isTransparent() ? LIGHT + 1 : LIGHT;
    }

    /** One of a pixel's numbers, in that order, counted from 0. */
    public float channel(int channel, int x, int y) {
        return switch (channel) {
            case 0 -> red(x, y);
            case 1 -> green(x, y);
            case 2 -> blue(x, y);
            default -> channel < lights() ? image.alpha(x - left, y - top)
                    : channel < lights() + planes.length ? planes[channel - lights()][at(x, y)] : sums[y - top][kept * (x - left) + channel - lights() - planes.length];
        };
    }

    /** Sets all of a pixel's numbers, in that order. */
    public void setChannels(int x, int y, float... values) {
        if (image.isTransparent()) {
            set(x, y, values[0], values[1], values[2], values[LIGHT]);
        } else {
            set(x, y, values[0], values[1], values[2]);
        }
        for (int i = 0; i < planes.length; i++) {
            planes[i][at(x, y)] = values[lights() + i];
        }
        System.arraycopy(values, lights() + planes.length, sums[y - top], kept * (x - left), kept);
    }

    /**
     * What else there is to know of a picture's pixels beside their light, for programs that go on with it. All of what a pixel's rays from the eye
     * meet first, and none of it where they meet nothing.
     */
    public enum Layer {
        /** The normal, of length 1 towards the viewer, world space; the mean of those that are met. */
        NORMAL("X", "Y", "Z"),
        /** The share of light that is strewn, diffusion times colour, linear. Bodies of lights strew none. */
        ALBEDO("R", "G", "B"),
        /** The distance from the eye in scene units; the mean of those that are met. */
        DEPTH("Z"),
        /** The object's number in the scene, from 1, and after the objects those of lights that are seen; the one that most rays meet, 0 if most meet nothing. */
        OBJECT("ID"),
        /**
         * The light that reaches what is seen straight from lamps, its ambient and its own; or the background's. Of paths also what comes straight from the sky and from bodies
         * that glow, and is strewn there. Linear.
         */
        DIRECT("R", "G", "B"),
        /** The light that is mirrored or let through, and of paths what other surfaces strew: what {@link #DIRECT} lacks to the picture. Linear. */
        INDIRECT("R", "G", "B"),
        /** How many rays from the eye the pixel took. */
        SAMPLES("N"),
        /**
         * How far the value that is shown, from black as 0 to white as 1, may be from the true one, in the channel where that is farthest, with the confidence that is asked for;
         * below 0 where that cannot be trusted. Of pixels that are judged: those of paths, and of adaptive samples.
         */
        ERROR("V"),
        /** What each light brings, wherever it went: {@code light.NAME.R}, or its number from 1, and {@code light.rest.R} for what comes from none. Their sum is the picture. Linear. */
        LIGHT("R", "G", "B");

        private static final String REST = "rest";
        private static final int LONGEST_NAME = 80;
        @SuppressWarnings("ImmutableEnumChecker") // a copy that nobody can change
        private final List<String> channels;

        Layer(String... channels) {
            this.channels = List.of(channels);
        }

        /**
         * The names of its planes as files have them: {@code normal.X}.
         *
         * @param lights of the scene
         */
        public List<String> planes(List<Light> lights) {
            Objects.requireNonNull(lights, "lights");
            Stream<String> layers = this == LIGHT ? Stream.concat(IntStream.range(0, lights.size()).mapToObj(i -> this + "." + word(lights, i)), Stream.of(this + "." + REST)) : Stream.of(toString());
            return layers.flatMap(layer -> channels.stream().map(channel -> layer + "." + channel)).toList();
        }

        /** A light's name if that can stand in the name of a plane, and is nobody else's; else its number from 1. */
        private static String word(List<Light> lights, int light) {
            String name = lights.get(light).name();
            boolean isPlain = !name.isEmpty() && name.length() <= LONGEST_NAME && !name.equals(REST) && name.chars().allMatch(c -> c == ' ' || c == '-' || c == '_' || Character.isLetterOrDigit(c))
                    && !name.chars().allMatch(Character::isDigit);
            return isPlain ? name : Integer.toString(light + 1);
        }

        /** The name as people type it. */
        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }

        /** The layer of that name, in any case. */
        public static Optional<Layer> of(String name) {
            Objects.requireNonNull(name, "name");
            return Stream.of(values()).filter(layer -> layer.name().equalsIgnoreCase(name)).findFirst();
        }
    }
}
