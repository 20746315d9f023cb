package cz.paprsek.math;

/**
 * An affine map of space: p ↦ M·p + t, stored as three rows of four numbers. Row i gives coordinate i of the result:
 * {@code x' = xx·x + xy·y + xz·z + xt}, and so on.
 */
public record Affine(
        double xx, double xy, double xz, double xt,
        double yx, double yy, double yz, double yt,
        double zx, double zy, double zz, double zt) {

    /** The volume of a block with edges of length 1 that counts as flat: there are few digits left of its normals. */
    private static final double FLAT = 1e-11;

    public static final Affine IDENTITY = new Affine(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);

    public static Affine translation(Vec3 by) {
        return new Affine(1, 0, 0, by.x(), 0, 1, 0, by.y(), 0, 0, 1, by.z());
    }

    public static Affine scaling(Vec3 by) {
        return new Affine(by.x(), 0, 0, 0, 0, by.y(), 0, 0, 0, 0, by.z(), 0);
    }

    /** The same numbers as the translation after the scaling has. */
    public static Affine scalingAndMoving(Vec3 factors, Vec3 by) {
        // A sum with 0 makes −0 positive, as it is in a product of matrices.
        return new Affine(factors.x(), 0, 0, 0 + by.x(), 0, factors.y(), 0, 0 + by.y(), 0, 0, factors.z(), 0 + by.z());
    }

    /** Turns about the x axis, then y, then z, each counter-clockwise seen from the positive end of its axis; angles in degrees. */
    public static Affine rotation(Vec3 degrees) {
        double sx = Angles.sin(degrees.x());
        double cx = Angles.cos(degrees.x());
        double sy = Angles.sin(degrees.y());
        double cy = Angles.cos(degrees.y());
        double sz = Angles.sin(degrees.z());
        double cz = Angles.cos(degrees.z());
        return new Affine(
                cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx, 0,
                sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx, 0,
                -sy, cy * sx, cy * cx, 0);
    }

    /** The map that applies {@code first} and then this one. */
    public Affine after(Affine first) {
        Affine b = first;
        return new Affine(
                xx * b.xx + xy * b.yx + xz * b.zx, xx * b.xy + xy * b.yy + xz * b.zy,
                xx * b.xz + xy * b.yz + xz * b.zz, xx * b.xt + xy * b.yt + xz * b.zt + xt,
                yx * b.xx + yy * b.yx + yz * b.zx, yx * b.xy + yy * b.yy + yz * b.zy,
                yx * b.xz + yy * b.yz + yz * b.zz, yx * b.xt + yy * b.yt + yz * b.zt + yt,
                zx * b.xx + zy * b.yx + zz * b.zx, zx * b.xy + zy * b.yy + zz * b.zy,
                zx * b.xz + zy * b.yz + zz * b.zz, zx * b.xt + zy * b.yt + zz * b.zt + zt);
    }

    /**
     * The map that undoes this one. Its columns are first scaled, by powers of two so that no digit changes, to about length 1: a shape may be
     * drawn out along one of its axes by any factor, and turned after that.
     *
     * @throws IllegalArgumentException if this map flattens space
     */
    public Affine inverse() {
        double sx = powerOfTwoNear(xx, yx, zx);
        double sy = powerOfTwoNear(xy, yy, zy);
        double sz = powerOfTwoNear(xz, yz, zz);
        return IDENTITY.withColumnsOver(sx, sy, sz).after(withColumnsOver(sx, sy, sz).adjugateOverDeterminant());
    }

    /**
     * Whether there is a way back that deserves the name: no axis is stretched or shrunk beyond {@link Require#LARGEST} and
     * {@link Require#SMALLEST}, and the three are not bent into one plane. One axis may be drawn out against the others by any factor.
     */
    public boolean isSane() {
        double x = length(xx, yx, zx);
        double y = length(xy, yy, zy);
        double z = length(xz, yz, zz);
        double most = Math.max(Math.abs(xt), Math.max(Math.abs(yt), Math.abs(zt)));
        if (!(Math.min(x, Math.min(y, z)) >= Require.SMALLEST && Math.max(Math.max(x, y), Math.max(z, most)) <= Require.LARGEST)) {
            return false;
        }
        return Math.abs(withColumnsOver(x, y, z).determinant()) > FLAT;
    }

    private static double length(double x, double y, double z) {
        return new Vec3(x, y, z).length();
    }

    private double determinant() {
        return xx * (yy * zz - yz * zy) + xy * (yz * zx - yx * zz) + xz * (yx * zy - yy * zx);
    }

    private Affine withColumnsOver(double sx, double sy, double sz) {
        return new Affine(xx / sx, xy / sy, xz / sz, xt, yx / sx, yy / sy, yz / sz, yt, zx / sx, zy / sy, zz / sz, zt);
    }

    /** A power of two not far from the length of a vector; 1 for the vector 0. */
    private static double powerOfTwoNear(double x, double y, double z) {
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        return largest == 0 ? 1 : Math.scalb(1.0, Math.getExponent(largest));
    }

    private Affine adjugateOverDeterminant() {
        double a = yy * zz - yz * zy;
        double b = yz * zx - yx * zz;
        double c = yx * zy - yy * zx;
        double k = 1 / (xx * a + xy * b + xz * c);
        Require.that(Double.isFinite(k) && k != 0, "a placement must not flatten space");
        double ixx = a * k;
        double ixy = (xz * zy - xy * zz) * k;
        double ixz = (xy * yz - xz * yy) * k;
        double iyx = b * k;
        double iyy = (xx * zz - xz * zx) * k;
        double iyz = (xz * yx - xx * yz) * k;
        double izx = c * k;
        double izy = (xy * zx - xx * zy) * k;
        double izz = (xx * yy - xy * yx) * k;
        return new Affine(
                ixx, ixy, ixz, -(ixx * xt + ixy * yt + ixz * zt),
                iyx, iyy, iyz, -(iyx * xt + iyy * yt + iyz * zt),
                izx, izy, izz, -(izx * xt + izy * yt + izz * zt));
    }

    /** Where a point goes. */
    public Vec3 point(Vec3 p) {
        return new Vec3(pointX(p.x(), p.y(), p.z()), pointY(p.x(), p.y(), p.z()), pointZ(p.x(), p.y(), p.z()));
    }

    /** Where a direction goes: the map without its translation. The length is not kept. */
    public Vec3 direction(Vec3 d) {
        return new Vec3(
                directionX(d.x(), d.y(), d.z()), directionY(d.x(), d.y(), d.z()), directionZ(d.x(), d.y(), d.z()));
    }

    public double pointX(double x, double y, double z) {
        return xx * x + xy * y + xz * z + xt;
    }

    public double pointY(double x, double y, double z) {
        return yx * x + yy * y + yz * z + yt;
    }

    public double pointZ(double x, double y, double z) {
        return zx * x + zy * y + zz * z + zt;
    }

    public double directionX(double x, double y, double z) {
        return xx * x + xy * y + xz * z;
    }

    public double directionY(double x, double y, double z) {
        return yx * x + yy * y + yz * z;
    }

    public double directionZ(double x, double y, double z) {
        return zx * x + zy * y + zz * z;
    }

    /** Whether every axis is mapped onto a multiple of an axis, so that an axis-aligned box stays one. */
    public boolean keepsAxes() {
        return zeros(xx, xy, xz) == 2 && zeros(yx, yy, yz) == 2 && zeros(zx, zy, zz) == 2;
    }

    /** Whether the directions of the axes change: if not, each is only stretched. */
    public boolean turns() {
        return !(xx > 0 && yy > 0 && zz > 0 && xy == 0 && xz == 0 && yx == 0 && yz == 0 && zx == 0 && zy == 0);
    }

    /** Whether left becomes right: what runs counter-clockwise as seen from outside runs clockwise after the map. */
    public boolean mirrors() {
        return determinant() < 0;
    }

    /**
     * The factor by which every length is multiplied, or 0 if lengths in different directions change differently.
     * A map counts as a similarity if its columns agree in length, and are perpendicular, to within 1e-14.
     */
    public double uniformScale() {
        double x = xx * xx + yx * yx + zx * zx;
        double y = xy * xy + yy * yy + zy * zy;
        double z = xz * xz + yz * yz + zz * zz;
        double slack = 1e-14 * x;
        boolean similar = Math.abs(x - y) <= slack && Math.abs(x - z) <= slack
                && Math.abs(xx * xy + yx * yy + zx * zy) <= slack
                && Math.abs(xx * xz + yx * yz + zx * zz) <= slack
                && Math.abs(xy * xz + yy * yz + zy * zz) <= slack;
        return similar ? Math.sqrt(x) : 0;
    }

    /** At least the factor by which the length of any direction is multiplied (Frobenius norm). With that of the inverse, their product says how errors grow. */
    public double norm() {
        return Math.sqrt(xx * xx + xy * xy + xz * xz + yx * yx + yy * yy + yz * yz + zx * zx + zy * zy + zz * zz);
    }

    private static int zeros(double a, double b, double c) {
        return (a == 0 ? 1 : 0) + (b == 0 ? 1 : 0) + (c == 0 ? 1 : 0);
    }
}
