package cz.paprsek.fx.view.picture;

import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.material.Rgb;
import cz.paprsek.render.Tile;
import java.nio.IntBuffer;
import java.util.Arrays;
import java.util.function.IntBinaryOperator;
import javafx.application.Platform;
import javafx.beans.property.ReadOnlyIntegerProperty;
import javafx.beans.property.ReadOnlyIntegerWrapper;
import javafx.geometry.Rectangle2D;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;

/**
 * A picture on the screen that any thread may paint on. However many tiles are painted, JavaFX's thread is asked but once to show them.
 * What is not painted yet is transparent.
 */
public final class PictureBuffer {
    /** The linear light of each channel's value. */
    private static final double[] LIGHT = light();

    private final int width;
    private final int height;
    private final int[] argb;
    private final PixelBuffer<IntBuffer> pixels;
    private final WritableImage image;
    private volatile int paints;
    private final ReadOnlyIntegerWrapper shownPaints = new ReadOnlyIntegerWrapper();
    private boolean updatePending;
    private int dirtyLeft;
    private int dirtyTop;
    private int dirtyRight;
    private int dirtyBottom;

    /** An empty picture. */
    public PictureBuffer(int width, int height) {
        this.width = width;
        this.height = height;
        this.argb = new int[Math.multiplyExact(width, height)];
        this.pixels = new PixelBuffer<>(width, height, IntBuffer.wrap(argb), PixelFormat.getIntArgbPreInstance());
        this.image = new WritableImage(pixels);
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /** What is to be shown, for JavaFX's thread. */
    public WritableImage image() {
        return image;
    }

    /**
     * Paints a part of another picture.
     *
     * @param source the other picture
     * @param tile the part, in pixels of the other picture
     * @param step how many pixels of this picture, side by side, are one of the other
     * @param how it is shown: exposure and tone
     */
    public void paint(Image source, Tile tile, int step, ImageOptions how) {
        IntBinaryOperator shown = how.shown(source);
        int left = tile.x() * step;
        int right = Math.min(width, (tile.x() + tile.width()) * step);
        int top = tile.y() * step;
        int bottom = Math.min(height, (tile.y() + tile.height()) * step);
        for (int y = top; y < bottom; y++) {
            if ((y - top) % step == 0) {
                for (int x = left; x < right; x++) {
                    argb[y * width + x] = (x - left) % step == 0 ? premultiplied(shown.applyAsInt(x / step, y / step)) : argb[y * width + x - 1];
                }
            } else {
                System.arraycopy(argb, (y - 1) * width + left, argb, y * width + left, right - left);
            }
        }
        changed(left, top, right, bottom);
    }

    /** How often it has been painted on: another number, another picture. */
    public int paints() {
        return paints;
    }

    /** As {@link #paints}, of what {@link #image} shows; changes on JavaFX's thread. */
    ReadOnlyIntegerProperty shownPaintsProperty() {
        return shownPaints.getReadOnlyProperty();
    }

    /** A copy of the picture as it is shown, in linear light. */
    public Image shown() {
        Image copy = new Image(width, height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int color = argb[y * width + x];
                copy.set(x, y, LIGHT[color >> 16 & 255], LIGHT[color >> 8 & 255], LIGHT[color & 255]);
            }
        }
        return copy;
    }

    private static double[] light() {
        double[] light = new double[256];
        Arrays.setAll(light, Rgb::linear);
        return light;
    }

    private static int premultiplied(int straight) {
        int alpha = straight >>> 24;
        return alpha == 255 ? straight : alpha << 24 | times(straight >> 16 & 255, alpha) << 16 | times(straight >> 8 & 255, alpha) << 8 | times(straight & 255, alpha);
    }

    private static int times(int channel, int alpha) {
        return (channel * alpha + 127) / 255;
    }

    @SuppressWarnings("NonAtomicVolatileUpdate") // here, one thread at a time
    private synchronized void changed(int left, int top, int right, int bottom) {
        paints++;
        dirtyLeft = updatePending ? Math.min(dirtyLeft, left) : left;
        dirtyTop = updatePending ? Math.min(dirtyTop, top) : top;
        dirtyRight = updatePending ? Math.max(dirtyRight, right) : right;
        dirtyBottom = updatePending ? Math.max(dirtyBottom, bottom) : bottom;
        if (!updatePending) {
            updatePending = true;
            Platform.runLater(() -> {
                pixels.updateBuffer(buffer -> takeDirty());
                shownPaints.set(paints);
            });
        }
    }

    private synchronized Rectangle2D takeDirty() {
        updatePending = false;
        return new Rectangle2D(dirtyLeft, dirtyTop, dirtyRight - dirtyLeft, dirtyBottom - dirtyTop);
    }
}
