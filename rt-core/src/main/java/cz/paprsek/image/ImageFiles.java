package cz.paprsek.image;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;

/** Writes pictures to files, each of which appears whole or not at all. */
public final class ImageFiles {
    private ImageFiles() {}

    /**
     * Writes a picture in the format that the file's ending stands for.
     *
     * @throws IllegalArgumentException if it stands for none
     * @throws IOException if the file cannot be written; an old file of that name is then still there, whole
     */
    public static void write(Image image, Path file) throws IOException {
        write(image, file, ImageFormat.of(file).orElseThrow(() -> new IllegalArgumentException(
                file + ": a picture's file name must end in one of " + ImageFormat.knownEndings())));
    }

    /**
     * Writes a picture in the given format, whatever the file's name.
     *
     * @throws IOException if the file cannot be written, or the thread is interrupted meanwhile; an old file of that name is then
     *     still there, whole
     */
    public static void write(Image image, Path file, ImageFormat format) throws IOException {
        WholeFile.write(file, out -> write(image, out, format));
    }

    /** Writes a picture to a stream, which is flushed but not closed. */
    public static void write(Image image, OutputStream out, ImageFormat format) throws IOException {
        switch (format) {
            case PNG, JPEG, BMP, TIFF -> Bitmaps.write(image, out, format);
            case PPM -> NetPbm.ppm(image, out);
            case PPM16 -> NetPbm.ppm16(image, out);
            case PGM -> NetPbm.pgm(image, out);
            case PFM -> NetPbm.pfm(image, out);
            case TEXT -> Brightness.text(image, out);
            case RAW_TEXT -> Brightness.rawText(image, out);
        }
        out.flush();
    }
}
