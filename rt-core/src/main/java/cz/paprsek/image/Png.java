package cz.paprsek.image;

import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.image.png.PngHead;
import cz.paprsek.image.png.PngReader;
import cz.paprsek.image.png.PngWriter;
import cz.paprsek.image.png.Stripes;
import cz.paprsek.io.BinaryInput;
import cz.paprsek.material.Rgb;
import java.io.IOException;
import java.io.OutputStream;

/** Pictures as PNG: sRGB-encoded, unless a file that is read says otherwise. */
final class Png {
    private static final int RGB = 2;
    private static final int RGBA = 6;
    /** What a file's gamma is for 1, and for the 1/2.2 that stands for sRGB. */
    private static final double UNIT = 100_000;
    private static final long SRGB = 45_455;

    private Png() {}

    /** @param bits 8 or 16 per channel */
    static void write(Image image, int bits, Origin origin, OutputStream out) throws IOException {
        try (Stripes stripes = stripes(image, bits)) {
            PngWriter.write(origin.texts(), stripes, out);
        }
    }

    /** Its pixels as they are to be written. */
    static Stripes stripes(Image image, int bits) {
        PngWriter.Rows rows = image.isTransparent() ? new Transparent(image, bits) : bits == 8 ? new Rows8(image) : new Rows16(image);
        return new Stripes(new PngHead(image.width(), image.height(), bits, image.isTransparent() ? RGBA : RGB), rows);
    }

    /** @param isOpaque whether opacity is passed over, and the light of a pixel is that of the part it covers */
    static StoredImage read(BinaryInput input, boolean isOpaque) throws IOException {
        PngReader reader = PngReader.of(input);
        return isOpaque || !reader.hasOpacity() ? opaque(reader) : transparent(reader);
    }

    private static StoredImage transparent(PngReader reader) throws IOException {
        ReadLimits.check(reader.head().width(), reader.head().height(), 4);
        Image image = Image.ofTransparent(reader.head().width(), reader.head().height());
        double[] light = light(reader.last(), reader.gamma());
        reader.read((y, x, step, count, rgb, opacity) -> {
            for (int i = 0; i < count; i++) {
                double cover = opacity[i] / (double) reader.last();
                image.set(x + i * step, y, cover * light[rgb[3 * i]], cover * light[rgb[3 * i + 1]], cover * light[rgb[3 * i + 2]], cover);
            }
        });
        return new StoredImage(image, reader.last() > 255 ? Precision.SIXTEEN_BIT : Precision.EIGHT_BIT, reader.isGrey(), power(reader.gamma()));
    }

    private static StoredImage opaque(PngReader reader) throws IOException {
        boolean isEightBit = reader.last() <= 255 && isSrgb(reader.gamma());
        Image image = isEightBit ? ReadLimits.blankOfEightBit(reader.head().width(), reader.head().height())
                : ReadLimits.blank(reader.head().width(), reader.head().height());
        double[] light = light(reader.last(), reader.gamma());
        reader.read((y, x, step, count, rgb, opacity) -> {
            for (int i = 0; i < count; i++) {
                image.set(x + i * step, y, light[rgb[3 * i]], light[rgb[3 * i + 1]], light[rgb[3 * i + 2]]);
            }
        });
        return new StoredImage(image, reader.last() > 255 ? Precision.SIXTEEN_BIT : Precision.EIGHT_BIT, reader.isGrey(), power(reader.gamma()));
    }

    /**
     * The light that each sample stands for.
     *
     * @source PNG Specification (Third Edition), 11.3.2.2 gAMA
     */
    private static double[] light(int last, long gamma) {
        double[] light = new double[last + 1];
        for (int i = 0; i <= last; i++) {
            double sample = i / (double) last;
            light[i] = isSrgb(gamma) ? Rgb.linear(255 * sample) : StrictMath.pow(sample, power(gamma));
        }
        return light;
    }

    private static double power(long gamma) {
        return isSrgb(gamma) ? StoredImage.SRGB : UNIT / gamma;
    }

    private static boolean isSrgb(long gamma) {
        return gamma <= 0 || gamma == SRGB;
    }

    // Not lambdas: pictures are written at the end of many a short process, which would pay for making them.
    private record Rows8(Image image) implements PngWriter.Rows {
        @Override
        public void copy(int y, byte[] into, int at) {
            int i = at;
            float red = 0;
            float green = 0;
            float blue = 0;
            int encoded = 0;
            for (int x = 0; x < image.width(); x++) {
                // Neighbours are often alike.
                if (image.red(x, y) != red || image.green(x, y) != green || image.blue(x, y) != blue) {
                    red = image.red(x, y);
                    green = image.green(x, y);
                    blue = image.blue(x, y);
                    encoded = image.argb(x, y);
                }
                into[i++] = (byte) (encoded >> 16);
                into[i++] = (byte) (encoded >> 8);
                into[i++] = (byte) encoded;
            }
        }
    }

    private record Rows16(Image image) implements PngWriter.Rows {
        @Override
        public void copy(int y, byte[] into, int at) {
            int i = at;
            for (int x = 0; x < image.width(); x++) {
                i = put(Srgb16.encode(image.red(x, y)), into, i);
                i = put(Srgb16.encode(image.green(x, y)), into, i);
                i = put(Srgb16.encode(image.blue(x, y)), into, i);
            }
        }

    }

    /** With opacity, which PNG wants beside the light of the covered part, not multiplied into it. */
    private record Transparent(Image image, int bits) implements PngWriter.Rows {
        private static final int LAST16 = 65_535;

        @Override
        public void copy(int y, byte[] into, int at) {
            int i = at;
            for (int x = 0; x < image.width(); x++) {
                if (bits == 8) {
                    int encoded = image.argb(x, y);
                    i = put(encoded >> 8, into, i);
                    into[i++] = (byte) encoded;
                    into[i++] = (byte) (encoded >> 24);
                } else {
                    float cover = image.alpha(x, y);
                    i = put(Srgb16.encode(Image.whole(image.red(x, y), cover)), into, i);
                    i = put(Srgb16.encode(Image.whole(image.green(x, y), cover)), into, i);
                    i = put(Srgb16.encode(Image.whole(image.blue(x, y), cover)), into, i);
                    i = put(Math.round(LAST16 * cover), into, i);
                }
            }
        }
    }

    private static int put(int value, byte[] into, int at) {
        into[at] = (byte) (value >> 8);
        into[at + 1] = (byte) value;
        return at + 2;
    }
}
