package cz.paprsek.fx.view.look;

import javafx.geometry.Bounds;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;

/**
 * Thin lines with soft edges, drawn as one picture: for thousands of outlines, each of which takes JavaFX as long to stroke as ten take here. Where lines meet or cross,
 * what covers most of a pixel counts, and where all is covered nothing need be drawn any more.
 */
final class ThinLines implements Strokes {
    private static final int ALL = 255;

    private final GraphicsContext g;
    private final Color color;
    /** Pixels of the screen for one of the canvas. */
    private final double pixels;
    /** Of the picture, pixels of the screen. */
    private final int left;
    private final int top;
    private final int width;
    private final int height;
    /** Half of a line's width, pixels of the screen. */
    private final double half;
    /** How much of each pixel is covered, up to {@link #ALL}. */
    private final byte[] covered;
    private double x;
    private double y;

    /**
     * @param part of the canvas where lines are drawn; the rest of them is left out
     * @param lineWidth pixels of the canvas, 1 or more
     */
    ThinLines(GraphicsContext g, Bounds part, double lineWidth, Color color) {
        this.g = g;
        this.color = color;
        pixels = Strokes.pixels(g.getCanvas());
        half = lineWidth * pixels / 2;
        left = (int) Math.floor(part.getMinX() * pixels);
        top = (int) Math.floor(part.getMinY() * pixels);
        width = Math.max(1, (int) Math.ceil(part.getMaxX() * pixels) - left);
        height = Math.max(1, (int) Math.ceil(part.getMaxY() * pixels) - top);
        covered = new byte[width * height];
    }

    @Override
    public void moveTo(double toX, double toY) {
        x = toX * pixels - left;
        y = toY * pixels - top;
    }

    @Override
    public void lineTo(double toX, double toY) {
        double fromX = x;
        double fromY = y;
        moveTo(toX, toY);
        if (Math.abs(x - fromX) >= Math.abs(y - fromY)) {
            line(fromX, fromY, x - fromX, y - fromY, width, height, 1, width);
        } else {
            line(fromY, fromX, y - fromY, x - fromX, height, width, width, 1);
        }
    }

    /** One that goes along the first coordinate more than along the second; strides lead to the next pixel of each. */
    private void line(double a, double b, double da, double db, int ends, int sides, int stride, int strideAcross) {
        double reach = half + 0.5;
        double length = Math.sqrt(da * da + db * db);
        double unitA = length == 0 ? 1 : da / length;
        double unitB = length == 0 ? 0 : db / length;
        int last = last(Math.max(a, a + da) + reach, ends);
        for (int i = first(Math.min(a, a + da) - reach); i <= last; i++) {
            double along = i + 0.5 - a;
            double middle = b + unitB / unitA * Math.max(Math.min(0, da), Math.min(Math.max(0, da), along));
            int to = last(middle + 1.5 * reach, sides);
            for (int j = first(middle - 1.5 * reach); j <= to; j++) {
                int pixel = i * stride + j * strideAcross;
                int cover = covered[pixel] & 0xFF;
                if (cover < ALL) {
                    double across = j + 0.5 - b;
                    double t = along * unitA + across * unitB;
                    double beyond = t < 0 ? t : t > length ? t - length : 0;
                    double off = along * unitB - across * unitA;
                    double distance = beyond == 0 ? Math.abs(off) : Math.sqrt(off * off + beyond * beyond);
                    covered[pixel] = (byte) Math.max(cover, (int) (ALL * Math.min(1, reach - distance) + 0.5));
                }
            }
        }
    }

    private static int first(double place) {
        return (int) Math.max(0, Math.floor(place));
    }

    private static int last(double place, int end) {
        return (int) Math.min(end - 1, Math.floor(place));
    }

    @Override
    public boolean hides(double fromX, double fromY, double toX, double toY) {
        int right = last(toX * pixels - left, width);
        int bottom = last(toY * pixels - top, height);
        for (int j = first(fromY * pixels - top); j <= bottom; j++) {
            for (int i = first(fromX * pixels - left); i <= right; i++) {
                if ((covered[j * width + i] & 0xFF) < ALL) {
                    return false;
                }
            }
        }
        return true;
    }

    @Override
    public void next() {
        // It does not matter what lines belong to.
    }

    @Override
    public void end() {
        int[] shades = new int[ALL + 1];
        for (int i = 0; i <= ALL; i++) {
            double alpha = color.getOpacity() * i;
            shades[i] = (int) Math.round(alpha) << 24 | (int) Math.round(alpha * color.getRed()) << 16 | (int) Math.round(alpha * color.getGreen()) << 8
                    | (int) Math.round(alpha * color.getBlue());
        }
        int[] colors = new int[covered.length];
        for (int i = 0; i < colors.length; i++) {
            colors[i] = shades[covered[i] & 0xFF];
        }
        WritableImage image = new WritableImage(width, height);
        image.getPixelWriter().setPixels(0, 0, width, height, PixelFormat.getIntArgbPreInstance(), colors, 0, width);
        g.drawImage(image, left / pixels, top / pixels, width / pixels, height / pixels);
    }
}
