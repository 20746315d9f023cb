package cz.paprsek.shape;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import java.util.List;

/** A ball about the origin. */
@Element("A ball about its origin.")
public record Sphere(@Attribute(value = Kind.POSITIVE, means = "Above 0") double radius) implements Solid {
    public Sphere {
        Require.size("sphere radius", radius);
    }

    @Override
    public Bounds bounds() {
        return Bounds.around(Vec3.ZERO, new Vec3(radius, radius, radius));
    }

    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        return List.of(Outlines.ellipsoid(new Vec3(radius, radius, radius), along, steps));
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return place(toWorld, radius, radius, radius, parts);
    }

    /** A ball stays a ball as long as no direction is stretched more than another; else it is met as the unit ball in its own space. */
    static Volume place(Affine toWorld, double a, double b, double c, Parts parts) {
        Affine fromUnit = toWorld.after(Affine.scaling(new Vec3(a, b, c)));
        double radius = fromUnit.uniformScale();
        return radius > 0
                ? parts.add(part -> new Ball(part, toWorld.xt(), toWorld.yt(), toWorld.zt(), radius))
                : parts.add(part -> new Ellipsoid.Placed(part, fromUnit));
    }

    /**
     * The sphere in world space. With l from the eye to the centre and b = l·d the distance to the point of the ray nearest to it,
     * the crossings are b ± √(r² − |l − b·d|²). The nearest point is formed first: |l|² − b² would lose the digits of a small
     * sphere far away.
     *
     * @source Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems ch. 7, 2019
     */
    static final class Ball extends Convex {
        private final double x;
        private final double y;
        private final double z;
        private final double radius;

        Ball(int part, double x, double y, double z, double radius) {
            super(part);
            this.x = x;
            this.y = y;
            this.z = z;
            this.radius = radius;
        }

        @Override
        public Bounds bounds() {
            return Bounds.around(new Vec3(x, y, z), new Vec3(radius, radius, radius));
        }

        @Override
        boolean clip(Ray ray) {
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
            hit.unitNormal(hit.px - x, hit.py - y, hit.pz - z);
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

        /** Writes centre and squared radius. */
        void put(double[] into, int at) {
            into[at] = x;
            into[at + 1] = y;
            into[at + 2] = z;
            into[at + 3] = radius * radius;
        }
    }
}
