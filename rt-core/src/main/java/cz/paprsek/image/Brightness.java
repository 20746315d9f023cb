package cz.paprsek.image;

import cz.paprsek.text.Numbers;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/**
 * The brightness of pixels, as text: one image row a line, values separated by a blank.
 *
 * @source ITU-R BT.709 for the weights of the channels
 */
final class Brightness {
    private static final long UNIT = 100_000_000;

    private Brightness() {}

    /** Brightness 0–255: luminance, sRGB-encoded. */
    static int of(Image image, int x, int y) {
        return Srgb.encode((float) luminance(image, x, y));
    }

    static void encoded(Image image, OutputStream out) throws IOException {
        write(image, out, (x, y) -> Integer.toString(of(image, x, y)));
    }

    /** Luminance in linear light, unclamped, to eight decimals: about what a float near 1 holds. */
    static void linear(Image image, OutputStream out) throws IOException {
        write(image, out, (x, y) -> decimal(luminance(image, x, y)));
    }

    /** {@code 0.25}, never {@code 2.5e-1}: not all that reads columns of numbers reads exponents. */
    private static String decimal(double value) {
        if (!(Math.abs(value) < 1e7)) {
            return Numbers.text(value);
        }
        long units = Math.round(Math.abs(value) * UNIT);
        String digits = Long.toString(UNIT + units % UNIT);
        int end = digits.length();
        while (digits.charAt(end - 1) == '0') {
            end--;
        }
        return (value < 0 && units > 0 ? "-" : "") + units / UNIT + (end > 1 ? "." + digits.substring(1, end) : "");
    }

    /** Linear light of a grey as bright as the pixel. */
    static double luminance(Image image, int x, int y) {
        return 0.2126 * image.red(x, y) + 0.7152 * image.green(x, y) + 0.0722 * image.blue(x, y);
    }

    private interface Value {
        String at(int x, int y);
    }

    private static void write(Image image, OutputStream out, Value value) throws IOException {
        StringBuilder line = new StringBuilder();
        for (int y = 0; y < image.height(); y++) {
            line.setLength(0);
            for (int x = 0; x < image.width(); x++) {
                line.append(x == 0 ? "" : " ").append(value.at(x, y));
            }
            out.write(line.append('\n').toString().getBytes(StandardCharsets.US_ASCII));
        }
    }
}
