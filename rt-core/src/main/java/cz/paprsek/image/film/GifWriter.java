package cz.paprsek.image.film;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Writes GIF: pictures one after the other, again and again, each with a palette of its own.
 *
 * @source CompuServe, Graphics Interchange Format 89a, 1990; Netscape's application extension for repetition
 */
final class GifWriter {
    /** So many pictures a second there can be: a delay is told in hundredths of a second, and programs take one of less than two for ten. */
    static final double MOST_FPS = 50;
    private static final int MOST_IN_BLOCK = 255;

    private final OutputStream out;
    private final int width;
    private final int height;
    private final double fps;
    private int frames;

    /** Writes the head. */
    GifWriter(OutputStream out, int width, int height, double fps) throws IOException {
        this.out = out;
        this.width = width;
        this.height = height;
        this.fps = fps;
        out.write("GIF89a".getBytes(StandardCharsets.US_ASCII));
        number(width);
        number(height);
        // No palette for all, colours of eight bits, square pixels.
        out.write(new byte[] {0x70, 0, 0});
        out.write(new byte[] {0x21, (byte) 0xFF, 11});
        out.write("NETSCAPE2.0".getBytes(StandardCharsets.US_ASCII));
        out.write(new byte[] {3, 1, 0, 0, 0});
    }

    /** @param rgb the pixels row by row, each as 0xRRGGBB */
    void add(int[] rgb) throws IOException {
        Palette palette = Palette.of(rgb);
        byte[] pixels = palette.indexes(rgb, width);
        // Delays are rounded so that no error adds up.
        long delay = hundredths(frames + 1) - hundredths(frames);
        frames++;
        out.write(new byte[] {0x21, (byte) 0xF9, 4, 0});
        number((int) delay);
        out.write(new byte[] {0, 0, 0x2C, 0, 0, 0, 0});
        number(width);
        number(height);
        out.write(0x80 | (palette.bits() - 1));
        for (int i = 0; i < 1 << palette.bits(); i++) {
            int color = palette.color(i);
            out.write(new byte[] {(byte) (color >> 16), (byte) (color >> 8), (byte) color});
        }
        byte[] codes = Lzw.of(pixels, Math.max(2, palette.bits()));
        out.write(Math.max(2, palette.bits()));
        for (int at = 0; at < codes.length; at += MOST_IN_BLOCK) {
            int size = Math.min(MOST_IN_BLOCK, codes.length - at);
            out.write(size);
            out.write(codes, at, size);
        }
        out.write(0);
    }

    /** Writes the end. */
    void end() throws IOException {
        out.write(0x3B);
    }

    private long hundredths(int frame) {
        return Math.round(100 * frame / fps);
    }

    private void number(int value) throws IOException {
        out.write(value);
        out.write(value >> 8);
    }

    /** Compression with codes that grow. */
    private static final class Lzw {
        private static final int MOST_CODES = 1 << 12;

        private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        private int held;
        private int bits;

        static byte[] of(byte[] pixels, int least) {
            Lzw codes = new Lzw();
            int clear = 1 << least;
            int next = clear + 2;
            int size = least + 1;
            // For each code, and a pixel behind what it stands for, the code for both; 0 for none.
            short[] longer = new short[MOST_CODES << 8];
            codes.put(clear, size);
            int code = pixels[0] & 0xFF;
            for (int i = 1; i < pixels.length; i++) {
                int pixel = pixels[i] & 0xFF;
                int both = longer[(code << 8) | pixel];
                if (both != 0) {
                    code = both;
                    continue;
                }
                codes.put(code, size);
                if (next < MOST_CODES) {
                    longer[(code << 8) | pixel] = (short) next;
                    size += next == 1 << size ? 1 : 0;
                    next++;
                } else {
                    codes.put(clear, size);
                    Arrays.fill(longer, (short) 0);
                    next = clear + 2;
                    size = least + 1;
                }
                code = pixel;
            }
            codes.put(code, size);
            // The reader has put down one more by now.
            size += next == 1 << size && size < 12 ? 1 : 0;
            codes.put(clear + 1, size);
            codes.put(0, 7);
            return codes.bytes.toByteArray();
        }

        private void put(int code, int size) {
            held |= code << bits;
            bits += size;
            while (bits >= 8) {
                bytes.write(held);
                held >>>= 8;
                bits -= 8;
            }
        }
    }
}
