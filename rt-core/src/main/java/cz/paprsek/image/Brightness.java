package cz.paprsek.image;

import cz.paprsek.math.Numbers;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/**
 * The brightness of pixels, as text: one image row a line, values separated by a blank.
 *
 * @source ITU-R BT.709 for the weights of the channels
 */
final class Brightness {
    private Brightness() {}

    /** Brightness 0–255: luminance, sRGB-encoded. */
    static int of(Image image, int x, int y) {
        return Srgb.encode((float) luminance(image, x, y));
    }

    static void encoded(Image image, OutputStream out) throws IOException {
        write(image, out, (x, y) -> Integer.toString(of(image, x, y)));
    }

    /** Luminance in linear light, unclamped. */
    static void linear(Image image, OutputStream out) throws IOException {
        write(image, out, (x, y) -> Numbers.text(luminance(image, x, y)));
    }

    private static double luminance(Image image, int x, int y) {
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
