package cz.paprsek.render.eye;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.tree.Bundle;

/**
 * A lens with a size: all rays through one point of the picture meet where the ray through the lens's middle crosses the plane in focus. With
 * F the distance of that plane and e the pinhole's direction, of length 1 along the view, the ray from P + δ, δ on the lens, goes along F·e − δ.
 *
 * @source Cook, Porter, Carpenter, Distributed Ray Tracing, SIGGRAPH 1984
 */
final class ThinLens extends Pinhole {
    /** Room for the rounding of a sum. */
    private static final double ROUNDING = 1 + 1e-12;

    private final double radius;
    private final double focus;
    private final Bounds lens;

    ThinLens(Camera camera, Lens.Perspective thin, double width, double height, int step) {
        super(camera, thin, width, height, step);
        radius = thin.aperture();
        focus = camera.focus();
        Vec3 wide = new Vec3(reach(right.x(), up.x()), reach(right.y(), up.y()), reach(right.z(), up.z()));
        lens = Bounds.of(position.minus(wide), position.plus(wide));
    }

    @Override
    public boolean start(Ray ray, double x, double y, double lensU, double lensV) {
        double a = radius * Disc.x(lensU, lensV);
        double b = radius * Disc.y(lensU, lensV);
        double lx = a * right.x() + b * up.x();
        double ly = a * right.y() + b * up.y();
        double lz = a * right.z() + b * up.z();
        double dx = focus * directionX(x, y) - lx;
        double dy = focus * directionY(x, y) - ly;
        double dz = focus * directionZ(x, y) - lz;
        double k = 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
        ray.start(position.x() + lx, position.y() + ly, position.z() + lz, dx * k, dy * k, dz * k);
        return true;
    }

    @Override
    public boolean bundle(Bundle bundle, int left, int top, int columns, int rows) {
        double wideX = lens.maxX() - position.x();
        double wideY = lens.maxY() - position.y();
        double wideZ = lens.maxZ() - position.z();
        bundle.start(lens.minX(), lens.minY(), lens.minZ(), lens.maxX(), lens.maxY(), lens.maxZ());
        for (int corner = 0; corner < 4; corner++) {
            int x = left + (corner & 1) * columns;
            int y = top + (corner >> 1) * rows;
            double dx = focus * directionX(x, y);
            double dy = focus * directionY(x, y);
            double dz = focus * directionZ(x, y);
            bundle.add(dx - wideX, dy - wideY, dz - wideZ);
            bundle.add(dx + wideX, dy + wideY, dz + wideZ);
        }
        return true;
    }

    /** How far the lens reaches along an axis. */
    private double reach(double rightAlong, double upAlong) {
        return ROUNDING * radius * Math.sqrt(rightAlong * rightAlong + upAlong * upAlong);
    }

    @Override
    public boolean hasAperture() {
        return true;
    }

    @Override
    public boolean looksFromOnePlace() {
        return false;
    }

    @Override
    public double[] tell(Ray ray) {
        return aside(ray);
    }

    @Override
    public Bounds origins() {
        return lens;
    }
}
