package cz.paprsek.image;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.io.OutputStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** The formats that the JDK's ImageIO writes. */
final class Bitmaps {
    private static final float JPEG_QUALITY = 0.95f;

    private Bitmaps() {}

    static void write(Image image, OutputStream out, ImageFormat format) throws IOException {
        ImageWriter writer = ImageIO.getImageWritersBySuffix(format.extension()).next();
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
            writer.setOutput(stream);
            writer.write(null, new IIOImage(pixels(image, format), null, null), settings(writer, format));
        } finally {
            writer.dispose();
        }
    }

    /** TIFF, BMP and JPEG want the bytes one by one: a pixel in one int makes them write four bytes or convert. */
    private static BufferedImage pixels(Image image, ImageFormat format) {
        if (format == ImageFormat.PNG) {
            return image.toBufferedImage();
        }
        BufferedImage bytes = new BufferedImage(image.width(), image.height(), BufferedImage.TYPE_3BYTE_BGR);
        byte[] data = ((DataBufferByte) bytes.getRaster().getDataBuffer()).getData();
        int i = 0;
        for (int argb : image.toArgb()) {
            data[i++] = (byte) argb;
            data[i++] = (byte) (argb >> 8);
            data[i++] = (byte) (argb >> 16);
        }
        return bytes;
    }

    private static ImageWriteParam settings(ImageWriter writer, ImageFormat format) {
        ImageWriteParam settings = writer.getDefaultWriteParam();
        if (format == ImageFormat.JPEG) {
            settings.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            settings.setCompressionQuality(JPEG_QUALITY);
        }
        if (format == ImageFormat.TIFF) {
            settings.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            settings.setCompressionType("LZW");
        }
        return settings;
    }
}
