package cz.paprsek.render.eye;

import cz.paprsek.scene.Camera;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.tree.Bundle;

/** An eye at one point, on whose picture straight lines are curves. */
abstract class Curved extends Eye {
    /** Room for the rounding of directions, whose length is 1. */
    private static final double ROUNDING = 1e-12;

    /** How fast a direction turns from column to column, and from row to row: bounds of its second derivatives. */
    private final double bendAcross;
    private final double bendDown;

    /**
     * @param across radians that no direction turns more than from one side of the picture to the other
     * @param down likewise from top to bottom
     * @param bend bound of the second derivative of a direction by those angles
     */
    Curved(Camera camera, double width, double height, int step, double across, double down, double bend) {
        super(camera, width, height, step);
        bendAcross = bend * across * across * perColumn * perColumn;
        bendDown = bend * down * down * perRow * perRow;
    }

    /** Widens the bundle by the direction through a point of the picture, also by that through one where it shows nothing. */
    abstract void add(Bundle bundle, double x, double y, double slack);

    /**
     * The directions through a block stay near those between its corners.
     *
     * @source the error of bilinear interpolation: an eighth of the second derivatives, times the lengths of the sides squared
     */
    @Override
    public final boolean bundle(Bundle bundle, int left, int top, int columns, int rows) {
        double slack = (bendAcross * columns * columns + bendDown * rows * rows) / 8 + ROUNDING;
        bundle.start(position.x(), position.y(), position.z());
        for (int corner = 0; corner < 4; corner++) {
            add(bundle, left + (corner & 1) * columns, top + (corner >> 1) * rows, slack);
        }
        return true;
    }

    @Override
    public final boolean keepsLines() {
        return false;
    }

    /** Starts a ray along f parts of the view, r of right and u of up. */
    final boolean lookAlong(Ray ray, double f, double r, double u) {
        return look(ray, x(f, r, u), y(f, r, u), z(f, r, u));
    }

    /** Widens the bundle by all directions near f parts of the view, r of right and u of up. */
    final void add(Bundle bundle, double f, double r, double u, double slack) {
        double dx = x(f, r, u);
        double dy = y(f, r, u);
        double dz = z(f, r, u);
        bundle.add(dx - slack, dy - slack, dz - slack);
        bundle.add(dx + slack, dy + slack, dz + slack);
    }

    private double x(double f, double r, double u) {
        return f * forward.x() + r * right.x() + u * up.x();
    }

    private double y(double f, double r, double u) {
        return f * forward.y() + r * right.y() + u * up.y();
    }

    private double z(double f, double r, double u) {
        return f * forward.z() + r * right.z() + u * up.z();
    }
}
