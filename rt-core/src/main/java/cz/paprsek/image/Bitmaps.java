package cz.paprsek.image;

import cz.paprsek.image.ImageOptions.Origin;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Locale;
import javax.imageio.IIOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataFormatImpl;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** The formats that the Java platform writes. */
final class Bitmaps {
    private static final float JPEG_QUALITY = 0.95f;

    private Bitmaps() {}

    static void write(Image image, ImageFormat format, Origin origin, OutputStream out) throws IOException {
        ImageWriter writer = ImageIO.getImageWritersByFormatName(format == ImageFormat.TIF ? "tiff" : format.name().toLowerCase(Locale.ROOT)).next();
        // A stream that caches in memory: ImageIO's own may open files in the temporary folder.
        try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
            ImageWriteParam settings = writer.getDefaultWriteParam();
            if (format == ImageFormat.JPG) {
                settings.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
                settings.setCompressionQuality(JPEG_QUALITY);
            }
            if (format == ImageFormat.TIF) {
                settings.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
                settings.setCompressionType("Deflate");
            }
            writer.setOutput(stream);
            BufferedImage pixels = image.toBufferedImage();
            IIOMetadata told = writer.getDefaultImageMetadata(new ImageTypeSpecifier(pixels), settings);
            if (format != ImageFormat.BMP && !origin.lines().isEmpty()) {
                tell(String.join("\n", origin.lines()), told);
            }
            writer.write(null, new IIOImage(pixels, null, told), settings);
        } catch (IIOException vague) {
            // The platform says that there was an "I/O error writing PNG file!", and why in its cause only.
            throw vague.getCause() instanceof IOException reason ? reason : vague;
        } finally {
            writer.dispose();
        }
    }

    /** JPEG makes a comment of it, TIFF the picture's description. */
    private static void tell(String text, IIOMetadata told) throws IOException {
        IIOMetadataNode entry = new IIOMetadataNode("TextEntry");
        entry.setAttribute("keyword", "ImageDescription");
        entry.setAttribute("value", text);
        IIOMetadataNode texts = new IIOMetadataNode("Text");
        texts.appendChild(entry);
        IIOMetadataNode root = new IIOMetadataNode(IIOMetadataFormatImpl.standardMetadataFormatName);
        root.appendChild(texts);
        told.mergeTree(IIOMetadataFormatImpl.standardMetadataFormatName, root);
    }
}
