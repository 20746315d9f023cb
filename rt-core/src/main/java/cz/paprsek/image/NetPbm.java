package cz.paprsek.image;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * The plain formats of measuring people: a line or three of text, then the bare numbers.
 *
 * @source netpbm.sourceforge.net/doc/ppm.html, pgm.html, pfm.html
 */
final class NetPbm {
    private NetPbm() {}

    static void ppm(Image image, OutputStream out) throws IOException {
        header(out, "P6", image, "255");
        byte[] row = new byte[3 * image.width()];
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                int argb = image.argb(x, y);
                row[3 * x] = (byte) (argb >> 16);
                row[3 * x + 1] = (byte) (argb >> 8);
                row[3 * x + 2] = (byte) argb;
            }
            out.write(row);
        }
    }

    /** Linear light; most significant byte first, as the format wants it. */
    static void ppm16(Image image, OutputStream out) throws IOException {
        header(out, "P6", image, "65535");
        ByteBuffer row = ByteBuffer.allocate(6 * image.width());
        for (int y = 0; y < image.height(); y++) {
            row.clear();
            for (int x = 0; x < image.width(); x++) {
                row.putShort(step(image.red(x, y))).putShort(step(image.green(x, y))).putShort(step(image.blue(x, y)));
            }
            out.write(row.array());
        }
    }

    static void pgm(Image image, OutputStream out) throws IOException {
        header(out, "P5", image, "255");
        byte[] row = new byte[image.width()];
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < row.length; x++) {
                row[x] = (byte) Brightness.encoded(image, x, y);
            }
            out.write(row);
        }
    }

    /** Bottom row first; the negative scale in the header says least significant byte first. */
    static void pfm(Image image, OutputStream out) throws IOException {
        header(out, "PF", image, "-1.0");
        ByteBuffer row = ByteBuffer.allocate(12 * image.width()).order(ByteOrder.LITTLE_ENDIAN);
        for (int y = image.height() - 1; y >= 0; y--) {
            row.clear();
            for (int x = 0; x < image.width(); x++) {
                row.putFloat(image.red(x, y)).putFloat(image.green(x, y)).putFloat(image.blue(x, y));
            }
            out.write(row.array());
        }
    }

    private static void header(OutputStream out, String kind, Image image, String range) throws IOException {
        out.write((kind + "\n" + image.width() + " " + image.height() + "\n" + range + "\n").getBytes(StandardCharsets.US_ASCII));
    }

    /** Light 0–1 as one of 65536 steps; clamped. Not a number gives 0. */
    private static short step(float light) {
        return (short) (light > 0 ? Math.round(Math.min(light, 1.0) * 65535) : 0);
    }
}
