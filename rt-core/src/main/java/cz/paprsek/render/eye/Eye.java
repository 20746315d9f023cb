package cz.paprsek.render.eye;

import cz.paprsek.scene.Camera;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.tree.Bundle;

/** A camera ready to make rays for pictures of one size: one class for each lens. Immutable. */
public abstract class Eye {
    /** The middle of a lens, in both directions. */
    private static final double MIDDLE = 0.5;

    /** The eye of a camera. */
    public static Eye of(Camera camera, int width, int height) {
        return of(camera, width, height, 1);
    }

    /** An eye for a coarse picture, whose pixels are squares of step × step pixels of the one that is width × height in size. */
    public static Eye of(Camera camera, int width, int height, int step) {
        return new Pinhole(camera, width, height, step);
    }

    /**
     * Starts the ray through a point of the picture; the centre of pixel (column j, row i) is (j + ½, i + ½).
     *
     * @param lensU where on the lens, 0–1; without meaning for one of no size
     * @param lensV likewise
     */
    public abstract void start(Ray ray, double x, double y, double lensU, double lensV);

    /** Whether it matters where on the lens a ray begins. */
    public abstract boolean hasAperture();

    /** Makes a bundle of all rays through a block of pixels. */
    public abstract void bundle(Bundle bundle, int left, int top, int columns, int rows);

    /** Starts the ray through a point of the picture and the middle of the lens. */
    public final void start(Ray ray, double x, double y) {
        start(ray, x, y, MIDDLE, MIDDLE);
    }
}
