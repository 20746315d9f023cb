package cz.paprsek.image;

import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.material.Rgb;
import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Iterator;
import java.util.function.DoubleUnaryOperator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** Reads the formats that the Java platform reads, PNG above all. Samples are sRGB unless a PNG says otherwise; opacity is ignored. */
final class BitmapReader {
    private static final String PNG = "javax_imageio_png_1.0";
    /** What a PNG's gAMA chunk holds for 1, and for the 1/2.2 that stands for sRGB. */
    private static final double UNIT = 100_000;
    private static final double SRGB = 45_455;

    private BitmapReader() {}

    static StoredImage read(byte[] file) throws IOException {
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
            // The platform's readers are written for good files; of damaged ones they throw what they stumble over.
            throw new IOException("the picture is damaged: " + broken.getMessage(), broken);
        }
    }

    private static StoredImage read(ImageReader reader) throws IOException {
        // Before the pixels are unpacked: a few bytes may claim a picture that no memory holds.
        Image image = new Image(reader.getWidth(0), reader.getHeight(0));
        BufferedImage pixels = reader.read(0);
        if (pixels.getColorModel() instanceof IndexColorModel) {
            return new StoredImage(indexed(pixels, image), Precision.EIGHT_BIT, false);
        }
        Raster raster = pixels.getRaster();
        int bits = raster.getSampleModel().getSampleSize(0);
        if (bits != 8 && bits != 16) {
            throw new IOException("the picture has " + bits + " bits per channel; 8 and 16 can be read");
        }
        double[] light = light(bits, reader.getImageMetadata(0));
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
    private static double[] light(int bits, IIOMetadata metadata) {
        double[] light = new double[1 << bits];
        DoubleUnaryOperator decoding = decoding(metadata);
        for (int i = 0; i < light.length; i++) {
            light[i] = decoding.applyAsDouble(i / (double) (light.length - 1));
        }
        return light;
    }

    /** @source PNG Specification (Third Edition), 11.3.2.2 gAMA */
    private static DoubleUnaryOperator decoding(IIOMetadata metadata) {
        if (PNG.equals(metadata.getNativeMetadataFormatName()) && metadata.getAsTree(PNG) instanceof Element root) {
            NodeList gammas = root.getElementsByTagName("gAMA");
            if (root.getElementsByTagName("sRGB").getLength() == 0 && gammas.item(0) instanceof Element chunk) {
                double gamma = Double.parseDouble(chunk.getAttribute("value"));
                if (gamma > 0 && gamma != SRGB) {
                    return sample -> StrictMath.pow(sample, UNIT / gamma);
                }
            }
        }
        return sample -> Rgb.linear(255 * sample);
    }
}
