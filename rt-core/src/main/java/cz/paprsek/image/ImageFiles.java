package cz.paprsek.image;

import cz.paprsek.io.AtomicFile;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;

/** Writes pictures to files, each as a whole or not at all. */
public final class ImageFiles {
    private ImageFiles() {}

    /** Writes a picture in the format that the file's name ends with; PNG if it ends with none we know. */
    public static void write(Image image, Path file) throws IOException {
        write(image, file, ImageFormat.ofFile(file.toString()).orElse(ImageFormat.PNG));
    }

    /**
     * Writes a picture beside the file and then moves it into its place, so that nobody ever sees half a picture. An old file's
     * permissions are kept.
     */
    public static void write(Image image, Path file, ImageFormat format) throws IOException {
        AtomicFile.write(file, out -> write(image, out, format));
    }

    /** Writes a picture to a stream, which is not closed. */
    public static void write(Image image, OutputStream out, ImageFormat format) throws IOException {
        switch (format) {
            case PNG, JPG, BMP, TIF -> Bitmaps.write(image, out, format);
            case PPM -> Netpbm.ppm(image, out);
            case PPM16 -> Netpbm.ppm16(image, out);
            case PGM -> Netpbm.pgm(image, out);
            case PFM -> Netpbm.pfm(image, out);
            case TXT -> Brightness.encoded(image, out);
            case RAW -> Brightness.linear(image, out);
        }
        out.flush();
    }
}
