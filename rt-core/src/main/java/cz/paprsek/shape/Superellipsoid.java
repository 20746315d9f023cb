package cz.paprsek.shape;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.outline.Drawn;
import cz.paprsek.shape.placed.Bulge;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Volume;
import cz.paprsek.text.Numbers;
import java.util.List;

/**
 * Between ellipsoid, block, cylinder and double pyramid: with x, y and z in semi-axes, e = east and n = north,
 * (|x|^(2/e) + |z|^(2/e))^(e/n) + |y|^(2/n) ≤ 1. Ones make an ellipsoid, numbers near 0 a block, an east of 1 and a north near 0 a cylinder, twos an
 * octahedron. Beyond 2 it would not be convex.
 *
 * @source Barr, Superquadrics and Angle-Preserving Transformations, IEEE CG&amp;A 1(1), 1981; the exponents are named as in POV-Ray, with y for its z
 */
@Element("A body between an ellipsoid and a block about its origin.")
public record Superellipsoid(
        @Attribute(value = Kind.POSITIVE_VECTOR, means = "Along x, y and z", example = "0.5 0.5 0.5") Vec3 semiAxes,
        @Attribute(value = Kind.ROUNDNESS, means = "How round it is seen from above: square near 0, round at 1, slanted at 2", otherwise = "1", example = "0.4") double east,
        @Attribute(value = Kind.ROUNDNESS, means = "How round it is seen from the side", otherwise = "1", example = "0.4") double north) implements Solid {
    public Superellipsoid {
        Require.size("superellipsoid semi-axis x", semiAxes.x());
        Require.size("superellipsoid semi-axis y", semiAxes.y());
        Require.size("superellipsoid semi-axis z", semiAxes.z());
        roundness("east", east);
        roundness("north", north);
    }

    private static void roundness(String which, double value) {
        Require.that(value > 0 && value <= Kind.ROUNDNESS.most(), "superellipsoid " + which + " must be " + Kind.ROUNDNESS.words() + ", but is " + Numbers.text(value));
    }

    @Override
    public Bounds bounds() {
        return Bounds.around(Vec3.ZERO, semiAxes);
    }

    /**
     * The points that lie farthest out in the directions at right angles to the view: where the function that says how far that is grows
     * fastest. That is of the same form, of exponents p/(p − 1).
     */
    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Vec3 view = new Vec3(along.x() / semiAxes.x(), along.y() / semiAxes.y(), along.z() / semiAxes.z());
        return List.of(new Curve(Drawn.ellipsoid(Vec3.ONE, view, steps).points().stream().map(this::farthest).toList()));
    }

    private Vec3 farthest(Vec3 towards) {
        double p = dual(east);
        double q = dual(north);
        double rho = together(towards.x(), towards.z(), p);
        double outwards = ofLarger(rho, towards.y(), q);
        return new Vec3(semiAxes.x() * outwards * ofLarger(towards.x(), towards.z(), p), semiAxes.y() * ofSmaller(towards.y(), rho, q),
                semiAxes.z() * outwards * ofSmaller(towards.z(), towards.x(), p));
    }

    /** How fast {@link #together} grows with a; with an infinite exponent only if a is the larger. */
    private static double ofLarger(double a, double b, double p) {
        return p < Double.POSITIVE_INFINITY ? share(a, together(a, b, p), p) : Math.abs(a) >= Math.abs(b) ? Math.signum(a) : 0;
    }

    /** The same, but where both are as large none of it. */
    private static double ofSmaller(double a, double b, double p) {
        return p < Double.POSITIVE_INFINITY ? share(a, together(a, b, p), p) : Math.abs(a) > Math.abs(b) ? Math.signum(a) : 0;
    }

    /** The exponent that belongs to 2/e as p/(p − 1) to p. */
    private static double dual(double e) {
        return 2 / (2 - e);
    }

    /** (|a|^p + |b|^p)^(1/p), also where the powers are no numbers. */
    static double together(double a, double b, double p) {
        double large = Math.max(Math.abs(a), Math.abs(b));
        double small = Math.min(Math.abs(a), Math.abs(b));
        return small == 0 || p == Double.POSITIVE_INFINITY ? large : large * StrictMath.pow(1 + StrictMath.pow(small / large, p), 1 / p);
    }

    /** How fast that grows with a. */
    static double share(double a, double together, double p) {
        return a == 0 ? 0 : Math.copySign(StrictMath.pow(Math.abs(a) / together, p - 1), a);
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return parts.add(part -> new Placed(part, toWorld.after(Affine.scaling(semiAxes)), this));
    }

    /** Met in the space of its semi-axes, by the distance of a kind of which it is the unit ball: a convex function. */
    private static final class Placed extends Bulge {
        private final double p;
        private final double q;

        Placed(int part, Affine fromUnit, Superellipsoid shape) {
            super(part, fromUnit, worldBounds(fromUnit, dual(shape.east), dual(shape.north)), Bounds.around(Vec3.ZERO, Vec3.ONE));
            p = 2 / shape.east;
            q = 2 / shape.north;
        }

        private static Bounds worldBounds(Affine map, double p, double q) {
            Vec3 half = new Vec3(together(together(map.xx(), map.xz(), p), map.xy(), q), together(together(map.yx(), map.yz(), p), map.yy(), q),
                    together(together(map.zx(), map.zz(), p), map.zy(), q));
            return Bounds.around(new Vec3(map.xt(), map.yt(), map.zt()), half);
        }

        @Override
        public double cost() {
            return 40;
        }

        @Override
        protected void form(Line line, double t, double[] out) {
            double x = line.ox + t * line.dx;
            double y = line.oy + t * line.dy;
            double z = line.oz + t * line.dz;
            double rho = together(x, z, p);
            double size = together(rho, y, q);
            out[0] = size - 1;
            out[1] = share(rho, size, q) * (share(x, rho, p) * line.dx + share(z, rho, p) * line.dz) + share(y, size, q) * line.dy;
        }

        @Override
        protected void describe(int face, double x, double y, double z, Affine toLocal, Hit hit) {
            double rho = together(x, z, p);
            double size = together(rho, y, q);
            double outwards = share(rho, size, q);
            hit.normal(toLocal, outwards * share(x, rho, p), share(y, size, q), outwards * share(z, rho, p));
        }

        /** As a globe, but the latitude is by the distance from the axis of its own kind, so that it is the same all along a level curve. */
        @Override
        protected void map(int face, double x, double y, double z, Hit hit) {
            double rho = together(x, z, p);
            hit.mapAround(x, z, 0.5 + StrictMath.atan2(y, rho) / Math.PI);
            if (rho > 0) {
                hit.map(hit.u, hit.v, share(z, rho, p), 0, -share(x, rho, p));
            }
        }
    }
}
