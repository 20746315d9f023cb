package cz.paprsek.image;

import cz.paprsek.math.Require;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;

/**
 * A picture in linear light: three floats per pixel, unclamped, row by row from the top left; with opacity a fourth, and then the light is what the
 * covered part of the pixel brings ("premultiplied").
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
    /** Of a picture with opacity: that, 0–1. */
    private final float[] alpha;

    /** A black picture. */
    public Image(int width, int height) {
        this(width, height, false, false);
    }

    private Image(int width, int height, boolean isEightBit, boolean isTransparent) {
        requireRoom(width, height);
        this.width = width;
        this.height = height;
        this.linear = new float[isEightBit ? 0 : 3 * width * height];
        this.eightBit = new byte[isEightBit ? 3 * width * height : 0];
        this.alpha = new float[isTransparent ? width * height : 0];
    }

    /**
     * A black picture that takes a quarter of the memory: what is set is rounded to eight bits, sRGB-encoded. Pictures from files of eight bits are of
     * this kind, and lose nothing by it.
     */
    public static Image ofEightBit(int width, int height) {
        return new Image(width, height, true, false);
    }

    /** A picture with opacity, of which nothing is there yet: wholly transparent. */
    public static Image ofTransparent(int width, int height) {
        return new Image(width, height, false, true);
    }

    /** Whether it has opacity. */
    public boolean isTransparent() {
        return alpha.length > 0;
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

    /** How much of a pixel is covered, 0–1: all of it if the picture has no opacity. */
    public float alpha(int x, int y) {
        int i = index(x, y);
        return isTransparent() ? alpha[i / 3] : 1;
    }

    /**
     * Sets a pixel of a picture with opacity.
     *
     * @param red linear light of the covered part, times the share that is covered
     * @param opacity that share, 0–1
     * @throws IllegalArgumentException if the picture has none
     */
    public void set(int x, int y, double red, double green, double blue, double opacity) {
        Require.that(isTransparent(), "this picture has no opacity");
        set(x, y, red, green, blue);
        alpha[index(x, y) / 3] = (float) Math.max(0, Math.min(1, opacity));
    }

    /** Sets a pixel's linear light, and that it is covered; the most that a pixel holds is {@link Float#MAX_VALUE}. */
    public void set(int x, int y, double red, double green, double blue) {
        int i = index(x, y);
        if (isEightBit()) {
            eightBit[i] = (byte) Srgb.encode(clamped(red));
            eightBit[i + 1] = (byte) Srgb.encode(clamped(green));
            eightBit[i + 2] = (byte) Srgb.encode(clamped(blue));
            return;
        }
        if (isTransparent()) {
            alpha[i / 3] = 1;
        }
        linear[i] = clamped(red);
        linear[i + 1] = clamped(green);
        linear[i + 2] = clamped(blue);
    }

    /** The pixel as sRGB, 0xAARRGGBB, not premultiplied; AA is FF if the picture has no opacity. */
    public int argb(int x, int y) {
        int i = index(x, y);
        if (isEightBit()) {
            return 0xFF000000 | (eightBit[i] & 0xFF) << 16 | (eightBit[i + 1] & 0xFF) << 8 | (eightBit[i + 2] & 0xFF);
        }
        if (isTransparent()) {
            float cover = alpha[i / 3];
            return Math.round(255 * cover) << 24 | Srgb.encode(whole(linear[i], cover)) << 16 | Srgb.encode(whole(linear[i + 1], cover)) << 8
                    | Srgb.encode(whole(linear[i + 2], cover));
        }
        return 0xFF000000 | Srgb.encode(linear[i]) << 16 | Srgb.encode(linear[i + 1]) << 8 | Srgb.encode(linear[i + 2]);
    }

    /** The light of a pixel that were covered wholly by what covers a part of it. */
    static float whole(float light, float cover) {
        return cover > 0 ? light / cover : 0;
    }

    /** All pixels as sRGB, as {@link #argb}, row by row from the top left. */
    public int[] toArgb() {
        int[] pixels = new int[width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                pixels[y * width + x] = argb(x, y);
            }
        }
        return pixels;
    }

    /** All pixels in linear light: red, green and blue of each, row by row from the top left; with opacity premultiplied. */
    public float[] toLinear() {
        if (!isEightBit()) {
            return linear.clone();
        }
        float[] all = new float[eightBit.length];
        for (int i = 0; i < all.length; i++) {
            all[i] = light(i);
        }
        return all;
    }

    /** A copy for AWT and ImageIO, of type {@link BufferedImage#TYPE_INT_RGB}, or {@link BufferedImage#TYPE_INT_ARGB} with opacity. */
    public BufferedImage toBufferedImage() {
        BufferedImage copy = new BufferedImage(width, height, isTransparent() ? BufferedImage.TYPE_INT_ARGB : BufferedImage.TYPE_INT_RGB);
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
