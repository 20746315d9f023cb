package cz.paprsek.image;

import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.image.exr.ExrReader;
import cz.paprsek.image.png.PngReader;
import cz.paprsek.image.png.PngWriter;
import cz.paprsek.image.png.Stripes;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.BinaryInput;
import cz.paprsek.io.Failures;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.math.Require;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/** Writes pictures to files, each as a whole or not at all, and reads them. */
public final class ImageFiles {
    private ImageFiles() {}

    /**
     * Writes a picture in the format that the file's name ends with; PNG if it has no ending.
     *
     * @throws IllegalArgumentException if it has an ending that no format here has
     */
    public static void write(Image image, Path file) throws IOException {
        write(image, file, ImageOptions.DEFAULT);
    }

    /**
     * As above, with wishes how.
     *
     * @throws IllegalArgumentException also if the format cannot have as many bits per channel, or no opacity that the picture has
     */
    public static void write(Image image, Path file, ImageOptions options) throws IOException {
        String name = String.valueOf(file.getFileName());
        int dot = name.lastIndexOf('.');
        Optional<ImageFormat> format = dot > 0 ? ImageFormat.ofFile(name) : Optional.of(ImageFormat.PNG);
        write(image, file, format.orElseThrow(() -> new IllegalArgumentException(file + ": there is no picture format \"" + name.substring(dot + 1)
                + "\" here; the ending should be one of " + ImageFormat.all())), options);
    }

    /**
     * Writes a picture beside the file and then moves it into its place, so that nobody ever sees half a picture. An old file's
     * permissions are kept.
     */
    public static void write(Image image, Path file, ImageFormat format) throws IOException {
        Objects.requireNonNull(image, "image");
        Objects.requireNonNull(format, "format");
        AtomicFile.write(file, out -> write(image, out, format));
    }

    /**
     * As above, with wishes how.
     *
     * @throws IllegalArgumentException if the format cannot have as many bits per channel
     */
    public static void write(Image image, Path file, ImageFormat format, ImageOptions options) throws IOException {
        Objects.requireNonNull(image, "image");
        options.bitsOf(format);
        AtomicFile.write(file, out -> write(image, out, format, options));
    }

    /**
     * Writes a picture and what else is known of its pixels to an OpenEXR file, which appears as a whole.
     *
     * @throws IllegalArgumentException if there are no planes, or the options ask for other than 16 or 32 bits, or for a change of exposure or tone
     */
    public static void write(Layers layers, Path file, ImageOptions options) throws IOException {
        options.bitsOf(ImageFormat.EXR);
        Require.that(!layers.names().isEmpty(), "these layers have no planes, of which a picture has one at least");
        Require.that(options.exposure() == 0 && options.tone() == Tone.NONE, "layers are written as they are: no exposure, no tone");
        AtomicFile.write(file, out -> Exr.write(layers, options, out));
    }

    /**
     * Writes a picture and, beside it, layers of what else is known of its pixels to an OpenEXR file, which appears as a whole. Exposure and tone are those of
     * the picture; what is no light is written in 32 bits whatever the options say.
     *
     * @throws IllegalArgumentException if sizes differ, a plane is called as one of the picture's, or the options ask for other than 16 or 32 bits
     */
    public static void write(Image image, Layers further, Path file, ImageOptions options) throws IOException {
        Objects.requireNonNull(image, "image");
        options.bitsOf(ImageFormat.EXR);
        Exr.check(image, further);
        AtomicFile.write(file, out -> write(image, further, out, options));
    }

    /** As above, to a stream, which is not closed. */
    public static void write(Image image, Layers further, OutputStream out, ImageOptions options) throws IOException {
        Exr.check(image, further);
        Exr.write(options.develop(image), further, options, out);
        out.flush();
    }

    /** Writes a picture to a stream, which is not closed. */
    public static void write(Image image, OutputStream out, ImageFormat format) throws IOException {
        write(image, out, format, ImageOptions.DEFAULT);
    }

    /** Writes a picture to a stream, which is not closed, with wishes how. */
    public static void write(Image image, OutputStream out, ImageFormat format, ImageOptions options) throws IOException {
        Objects.requireNonNull(image, "image");
        Objects.requireNonNull(out, "out");
        int bits = options.bitsOf(format);
        Require.that(format.isTransparent() || !image.isTransparent(), format.extension() + " has no opacity, which this picture has; png and exr have");
        Image developed = options.develop(image);
        Origin origin = options.origin();
        switch (format) {
            case PNG -> Png.write(developed, bits, origin, out);
            case JPG, BMP, TIF -> Bitmaps.write(developed, format, origin, out);
            case PPM -> Netpbm.ppm(developed, origin, out);
            case PPM16 -> Netpbm.ppm16(developed, origin, out);
            case PGM -> Netpbm.pgm(developed, origin, out);
            case PFM -> Netpbm.pfm(developed, out);
            case TXT -> Brightness.encoded(developed, out);
            case RAW -> Brightness.linear(developed, out);
            case HDR -> Radiance.write(developed, origin, out);
            case EXR -> Exr.write(developed, options, out);
        }
        out.flush();
    }

    /** Reads a picture into linear light; see {@link #readStored}. */
    public static Image read(Path file) throws IOException {
        return readStored(file).image();
    }

