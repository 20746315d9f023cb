package cz.paprsek.render.eye;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.tree.Bundle;

/**
 * A lens of no size. Through the point (x, y) of the picture, in pixels from its top left corner, goes
 * the ray d + (x/W − ½)·h·W/H·r + (½ − y/H)·h·u with h = 2·tan(fovy/2), d the view, r right, u up, all of length 1.
 */
final class Pinhole extends Eye {
    private final Vec3 position;
    private final Vec3 forward;
    private final Vec3 right;
    private final Vec3 up;
    private final double perColumn;
    private final double perRow;

    Pinhole(Camera camera, int width, int height, int step) {
        double h = 2 * Angles.tan(camera.fovy() / 2);
        this.position = camera.position();
        this.forward = camera.forward();
        this.right = camera.right().times(h * width / height);
        this.up = camera.trueUp().times(h);
        this.perColumn = (double) step / width;
        this.perRow = (double) step / height;
    }

    @Override
    public void start(Ray ray, double x, double y, double lensU, double lensV) {
        double dx = directionX(x, y);
        double dy = directionY(x, y);
        double dz = directionZ(x, y);
        double k = 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
        ray.start(position.x(), position.y(), position.z(), dx * k, dy * k, dz * k);
    }

    @Override
    public boolean hasAperture() {
        return false;
    }

    @Override
    public void bundle(Bundle bundle, int left, int top, int columns, int rows) {
        bundle.start(position.x(), position.y(), position.z());
        for (int corner = 0; corner < 4; corner++) {
            int x = left + (corner & 1) * columns;
            int y = top + (corner >> 1) * rows;
            bundle.add(directionX(x, y), directionY(x, y), directionZ(x, y));
        }
    }

    private double directionX(double x, double y) {
        return forward.x() + (x * perColumn - 0.5) * right.x() + (0.5 - y * perRow) * up.x();
    }

    private double directionY(double x, double y) {
        return forward.y() + (x * perColumn - 0.5) * right.y() + (0.5 - y * perRow) * up.y();
    }

    private double directionZ(double x, double y) {
        return forward.z() + (x * perColumn - 0.5) * right.z() + (0.5 - y * perRow) * up.z();
    }
}
