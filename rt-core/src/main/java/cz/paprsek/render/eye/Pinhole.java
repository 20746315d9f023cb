package cz.paprsek.render.eye;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.tree.Bundle;

/**
 * A lens of no size. Through the point (x, y) of the picture, in pixels from its top left corner, goes
 * the ray d + (x/W − ½)·h·W/H·r + (½ − y/H)·h·u with h = 2·tan(fovy/2), d the view, r right, u up, all of length 1.
 */
class Pinhole extends Eye {
    /** As long as the picture is wide and high at distance 1. */
    private final Vec3 across;
    private final Vec3 upwards;
    private final double high;

    Pinhole(Camera camera, Lens.Perspective lens, double width, double height, int step) {
        super(camera, width, height, step);
        high = 2 * Angles.tan(lens.fovy() / 2);
        across = right.times(high * width / height);
        upwards = up.times(high);
    }

    @Override
    public boolean start(Ray ray, double x, double y, double lensU, double lensV) {
        return look(ray, directionX(x, y), directionY(x, y), directionZ(x, y));
    }

    @Override
    public boolean looksFromOnePlace() {
        return true;
    }

    @Override
    public void look(Views views, int count) {
        along(views.x, perColumn, views.u, count);
        down(views.y, perRow, views.v, count);
        views.directions.combine(forward, views.u, across, views.v, upwards, count);
        views.directions.normalize(views.lengths, count);
    }

    private static void along(double[] x, double perColumn, double[] u, int count) {
        for (int i = 0; i < count; i++) {
            u[i] = x[i] * perColumn - 0.5;
        }
    }

    private static void down(double[] y, double perRow, double[] v, int count) {
        for (int i = 0; i < count; i++) {
            v[i] = 0.5 - y[i] * perRow;
        }
    }

    @Override
    public boolean bundle(Bundle bundle, int left, int top, int columns, int rows) {
        bundle.start(position.x(), position.y(), position.z());
        for (int corner = 0; corner < 4; corner++) {
            int x = left + (corner + 1) / 2 % 2 * columns;
            int y = top + corner / 2 * rows;
            bundle.addCorner(directionX(x, y), directionY(x, y), directionZ(x, y));
        }
        return true;
    }

    @Override
    public boolean project(Vec3 world, double[] xy) {
        Vec3 v = world.minus(position);
        double size = v.dot(forward) * high;
        return size > 0 && at(v.dot(right) / (size * aspect), v.dot(up) / size, xy);
    }

    /** The way to the point at distance 1 along the view. */
    final double directionX(double x, double y) {
        return forward.x() + (x * perColumn - 0.5) * across.x() + (0.5 - y * perRow) * upwards.x();
    }

    final double directionY(double x, double y) {
        return forward.y() + (x * perColumn - 0.5) * across.y() + (0.5 - y * perRow) * upwards.y();
    }

    final double directionZ(double x, double y) {
        return forward.z() + (x * perColumn - 0.5) * across.z() + (0.5 - y * perRow) * upwards.z();
    }
}
