package cz.paprsek.image;

import cz.paprsek.image.ImageOptions.Origin;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * The portable map formats.
 *
 * @source Netpbm, ppm(5), pgm(5); Debevec, PFM
 */
final class Netpbm {
    /** The comment by which a map of linear light is told from the sRGB that everybody expects in it. */
    static final String LINEAR = "linear light";

    private Netpbm() {}

    static void ppm(Image image, Origin origin, OutputStream out) throws IOException {
        header(out, "P6" + comments(origin), image, "255");
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

    /** Linear light, clamped to 0–1, in 65535 steps, high byte first: what POV-Ray writes with a file gamma of 1; the head says so. */
    static void ppm16(Image image, Origin origin, OutputStream out) throws IOException {
        header(out, "P6\n# " + LINEAR + comments(origin), image, "65535");
        ByteBuffer row = ByteBuffer.allocate(6 * image.width()).order(ByteOrder.BIG_ENDIAN);
        for (int y = 0; y < image.height(); y++) {
            row.clear();
            for (int x = 0; x < image.width(); x++) {
                row.putShort(step(image.red(x, y))).putShort(step(image.green(x, y))).putShort(step(image.blue(x, y)));
            }
            out.write(row.array());
        }
    }

    static void pgm(Image image, Origin origin, OutputStream out) throws IOException {
        header(out, "P5" + comments(origin), image, "255");
        byte[] row = new byte[image.width()];
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                row[x] = (byte) Brightness.of(image, x, y);
            }
            out.write(row);
        }
    }

    /** Linear light, unclamped, low byte first, the bottom row first. */
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

    private static short step(float light) {
        return (short) Math.round(Math.min(1f, Math.max(0f, light)) * 65535f);
    }

    private static String comments(Origin origin) {
        StringBuilder comments = new StringBuilder();
        origin.lines().forEach(line -> comments.append("\n# ").append(line));
        return comments.toString();
    }

    private static void header(OutputStream out, String magic, Image image, String last) throws IOException {
        out.write((magic + "\n" + image.width() + " " + image.height() + "\n" + last + "\n").getBytes(StandardCharsets.US_ASCII));
    }
}
