package cz.paprsek.image.film;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/**
 * Writes uncompressed video for other programs to compress: YUV4MPEG2 with as much of colour as of brightness, as BT.601 has them (Y from 16 to 235, Cb and Cr from 16 to 240).
 *
 * @source mjpegtools, yuv4mpeg(5); ITU-R BT.601, sections 2.5.1 and 2.5.3
 */
final class Y4mWriter {
    private static final double RED = 0.299;
    private static final double BLUE = 0.114;

    private final OutputStream out;

    /** Writes the head. */
    Y4mWriter(OutputStream out, int width, int height, FrameRate rate) throws IOException {
        this.out = out;
        out.write(("YUV4MPEG2 W" + width + " H" + height + " F" + rate.frames() + ":" + rate.seconds() + " Ip A1:1 C444\n").getBytes(StandardCharsets.US_ASCII));
    }

    /** @param rgb the pixels row by row, each as 0xRRGGBB */
    void add(int[] rgb) throws IOException {
        int count = rgb.length;
        byte[] planes = new byte[3 * count];
        for (int i = 0; i < count; i++) {
            double r = (rgb[i] >> 16 & 0xFF) / 255.0;
            double g = (rgb[i] >> 8 & 0xFF) / 255.0;
            double b = (rgb[i] & 0xFF) / 255.0;
            double y = RED * r + (1 - RED - BLUE) * g + BLUE * b;
            planes[i] = (byte) Math.rint(16 + 219 * y);
            planes[count + i] = (byte) Math.rint(128 + 112 * (b - y) / (1 - BLUE));
            planes[2 * count + i] = (byte) Math.rint(128 + 112 * (r - y) / (1 - RED));
        }
        out.write("FRAME\n".getBytes(StandardCharsets.US_ASCII));
        out.write(planes);
    }
}
