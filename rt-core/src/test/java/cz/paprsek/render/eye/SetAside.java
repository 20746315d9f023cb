package cz.paprsek.render.eye;

import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.tree.Bundle;

/** An eye whose picture begins at another place than the first pixel: there the same is seen with other points, as different pixels have them. */
public final class SetAside extends Eye {
    /** How many pixels it takes, across and down, until points have nothing to do with each other any more. */
    public static final int PITCH = 256;
    /** How many such places there are in each direction. */
    private static final int PLACES = 1 << Short.SIZE >> 8;

    private final Eye eye;
    public final int left;
    public final int top;

    private SetAside(Camera camera, int side, Eye eye, int left, int top) {
        super(camera, side, side, 1);
        this.eye = eye;
        this.left = left;
        this.top = top;
    }

    /** The eye of a camera for a square picture, at one of 65 536 places. */
    public static SetAside of(Camera camera, int side, int place) {
        return new SetAside(camera, side, Eye.of(camera, side, side), place % PLACES * PITCH, place / PLACES * PITCH);
    }

    @Override
    public boolean start(Ray ray, double x, double y, double lensU, double lensV) {
        return eye.start(ray, x - left, y - top, lensU, lensV);
    }

    @Override
    public boolean bundle(Bundle bundle, int x, int y, int columns, int rows) {
        return eye.bundle(bundle, x - left, y - top, columns, rows);
    }

    @Override
    public boolean project(Vec3 world, double[] xy) {
        boolean isSeen = eye.project(world, xy);
        xy[0] += left;
        xy[1] += top;
        return isSeen;
    }
}
