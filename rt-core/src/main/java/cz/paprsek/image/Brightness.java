package cz.paprsek.image;

import cz.paprsek.math.Numbers;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/** Pictures as text: a number for each pixel's brightness, blanks between, an image row a line. */
final class Brightness {
    /** Eight decimals: about what a float near 1 holds. */
    private static final int DECIMALS = 8;
    private static final double UNIT = 1e8;

    private Brightness() {}

    /**
     * The share of each primary in how bright a light looks; linear light, not clamped.
     *
     * @source ITU-R BT.709-6
     */
    static double luminance(Image image, int x, int y) {
        return 0.2126 * image.red(x, y) + 0.7152 * image.green(x, y) + 0.0722 * image.blue(x, y);
    }

    /** The luminance as the sRGB level 0–255 of the grey that is as bright. */
    static int encoded(Image image, int x, int y) {
        return Srgb.encode((float) luminance(image, x, y));
    }

    /** Levels 0–255. */
    static void text(Image image, OutputStream out) throws IOException {
        write(image, out, (x, y, line) -> line.append(encoded(image, x, y)));
    }

    /** Linear luminance, 1 for white, not clamped. */
    static void rawText(Image image, OutputStream out) throws IOException {
        write(image, out, (x, y, line) -> decimal(luminance(image, x, y), line));
    }

    private interface Cell {
        void append(int x, int y, StringBuilder line);
    }

    private static void write(Image image, OutputStream out, Cell cell) throws IOException {
        StringBuilder line = new StringBuilder();
        for (int y = 0; y < image.height(); y++) {
            line.setLength(0);
            for (int x = 0; x < image.width(); x++) {
                if (x > 0) {
                    line.append(' ');
                }
                cell.append(x, y, line);
            }
            out.write(line.append('\n').toString().getBytes(StandardCharsets.US_ASCII));
        }
    }

    /** {@code 0.25}, never {@code 2.5e-1}, and without the locale's comma. */
    private static void decimal(double value, StringBuilder line) {
        if (!(Math.abs(value) < 1e9)) {
            line.append(Numbers.text(value));
            return;
        }
        long units = Math.round(Math.abs(value) * UNIT);
        line.append(value < 0 && units > 0 ? "-" : "").append(units / (long) UNIT);
        String fraction = Long.toString(units % (long) UNIT + (long) UNIT).substring(1);
        int end = DECIMALS;
        while (end > 0 && fraction.charAt(end - 1) == '0') {
            end--;
        }
        line.append(end > 0 ? "." : "").append(fraction, 0, end);
    }
}
