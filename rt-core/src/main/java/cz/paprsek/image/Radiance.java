package cz.paprsek.image;

import cz.paprsek.image.ImageOptions.Origin;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/**
 * Radiance pictures: linear light, three mantissas of eight bits with one exponent. Negative light is written as none.
 *
 * @source Ward, Real Pixels, Graphics Gems II, 1991; Radiance's color.c for the runs of equal bytes
 */
final class Radiance {
    /** What rows of other widths cannot be shortened to. */
    static final int SHORTEST = 8;
    static final int LONGEST = 0x7FFF;
    private static final int MOST_RUN = 127;
    private static final int MOST_PLAIN = 128;
    private static final int LEAST_RUN = 4;

    private Radiance() {}

    static void write(Image image, Origin origin, OutputStream out) throws IOException {
        StringBuilder comments = new StringBuilder();
        origin.lines().forEach(line -> comments.append("# ").append(line).append('\n'));
        out.write(("#?RADIANCE\n" + comments + "FORMAT=32-bit_rle_rgbe\n\n-Y " + image.height() + " +X " + image.width() + "\n").getBytes(StandardCharsets.US_ASCII));
        byte[][] row = new byte[4][image.width()];
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                encode(image.red(x, y), image.green(x, y), image.blue(x, y), row, x);
            }
            if (image.width() < SHORTEST || image.width() > LONGEST) {
                writePlain(row, out);
            } else {
                writeShortened(row, out);
            }
        }
    }

    /** Rounds to the nearest mantissas, where Radiance's own programs cut off: half the error. */
    private static void encode(float red, float green, float blue, byte[][] row, int x) {
        // Not of Math.max alone: what is not a number would be the largest.
        float most = Math.max(positive(red), Math.max(positive(green), positive(blue)));
        int exponent = most > 0 ? Math.getExponent(most) + 1 : -128;
        // Rounding up the largest may reach 256.
        if (exponent > -128 && Math.round(Math.scalb((double) most, 8 - exponent)) > 255) {
            exponent++;
        }
        if (!(exponent > -128)) {
            row[0][x] = row[1][x] = row[2][x] = row[3][x] = 0;
            return;
        }
        boolean isTooBright = exponent > 127;
        int scale = isTooBright ? 127 : exponent;
        row[0][x] = mantissa(red, scale);
        row[1][x] = mantissa(green, scale);
        row[2][x] = mantissa(blue, scale);
        row[3][x] = (byte) (scale + 128);
    }

    private static float positive(float light) {
        return light > 0 ? light : 0;
    }

    private static byte mantissa(float light, int exponent) {
        return light > 0 ? (byte) Math.min(255, Math.round(Math.scalb((double) light, 8 - exponent))) : 0;
    }

    private static void writePlain(byte[][] row, OutputStream out) throws IOException {
        for (int x = 0; x < row[0].length; x++) {
            for (byte[] channel : row) {
                out.write(channel[x]);
            }
        }
    }

    /** Each channel of the row by itself, as runs of equal bytes and stretches of others. */
    private static void writeShortened(byte[][] row, OutputStream out) throws IOException {
        int width = row[0].length;
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(2);
        bytes.write(2);
        bytes.write(width >> 8);
        bytes.write(width);
        for (byte[] channel : row) {
            int plain = 0;
            for (int x = 0; x < width;) {
                int run = run(channel, x);
                if (run >= LEAST_RUN) {
                    writeStretch(channel, plain, x, bytes);
                    bytes.write(128 + run);
                    bytes.write(channel[x]);
                    plain = x + run;
                }
                x += run;
            }
            writeStretch(channel, plain, width, bytes);
        }
        bytes.writeTo(out);
    }

    private static int run(byte[] channel, int from) {
        int end = from + 1;
        while (end < channel.length && end - from < MOST_RUN && channel[end] == channel[from]) {
            end++;
        }
        return end - from;
    }

    private static void writeStretch(byte[] channel, int from, int to, ByteArrayOutputStream bytes) {
        for (int start = from; start < to; start += MOST_PLAIN) {
            int length = Math.min(MOST_PLAIN, to - start);
            bytes.write(length);
            bytes.write(channel, start, length);
        }
    }
}
