package cz.paprsek.shape.placed;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;

/**
 * A body of flat sides about the y axis, between two polygons of equal sides: met as what lies between its two lids and behind the planes of all
 * its sides, x·cos φ + z·sin φ ≤ a + k·y.
 */
public final class Sided extends LocalConvex {
    /** The number of the lid below; that above has the next. */
    public static final int BOTTOM = 0;
    /** The number of the first side. */
    public static final int FIRST_SIDE = 2;

    private final int sides;
    private final double radius;
    private final double topRadius;
    private final double height;
    /** From the axis to the middle of a side of the bottom. */
    private final double middle;
    private final double slope;
    private final double[] cosines;
    private final double[] sines;

    /**
     * Places it.
     *
     * @param radius of the bottom's corners, y = 0; one lies towards +x
     * @param topRadius of the top's corners
     */
    public Sided(int part, Affine toWorld, int sides, double radius, double topRadius, double height) {
        super(part, toWorld, worldBounds(toWorld, sides, radius, topRadius, height));
        this.sides = sides;
        this.radius = radius;
        this.topRadius = topRadius;
        this.height = height;
        double toMiddle = StrictMath.cos(Math.PI / sides);
        middle = radius * toMiddle;
        slope = (topRadius - radius) * toMiddle / height;
        cosines = new double[sides];
        sines = new double[sides];
        for (int i = 0; i < sides; i++) {
            cosines[i] = StrictMath.cos(angle(i + 0.5, sides));
            sines[i] = StrictMath.sin(angle(i + 0.5, sides));
        }
    }

    /** Where a corner of a polygon lies: how far along the circle around it, from +x to +z. */
    public static double angle(double corner, int sides) {
        return 2 * Math.PI * corner / sides;
    }

    /** A corner at a height above the bottom. */
    public static Vec3 corner(int i, int sides, double radius, double y) {
        double angle = angle(i, sides);
        return new Vec3(radius * StrictMath.cos(angle), y, radius * StrictMath.sin(angle));
    }

    /** The box around all corners. */
    public static Bounds worldBounds(Affine toWorld, int sides, double radius, double topRadius, double height) {
        Bounds all = Bounds.EMPTY;
        for (int i = 0; i < sides; i++) {
            Vec3 bottom = toWorld.point(corner(i, sides, radius, 0));
            Vec3 top = toWorld.point(corner(i, sides, topRadius, height));
            all = all.union(Bounds.of(bottom, bottom)).union(Bounds.of(top, top));
        }
        return all;
    }

    @Override
    public double cost() {
        return 2 + sides / 4.0;
    }

    @Override
    protected boolean clip(Line line, Ray ray) {
        open(ray);
        if (!narrow(ray, line.oy, line.dy, 0, height, BOTTOM)) {
            return false;
        }
        for (int i = 0; i < sides; i++) {
            double outside = line.ox * cosines[i] + line.oz * sines[i] - slope * line.oy - middle;
            double rate = line.dx * cosines[i] + line.dz * sines[i] - slope * line.dy;
            double at = -outside / rate;
            boolean isLeft = rate > 0 ? narrow(ray, Double.NEGATIVE_INFINITY, 0, at, FIRST_SIDE + i)
                    : rate < 0 ? narrow(ray, at, FIRST_SIDE + i, Double.POSITIVE_INFINITY, 0) : outside < 0;
            if (!isLeft) {
                return false;
            }
        }
        return true;
    }

    @Override
    protected void describe(int face, double x, double y, double z, Affine toLocal, Hit hit) {
        if (face >= FIRST_SIDE) {
            hit.normal(toLocal, cosines[face - FIRST_SIDE], -slope, sines[face - FIRST_SIDE]);
        } else {
            hit.normal(toLocal, 0, face == BOTTOM ? -1 : 1, 0);
        }
    }

    /** Around it as around a cylinder, each side as wide as every other. */
    @Override
    protected void map(int face, double x, double y, double z, Hit hit) {
        if (face < FIRST_SIDE) {
            hit.mapLid(x, z, face == BOTTOM ? radius : topRadius, face != BOTTOM);
            return;
        }
        int side = face - FIRST_SIDE;
        double share = y / height;
        double wide = 2 * (radius + (topRadius - radius) * share) * StrictMath.sin(Math.PI / sides);
        double along = wide > 0 ? (x * sines[side] - z * cosines[side]) / wide : 0;
        double u = 0.75 + (along - side - 0.5) / sides;
        hit.map(u - Math.floor(u), share, sines[side], 0, -cosines[side]);
    }
}
