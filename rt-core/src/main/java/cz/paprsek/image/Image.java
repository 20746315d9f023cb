package cz.paprsek.image;

import cz.paprsek.math.Require;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;

/**
 * A picture in linear light: three floats per pixel, unclamped, row by row from the top left.
 * Threads may write different pixels at the same time.
 */
public final class Image {
    /** How many pixels there can be: as many as one array holds. */
    public static final int MOST_PIXELS = (Integer.MAX_VALUE - 8) / 3;

    private final int width;
    private final int height;
    private final float[] linear;
    /** Of a picture that keeps eight bits: those, in place of the floats. */
    private final byte[] eightBit;

    /** A black picture. */
    public Image(int width, int height) {
        this(width, height, false);
    }

    private Image(int width, int height, boolean isEightBit) {
        requireRoom(width, height);
        this.width = width;
        this.height = height;
        this.linear = new float[isEightBit ? 0 : 3 * width * height];
        this.eightBit = new byte[isEightBit ? 3 * width * height : 0];
    }

    /**
     * A black picture that takes a quarter of the memory: what is set is rounded to eight bits, sRGB-encoded. Pictures from files of eight bits are of
     * this kind, and lose nothing by it.
     */
    public static Image ofEightBit(int width, int height) {
        return new Image(width, height, true);
    }

    /** Whether it keeps eight bits a channel. */
    public boolean isEightBit() {
        return eightBit.length > 0;
    }

    /** @throws IllegalArgumentException if there can be no picture of this size */
    public static void requireRoom(int width, int height) {
        Require.within("picture width", width, 1, 1 << 16);
        Require.within("picture height", height, 1, 1 << 16);
        Require.that((long) width * height <= MOST_PIXELS, "a picture of " + width + " × " + height + " pixels is larger than the "
                + MOST_PIXELS + " that can be computed at once; render it in parts, region by region");
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /**
     * Linear light of a pixel; column and row are counted from 0 at the top left.
     *
     * @throws IllegalArgumentException if there is no such pixel, as in all methods here that take one
     */
    public float red(int x, int y) {
        return light(index(x, y));
    }

    public float green(int x, int y) {
        return light(index(x, y) + 1);
    }

    public float blue(int x, int y) {
        return light(index(x, y) + 2);
    }

    /** Sets a pixel's linear light; the most that a pixel holds is {@link Float#MAX_VALUE}. */
    public void set(int x, int y, double red, double green, double blue) {
        int i = index(x, y);
        if (isEightBit()) {
            eightBit[i] = (byte) Srgb.encode(clamped(red));
            eightBit[i + 1] = (byte) Srgb.encode(clamped(green));
            eightBit[i + 2] = (byte) Srgb.encode(clamped(blue));
            return;
        }
        linear[i] = clamped(red);
        linear[i + 1] = clamped(green);
        linear[i + 2] = clamped(blue);
    }

    /** The pixel as sRGB, 0xFFRRGGBB. */
    public int argb(int x, int y) {
        int i = index(x, y);
        if (isEightBit()) {
            return 0xFF000000 | (eightBit[i] & 0xFF) << 16 | (eightBit[i + 1] & 0xFF) << 8 | (eightBit[i + 2] & 0xFF);
        }
        return 0xFF000000 | Srgb.encode(linear[i]) << 16 | Srgb.encode(linear[i + 1]) << 8 | Srgb.encode(linear[i + 2]);
    }

    /** All pixels as sRGB, 0xFFRRGGBB, row by row from the top left. */
    public int[] toArgb() {
        int[] pixels = new int[width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                pixels[y * width + x] = argb(x, y);
            }
        }
        return pixels;
    }

    /** A copy for AWT and ImageIO, of type {@link BufferedImage#TYPE_INT_RGB}. */
    public BufferedImage toBufferedImage() {
        BufferedImage copy = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        System.arraycopy(toArgb(), 0, ((DataBufferInt) copy.getRaster().getDataBuffer()).getData(), 0, width * height);
        return copy;
    }

    private float light(int i) {
        return isEightBit() ? Srgb.light(eightBit[i] & 0xFF) : linear[i];
    }

    private static float clamped(double light) {
        return light > Float.MAX_VALUE ? Float.MAX_VALUE : (float) light;
    }

    /** @throws IllegalArgumentException if there is no such pixel: a column too many would be one of the next row */
    private int index(int x, int y) {
        if (x < 0 || x >= width || y < 0 || y >= height) {
            throw new IllegalArgumentException("pixel " + x + "," + y + " must lie inside the picture of " + width + " × " + height + " pixels");
        }
        return 3 * (y * width + x);
    }
}
