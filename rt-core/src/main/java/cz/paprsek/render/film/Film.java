package cz.paprsek.render.film;

import cz.paprsek.image.Image;

/** What the light of a picture, or of a part of one, falls on. Several workers may use it at once, each for pixels of its own. */
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
        this.image = image;
        this.left = left;
        this.top = top;
    }

    /** Sets the light of a pixel of the picture, linear. */
    public void set(int x, int y, double red, double green, double blue) {
        image.set(x - left, y - top, red, green, blue);
    }
}
