package cz.paprsek.render.denoise;

/** A tile of a picture with what is around it: scratch of one worker. Beyond the picture its outermost pixels go on, but count for nothing. */
final class Window {
    /** Size of a tile: what is summed of it should stay in a processor's second cache. */
    static final int WIDTH = 64;
    static final int HEIGHT = 8;

    final int margin;
    /** From one row to the next. */
    final int stride;
    /** How many numbers there are from the tile's first pixel to its last; those between its rows mean nothing. Long loops are computed several numbers at once. */
    final int span;
    /** 1 in the picture, 0 beyond it. */
    final float[] inside;
    private final int rows;
    private final int[] from;

    /** @param margin how many pixels around the tile are there */
    Window(int margin) {
        this.margin = margin;
        stride = WIDTH + 2 * margin;
        span = (HEIGHT - 1) * stride + WIDTH;
        rows = HEIGHT + 2 * margin;
        inside = new float[stride * rows];
        from = new int[stride * rows];
    }

    /** An image of it. */
    float[] newImage() {
        return new float[stride * rows];
    }

    /** Where a pixel of the tile is. */
    int at(int column, int row) {
        return (row + margin) * stride + column + margin;
    }

    /** Moves to the tile that has its top left corner there. */
    void moveTo(int left, int top, int width, int height) {
        for (int row = 0; row < rows; row++) {
            int y = top - margin + row;
            for (int column = 0; column < stride; column++) {
                int x = left - margin + column;
                int at = row * stride + column;
                inside[at] = x >= 0 && y >= 0 && x < width && y < height ? 1 : 0;
                from[at] = Math.min(height - 1, Math.max(0, y)) * width + Math.min(width - 1, Math.max(0, x));
            }
        }
    }

    /** Copies what of a picture's plane is in the window. */
    void copy(float[] plane, float[] into) {
        for (int i = 0; i < into.length; i++) {
            into[i] = plane[from[i]];
        }
    }
}
