package cz.paprsek.shape.placed;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;

/** A figure in the plane z = 0 of its own space, met there at t = −o_z / d_z. */
public abstract class Flat extends Surface implements Part {
    /** Up to which product of norms a map is told from its inverse so well that a figure lies where its bounds say. */
    private static final double EVEN = 1e4;
    /** How far a plane may lean that counts as one across an axis. */
    private static final double LEAN = 1e-14;
    /** What is farther from a plane than this, relative to the numbers it comes from, is on that side beyond doubt. */
    private static final double NEAR = 1e-9;

    private final int part;
    private final Affine toLocal;
    private final Bounds bounds;
    private final int axis;
    private final double place;
    /** Both are the same everywhere. */
    private final Vec3 tangent;
    private final Vec3 normal;

    protected Flat(int part, Affine toWorld, Bounds worldBounds) {
        this.part = part;
        this.toLocal = toWorld.inverse();
        this.bounds = worldBounds;
        this.axis = toWorld.norm() * toLocal.norm() <= EVEN ? axis(toLocal) : -1;
        this.place = 0 - toLocal.zt() / growth();
        this.tangent = toWorld.direction(Vec3.X).normalized();
        Hit hit = new Hit();
        hit.normal(toLocal, 0, 0, 1);
        this.normal = new Vec3(hit.nx, hit.ny, hit.nz);
    }

    /** Whether a point of the plane belongs to the figure. */
    protected abstract boolean holds(double x, double y);

    /** Whether the figure is a rectangle with edges along its own axes. */
    protected boolean isRectangle() {
        return false;
    }

    /** The figure's x as 0–1. */
    protected abstract double u(double x);

    /** The figure's y as 0–1. */
    protected abstract double v(double y);

    @Override
    public Bounds bounds() {
        return bounds;
    }

    /** The number of the part that it is. */
    public final int part() {
        return part;
    }

    /** To which axis of the world, 0 to 2, its plane is perpendicular; −1 if to none, or if rounding may move its edges farther than a little. */
    public final int axis() {
        return axis;
    }

    private static int axis(Affine toLocal) {
        double x = Math.abs(toLocal.zx());
        double y = Math.abs(toLocal.zy());
        double z = Math.abs(toLocal.zz());
        double most = LEAN * Math.max(x, Math.max(y, z));
        return Math.max(y, z) <= most ? 0 : Math.max(x, z) <= most ? 1 : Math.max(x, y) <= most ? 2 : -1;
    }

    /** Where that axis crosses its plane. */
    public final double place() {
        return place;
    }

    /** Whether it is all of its bounds, and its place along {@link #axis} depends on no other coordinate. */
    public final boolean fillsBounds() {
        return isRectangle() && axis >= 0 && toLocal.keepsAxes();
    }

    /** How fast its own z grows along that axis. */
    public final double growth() {
        return axis == 0 ? toLocal.zx() : axis == 1 ? toLocal.zy() : toLocal.zz();
    }

    /** Its own z at the origin. */
    public final double atOrigin() {
        return toLocal.zt();
    }

    /** Whether its plane is across an axis and, beyond doubt, not crossed between the ray's start and its reach: told without a quotient. */
    public final boolean isApart(Ray ray) {
        if (axis < 0) {
            return false;
        }
        double from = ray.ox - place;
        double d = ray.dx;
        if (axis == 1) {
            from = ray.oy - place;
            d = ray.dy;
        } else if (axis == 2) {
            from = ray.oz - place;
            d = ray.dz;
        }
        double to = from + ray.reach * d;
        double slack = NEAR * (Math.abs(place) + ray.scale + ray.reach);
        // Then each of both is farther away than that, on the same side.
        return from * to > slack * (Math.abs(from) + Math.abs(to)) && ray.min >= -slack;
    }

    @Override
    public void nearest(Ray ray) {
        double t = crossing(ray, ray.min, ray.reach);
        if (t > ray.min) {
            ray.accept(t, part, 0);
        }
    }

    @Override
    public boolean occludes(Ray ray) {
        return crossing(ray, ray.contact, ray.max) > ray.contact;
    }

    @Override
    public void crossings(Ray ray, Spans out) {
        double t = crossing(ray, ray.min, ray.max);
        if (t > ray.min) {
            out.add(t, part, 0);
        }
    }

    @Override
    public void describe(int face, Hit hit) {
        hit.unitNormal(normal.x(), normal.y(), normal.z());
    }

    @Override
    public void map(int face, Hit hit) {
        hit.u = u(toLocal.pointX(hit.px, hit.py, hit.pz));
        hit.v = v(toLocal.pointY(hit.px, hit.py, hit.pz));
        hit.tx = tangent.x();
        hit.ty = tangent.y();
        hit.tz = tangent.z();
    }

    /** Where the ray meets the figure, strictly between two values of t; not a number if it does not, or starts from it. */
    private double crossing(Ray ray, double from, double to) {
        if (part == ray.left) {
            return Double.NaN;
        }
        double dz = toLocal.directionZ(ray.dx, ray.dy, ray.dz);
        double z = toLocal.pointZ(ray.ox, ray.oy, ray.oz);
        if (z * dz > 0 && from >= 0) {
            // Behind the start: known before the division, which takes longer than all the rest.
            return Double.NaN;
        }
        double t = -z / dz;
        if (dz == 0 || !(t > from && t < to)) {
            return Double.NaN;
        }
        double x = toLocal.pointX(ray.ox, ray.oy, ray.oz) + t * toLocal.directionX(ray.dx, ray.dy, ray.dz);
        double y = toLocal.pointY(ray.ox, ray.oy, ray.oz) + t * toLocal.directionY(ray.dx, ray.dy, ray.dz);
        return holds(x, y) ? t : Double.NaN;
    }
}