    /**
     * Reads a picture of any kind that is written here, and others that the platform knows. What it is, is told by its first bytes; text by
     * the ending of its name. Samples are taken as sRGB if the file does not say otherwise; 16 bits of a PPM as linear light if a comment in
     * its head says {@code linear light}, as in ours, if its name ends in {@code .ppm16}, or if POV-Ray wrote it, which does not say.
     *
     * @throws IOException naming the file and what is wrong with it
     */
    public static StoredImage readStored(Path file) throws IOException {
        ImageFormat ending = ImageFormat.ofFile(file.toString()).orElse(ImageFormat.PNG);
        return read(file, input -> read(input, ending, true));
    }

    /**
     * Reads all planes of an OpenEXR file.
     *
     * @throws IOException naming the file and what is wrong with it
     */
    public static Layers readLayers(Path file) throws IOException {
        return read(file, Exr::readLayers);
    }

    /**
     * All planes of a picture if it is an OpenEXR file, which is told as in {@link #readStored(Path)}, whatever its name; empty if it is another picture.
     *
     * @throws IOException naming the file and what is wrong with it
     */
    public static Optional<Layers> findLayers(Path file) throws IOException {
        boolean isText = ImageFormat.ofFile(file.toString()).filter(ending -> ending == ImageFormat.TXT || ending == ImageFormat.RAW).isPresent();
        return isText ? Optional.empty() : read(file, input -> ExrReader.canRead(input.peek(16)) ? Optional.of(Exr.readLayers(input)) : Optional.empty());
    }

    private interface Reading<T> {
        T read(BinaryInput input) throws IOException;
    }

    private static <T> T read(Path file, Reading<T> reading) throws IOException {
        long size = Files.isRegularFile(file) ? Files.size(file) : Long.MAX_VALUE;
        try (BinaryInput input = new BinaryInput(Files.newInputStream(file), size, ReadLimits.bytes())) {
            return reading.read(input);
        } catch (FileSystemException e) {
            throw e;
        } catch (IOException | IllegalArgumentException unreadable) {
            throw new IOException(file + ": " + Failures.sentence(unreadable), unreadable);
        } catch (OutOfMemoryError tooLarge) {
            throw new IOException(file + ": not enough memory for this picture; give Java more with -Xmx", tooLarge);
        }
    }

    /**
     * As {@link #readStored(Path)}, of a file that is in memory already.
     *
     * @param name of the file, whose ending tells text
     * @throws IOException saying what is wrong with the content, without the name
     */
    public static StoredImage readStored(byte[] content, String name) throws IOException {
        return read(content, name, true);
    }

    /** As {@link #readStored(byte[], String)}, with opacity if it is a PNG that has any. */
    public static StoredImage readWithOpacity(byte[] content, String name) throws IOException {
        return read(content, name, false);
    }

    private static StoredImage read(byte[] content, String name, boolean isOpaque) throws IOException {
        try (BinaryInput input = new BinaryInput(new ByteArrayInputStream(content), content.length, ReadLimits.bytes())) {
            return read(input, ImageFormat.ofFile(name).orElse(ImageFormat.PNG), isOpaque);
        } catch (IllegalArgumentException unreadable) {
            throw new IOException(unreadable.getMessage(), unreadable);
        } catch (OutOfMemoryError tooLarge) {
            throw new IOException("not enough memory for this picture; give Java more with -Xmx", tooLarge);
        }
    }

    private static StoredImage read(BinaryInput input, ImageFormat ending, boolean isOpaque) throws IOException {
        byte[] start = input.peek(16);
        if (ending == ImageFormat.TXT) {
            return BrightnessReader.encoded(input.rest());
        }
        if (ending == ImageFormat.RAW) {
            return BrightnessReader.linear(input.rest());
        }
        if (PngReader.canRead(start)) {
            return Png.read(input, isOpaque);
        }
        if (ExrReader.canRead(start)) {
            return Exr.read(input);
        }
        if (RadianceReader.canRead(start)) {
            return RadianceReader.read(input);
        }
        return NetpbmReader.canRead(start) ? NetpbmReader.read(input, ending == ImageFormat.PPM16) : BitmapReader.read(input);
    }

    /** A picture under way that is to be a PNG: rows are compressed by other threads as soon as they are complete, so that little is left to do in the end. The file is the same. */
    public static final class GrowingPng implements AutoCloseable {
        private final Image image;
        private final int bits;
        private final Stripes stripes;
        /** How many pixels of each row are complete. */
        private final int[] pixels;
        private int rows;

        /** @param bits 8 or 16 per channel */
        public GrowingPng(Image image, int bits) {
            this.image = image;
            this.bits = ImageOptions.DEFAULT.withBits(bits).bitsOf(ImageFormat.PNG);
            stripes = Png.stripes(image, bits);
            pixels = new int[image.height()];
        }

        /** Takes note that some pixels will no longer change: in so many rows from y on so many of each, none of which was told before. */
        public synchronized void finished(int y, int width, int height) {
            for (int row = y; row < y + height; row++) {
                pixels[row] += width;
            }
            while (rows < pixels.length && pixels[rows] == image.width()) {
                rows++;
            }
            stripes.begin(rows);
        }

        /** Whether it is this picture that is to be written, and as it is. */
        public boolean isOf(Image other, ImageOptions options) {
            return other == image && options.bitsOf(ImageFormat.PNG) == bits && options.exposure() == 0 && options.tone() == Tone.NONE;
        }

        /** Writes the picture, which is complete, as {@link #write(Image, Path, ImageFormat, ImageOptions)} does; once only. */
        public synchronized void write(Path file, ImageOptions options) throws IOException {
            AtomicFile.write(file, out -> {
                PngWriter.write(options.origin().texts(), stripes, out);
                out.flush();
            });
        }

        /** Ends what is under way. */
        @Override
        public void close() {
            stripes.close();
        }
    }
}
