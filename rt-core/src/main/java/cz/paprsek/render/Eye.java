package cz.paprsek.render;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.shape.Ray;

/**
 * A camera ready to make rays for pictures of one size. Through the point (x, y) of the picture, in pixels from its top left corner, goes
 * the ray d + (x/W − ½)·h·W/H·r + (½ − y/H)·h·u with h = 2·tan(fovy/2), d the view, r right, u up, all of length 1.
 */
final class Eye {
    private final Vec3 position;
    private final Vec3 forward;
    private final Vec3 right;
    private final Vec3 up;
    private final double width;
    private final double height;

    Eye(Camera camera, int width, int height) {
        double h = 2 * Angles.tan(camera.fovy() / 2);
        this.position = camera.position();
        this.forward = camera.forward();
        this.right = camera.right().times(h * width / height);
        this.up = camera.trueUp().times(h);
        this.width = width;
        this.height = height;
    }

    /** Starts the ray through a point of the picture; the centre of pixel (column j, row i) is (j + ½, i + ½). */
    void start(Ray ray, double x, double y) {
        double a = x / width - 0.5;
        double b = 0.5 - y / height;
        double dx = forward.x() + a * right.x() + b * up.x();
        double dy = forward.y() + a * right.y() + b * up.y();
        double dz = forward.z() + a * right.z() + b * up.z();
        double k = 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
        ray.start(position.x(), position.y(), position.z(), dx * k, dy * k, dz * k);
    }
}
