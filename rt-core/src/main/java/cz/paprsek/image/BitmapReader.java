package cz.paprsek.image;

import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.io.BinaryInput;
import cz.paprsek.material.Rgb;
import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/** Reads the formats that are left to the Java platform: JPEG, BMP, TIFF, GIF. Samples are sRGB; opacity is ignored. */
final class BitmapReader {
    private BitmapReader() {}

    static StoredImage read(BinaryInput input) throws IOException {
        byte[] start = input.peek(4);
        if (!isKnown(start)) {
            throw new IOException("this is not a picture of a kind that can be read");
        }
        byte[] file = input.rest();
        if (JpegHead.canRead(start)) {
            JpegHead.check(file);
        }
        // A stream that caches in memory: ImageIO's own may open files in the temporary folder.
        try (ImageInputStream stream = new MemoryCacheImageInputStream(new ByteArrayInputStream(file))) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(stream);
            if (!readers.hasNext()) {
                throw new IOException("this is not a picture of a kind that can be read");
            }
            ImageReader reader = readers.next();
            try {
                reader.setInput(stream);
                return read(reader);
            } finally {
                reader.dispose();
            }
        } catch (RuntimeException broken) {
            // The platform's readers are written for good files; of damaged ones they throw what they stumble over, in words of their own.
            throw new IOException("the picture is damaged", broken);
        } catch (IOException refused) {
            throw new IOException(PlainSentence.of(refused), refused);
        }
    }

    /** Whether a file begins like JPEG, BMP, TIFF or GIF: others, though endless, need not be read to the end. */
    private static boolean isKnown(byte[] start) {
        if (start.length < 4) {
            return false;
        }
        int two = (start[0] & 0xFF) << 8 | (start[1] & 0xFF);
        return two == 0xFFD8 || two == (('B' << 8) | 'M') || two == (('I' << 8) | 'I') || two == (('M' << 8) | 'M') || two == (('G' << 8) | 'I');
    }

    private static StoredImage read(ImageReader reader) throws IOException {
        // Before the pixels are unpacked: a few bytes may claim a picture that no memory holds.
        int width = reader.getWidth(0);
        int height = reader.getHeight(0);
        ReadLimits.check(width, height, 3);
        BufferedImage pixels = reader.read(0);
        if (pixels.getWidth() != width || pixels.getHeight() != height) {
            throw new IOException("the picture is damaged: it is of two sizes");
        }
        if (pixels.getColorModel() instanceof IndexColorModel) {
            return new StoredImage(indexed(pixels, Image.ofEightBit(width, height)), Precision.EIGHT_BIT, false);
        }
        Raster raster = pixels.getRaster();
        int bits = raster.getSampleModel().getSampleSize(0);
        if (bits != 8 && bits != 16) {
            throw new IOException("the picture has " + bits + " bits per channel; 8 and 16 can be read");
        }
        Image image = bits == 8 ? Image.ofEightBit(width, height) : new Image(width, height);
        double[] light = light(bits);
        boolean isGrey = raster.getNumBands() < 3;
        int green = isGrey ? 0 : 1;
        int blue = isGrey ? 0 : 2;
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                image.set(x, y, light[raster.getSample(x, y, 0)], light[raster.getSample(x, y, green)], light[raster.getSample(x, y, blue)]);
            }
        }
        return new StoredImage(image, bits == 8 ? Precision.EIGHT_BIT : Precision.SIXTEEN_BIT, isGrey);
    }

    private static Image indexed(BufferedImage pixels, Image image) {
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                int rgb = pixels.getRGB(x, y);
                image.set(x, y, Rgb.linear(rgb >> 16 & 0xFF), Rgb.linear(rgb >> 8 & 0xFF), Rgb.linear(rgb & 0xFF));
            }
        }
        return image;
    }

    /** The light that each sample stands for. */
    private static double[] light(int bits) {
        double[] light = new double[1 << bits];
        for (int i = 0; i < light.length; i++) {
            light[i] = Rgb.linear(i * 255.0 / (light.length - 1));
        }
        return light;
    }
}
