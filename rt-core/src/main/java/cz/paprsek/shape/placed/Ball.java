package cz.paprsek.shape.placed;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Hit;
import org.jspecify.annotations.Nullable;

/**
 * A ball in world space. With l from the eye to the centre and b = l·d the distance to the point of the ray nearest to it,
 * the crossings are b ± √(r² − |l − b·d|²). The nearest point is formed first: |l|² − b² would lose the digits of a small
 * sphere far away.
 *
 * @source Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems ch. 7, 2019
 */
public final class Ball extends Convex {
    private final double x;
    private final double y;
    private final double z;
    private final double radius;
    /** From its own axes to the world; null if they are those of the world. */
    private final @Nullable Affine fromOwn;

    /** @param fromOwn from its own space to the world: changes all lengths alike */
    public Ball(int part, Affine fromOwn, double radius) {
        super(part);
        this.fromOwn = fromOwn.turns() ? fromOwn : null;
        x = fromOwn.xt();
        y = fromOwn.yt();
        z = fromOwn.zt();
        this.radius = radius;
    }

    @Override
    public Bounds bounds() {
        return new Bounds(x - radius, y - radius, z - radius, x + radius, y + radius, z + radius);
    }

    @Override
    protected boolean clip(Ray ray) {
        double middle = middle(ray);
        double half = half(ray, middle);
        if (!(half > 0)) {
            return false;
        }
        double s = Math.sqrt(half);
        ray.enter = middle - s;
        ray.leave = middle + s;
        ray.enterFace = 0;
        ray.leaveFace = 0;
        return true;
    }

    @Override
    public void nearest(Ray ray) {
        if (part == ray.left) {
            super.nearest(ray);
            return;
        }
        double middle = middle(ray);
        double half = half(ray, middle);
        if (half > 0) {
            double s = Math.sqrt(half);
            double t = middle - s > ray.min ? middle - s : middle + s;
            if (t > ray.min && t < ray.reach) {
                ray.accept(t, part, 0);
            }
        }
    }

    @Override
    public void describe(int face, Hit hit) {
        hit.normal(hit.px - x, hit.py - y, hit.pz - z);
    }

    @Override
    public void map(int face, Hit hit) {
        double px = hit.px - x;
        double py = hit.py - y;
        double pz = hit.pz - z;
        Affine own = fromOwn;
        if (own == null) {
            hit.mapGlobe(px, py, pz);
            return;
        }
        // Of a similarity the transpose is the inverse, but for the size.
        hit.mapGlobe(own.xx() * px + own.yx() * py + own.zx() * pz, own.xy() * px + own.yy() * py + own.zy() * pz,
                own.xz() * px + own.yz() * py + own.zz() * pz);
        hit.map(hit.u, hit.v, own.directionX(hit.tx, hit.ty, hit.tz), own.directionY(hit.tx, hit.ty, hit.tz), own.directionZ(hit.tx, hit.ty, hit.tz));
    }

    private double middle(Ray ray) {
        return middle(ray, x, y, z);
    }

    private static double middle(Ray ray, double x, double y, double z) {
        return (x - ray.ox) * ray.dx + (y - ray.oy) * ray.dy + (z - ray.oz) * ray.dz;
    }

    private double half(Ray ray, double middle) {
        return half(ray, middle, x, y, z, radius * radius);
    }

    /** The square of half the chord of a ball of squared radius r2; not positive if the ray passes by. */
    private static double half(Ray ray, double middle, double x, double y, double z, double r2) {
        double px = x - ray.ox - middle * ray.dx;
        double py = y - ray.oy - middle * ray.dy;
        double pz = z - ray.oz - middle * ray.dz;
        return r2 - (px * px + py * py + pz * pz);
    }

    static double half(Ray ray, double x, double y, double z, double r2) {
        return half(ray, middle(ray, x, y, z), x, y, z, r2);
    }

    /** Itself: whoever asks so reckons as it is met. */
    @Override
    protected void putAround(double[] into, int at) {
        put(into, at);
    }

    /** Writes centre and squared radius. */
    void put(double[] into, int at) {
        into[at] = x;
        into[at + 1] = y;
        into[at + 2] = z;
        into[at + 3] = radius * radius;
    }
}
