package cz.paprsek.render.film;

import cz.paprsek.image.Image;
import java.util.Objects;

/**
 * What the light of a picture, or of a part of one, falls on, addressed by the pixels of the whole picture. Several workers may use it at once, each
 * for pixels of its own.
 *
 * <p>It has room for what is to come: alpha and other layers are further images of the same size beside this one, with a {@code set} of their own;
 * a picture of several passes has sums and counts, which {@link #set} divides. Who keeps tiles ({@code TileStore}) is told the pass, and writes
 * down whatever of a pixel a film has.
 */
public final class Film {
    private final Image image;
    private final int left;
    private final int top;

    /**
     * @param image what becomes of it
     * @param left which column of the picture is the image's first
     * @param top likewise which row
     */
    public Film(Image image, int left, int top) {
        this.image = Objects.requireNonNull(image, "image");
        this.left = left;
        this.top = top;
    }

    /** Sets the light of a pixel of the picture, linear. */
    public void set(int x, int y, double red, double green, double blue) {
        image.set(x - left, y - top, red, green, blue);
    }

    /** The light of a pixel of the picture, linear; 0 as long as it has not been set. */
    public float red(int x, int y) {
        return image.red(x - left, y - top);
    }

    /** As {@link #red}. */
    public float green(int x, int y) {
        return image.green(x - left, y - top);
    }

    /** As {@link #red}. */
    public float blue(int x, int y) {
        return image.blue(x - left, y - top);
    }
}
