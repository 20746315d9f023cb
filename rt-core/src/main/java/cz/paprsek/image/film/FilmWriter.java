package cz.paprsek.image.film;

import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.png.PngFilm;
import cz.paprsek.image.png.PngHead;
import cz.paprsek.math.Require;
import cz.paprsek.text.Numbers;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.function.IntBinaryOperator;

/** Writes pictures that are to be shown one after the other into one file, in the order in which they come. */
public final class FilmWriter {
    /** PNG's number for colours without opacity. */
    private static final int RGB = 2;

    private final int width;
    private final int height;
    private final int frames;
    private final ImageOptions options;
    private final OutputStream out;
    private final Kind kind;
    private int added;

    /** What such a file can be. */
    public enum Format {
        /** 8-bit sRGB, lossless; one picture to those who know PNG only. */
        APNG,
        /** 256 colours a picture. */
        GIF,
        /** Uncompressed, for programs that make videos. */
        Y4M;

        /** The ending of such a file's name, without a dot. */
        public String extension() {
            return name().toLowerCase(Locale.ROOT);
        }

        /** The format of that name, upper or lower case. */
        public static Optional<Format> of(String name) {
            Objects.requireNonNull(name, "name");
            return Arrays.stream(values()).filter(format -> format.name().equalsIgnoreCase(name)).findFirst();
        }

        /** The format that a file's name ends with. */
        public static Optional<Format> ofFile(String fileName) {
            return of(fileName.substring(fileName.lastIndexOf('.') + 1)).filter(format -> fileName.indexOf('.') >= 0);
        }

        /** @throws IllegalArgumentException if it cannot show so many pictures a second */
        public void check(double fps) {
            Require.that(this != GIF || fps <= GifWriter.MOST_FPS, "gif shows " + Numbers.text(GifWriter.MOST_FPS) + " pictures a second at most, not " + Numbers.text(fps)
                    + "; apng and y4m show more");
        }
    }

    /** How one format is written. */
    private interface Kind {
        void add(Image image, ImageOptions how) throws IOException;

        void end() throws IOException;
    }

    @FunctionalInterface
    private interface PixelWriter {
        void add(int[] pixels) throws IOException;
    }

    @FunctionalInterface
    private interface Ending {
        void end() throws IOException;
    }

    /**
     * Writes the head of a film.
     *
     * @param fps pictures a second
     * @param frames how many there will be
     * @param options exposure, tone and origin of the pictures; only apng can say where they come from
     * @param out is not closed
     * @throws IllegalArgumentException if the format cannot show so many pictures a second
     */
    public FilmWriter(Format format, int width, int height, double fps, int frames, ImageOptions options, OutputStream out) throws IOException {
        Objects.requireNonNull(out, "out");
        Require.that(frames > 0, "a film must have a picture at least");
        format.check(fps);
        this.width = width;
        this.height = height;
        this.frames = frames;
        this.options = options;
        this.out = out;
        this.kind = switch (format) {
            case APNG -> apng(FrameRate.of(fps));
            case GIF -> {
                GifWriter film = new GifWriter(out, width, height, fps);
                yield plain(film::add, film::end);
            }
            // It has no mark for its end.
            case Y4M -> plain(new Y4mWriter(out, width, height, FrameRate.of(fps))::add, () -> {});
        };
    }

    private Kind apng(FrameRate rate) throws IOException {
        PngFilm film = new PngFilm(new PngHead(width, height, 8, RGB), frames, rate.seconds(), rate.frames(), options.origin().texts(), out);
        return new Kind() {
            @Override
            public void add(Image image, ImageOptions how) throws IOException {
                IntBinaryOperator shown = how.shown(image);
                film.add((y, into, at) -> {
                    int i = at;
                    for (int x = 0; x < width; x++) {
                        int color = shown.applyAsInt(x, y);
                        into[i++] = (byte) (color >> 16);
                        into[i++] = (byte) (color >> 8);
                        into[i++] = (byte) color;
                    }
                });
            }

            @Override
            public void end() throws IOException {
                film.end();
            }
        };
    }

    /** A format whose pictures are colours as they are shown. */
    private Kind plain(PixelWriter film, Ending ending) {
        return new Kind() {
            @Override
            public void add(Image image, ImageOptions how) throws IOException {
                film.add(pixels(image, how));
            }

            @Override
            public void end() throws IOException {
                ending.end();
            }
        };
    }

    private int[] pixels(Image image, ImageOptions how) {
        IntBinaryOperator shown = how.shown(image);
        int[] pixels = new int[width * height];
        for (int i = 0; i < pixels.length; i++) {
            pixels[i] = shown.applyAsInt(i % width, i / width) & 0xFFFFFF;
        }
        return pixels;
    }

    /**
     * Adds the next picture.
     *
     * @throws IllegalArgumentException if it has another size, or opacity
     */
    public void add(Image image) throws IOException {
        add(image, options);
    }

    /**
     * Adds the next picture.
     *
     * @param how its own exposure and tone; what it tells of its origin is the film's
     * @throws IllegalArgumentException as {@link #add(Image)}
     */
    public void add(Image image, ImageOptions how) throws IOException {
        Objects.requireNonNull(how, "how");
        Require.that(image.width() == width && image.height() == height, "all pictures of a film must be of " + width + "x" + height + " pixels, but here is one of "
                + image.width() + "x" + image.height());
        Require.that(!image.isTransparent(), "the pictures of a film have no opacity, which this picture has");
        Require.that(added < frames, "a film of " + frames + " pictures cannot have more");
        kind.add(image, how);
        added++;
        out.flush();
    }

    /**
     * Writes the end.
     *
     * @throws IllegalStateException if there are fewer pictures than were said
     */
    public void end() throws IOException {
        if (added != frames) {
            throw new IllegalStateException("a film of " + frames + " pictures has been given " + added);
        }
        kind.end();
        out.flush();
    }
}
