package cz.paprsek.shape.placed;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;

/** All that is not farther than a radius from a box: |max(|p| − h, 0)|² ≤ r². The box may be flat, a line or a point. */
public abstract class Rounded extends Bulge {
    private final Vec3 centre;
    private final double hx;
    private final double hy;
    private final double hz;
    private final double radius;

    /**
     * Places it.
     *
     * @param centre of the box
     * @param half from there to its faces
     */
    protected Rounded(int part, Affine toWorld, Vec3 centre, Vec3 half, double radius) {
        super(part, toWorld, worldBounds(toWorld, Bounds.around(centre, half), radius), Bounds.around(centre, half.plus(new Vec3(radius, radius, radius))));
        this.centre = centre;
        hx = half.x();
        hy = half.y();
        hz = half.z();
        this.radius = radius;
    }

    private static Bounds worldBounds(Affine toWorld, Bounds box, double radius) {
        Bounds inner = box.transformed(toWorld);
        Bounds ball = Bounds.ofEllipsoid(toWorld, radius, radius, radius);
        double x = (ball.maxX() - ball.minX()) / 2;
        double y = (ball.maxY() - ball.minY()) / 2;
        double z = (ball.maxZ() - ball.minZ()) / 2;
        return new Bounds(inner.minX() - x, inner.minY() - y, inner.minZ() - z, inner.maxX() + x, inner.maxY() + y, inner.maxZ() + z);
    }

    @Override
    protected void form(Line line, double t, double[] out) {
        double x = line.ox + t * line.dx - centre.x();
        double y = line.oy + t * line.dy - centre.y();
        double z = line.oz + t * line.dz - centre.z();
        double ex = beyond(x, hx);
        double ey = beyond(y, hy);
        double ez = beyond(z, hz);
        out[0] = ex * ex + ey * ey + ez * ez - radius * radius;
        out[1] = 2 * (ex * line.dx + ey * line.dy + ez * line.dz);
    }

    /** How far a coordinate lies beyond the box, with its sign. */
    private static double beyond(double at, double half) {
        return at > half ? at - half : at < -half ? at + half : 0;
    }

    @Override
    protected void describe(int face, double x, double y, double z, Affine toLocal, Hit hit) {
        Vec3 n = outwards(x, y, z);
        hit.normal(toLocal, n.x(), n.y(), n.z());
    }

    /** The normal at a point of the surface; where rounding has lost the radius, that of the nearest face of the box. */
    protected final Vec3 outwards(double px, double py, double pz) {
        double x = px - centre.x();
        double y = py - centre.y();
        double z = pz - centre.z();
        Vec3 n = new Vec3(beyond(x, hx), beyond(y, hy), beyond(z, hz));
        if (n.x() != 0 || n.y() != 0 || n.z() != 0) {
            return n;
        }
        double ax = Math.abs(x) - hx;
        double ay = Math.abs(y) - hy;
        double az = Math.abs(z) - hz;
        return ax >= ay && ax >= az ? new Vec3(Math.copySign(1, x), 0, 0) : ay >= az ? new Vec3(0, Math.copySign(1, y), 0) : new Vec3(0, 0, Math.copySign(1, z));
    }
}
