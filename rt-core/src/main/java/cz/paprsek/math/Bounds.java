package cz.paprsek.math;

/**
 * An axis-aligned box of space, closed, possibly unbounded in some directions, possibly empty
 * (empty when a minimum lies above its maximum).
 */
public record Bounds(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
    private static final double INF = Double.POSITIVE_INFINITY;

    public static final Bounds EMPTY = new Bounds(INF, INF, INF, -INF, -INF, -INF);
    public static final Bounds ALL = new Bounds(-INF, -INF, -INF, INF, INF, INF);

    public static Bounds of(Vec3 a, Vec3 b) {
        return new Bounds(
                Math.min(a.x(), b.x()), Math.min(a.y(), b.y()), Math.min(a.z(), b.z()),
                Math.max(a.x(), b.x()), Math.max(a.y(), b.y()), Math.max(a.z(), b.z()));
    }

    /** The box of half-widths {@code half} around a centre. */
    public static Bounds around(Vec3 centre, Vec3 half) {
        return of(centre.minus(half), centre.plus(half));
    }

    public boolean isEmpty() {
        return minX > maxX || minY > maxY || minZ > maxZ;
    }

    /** Whether the box is empty or all its sides are finite. */
    public boolean isFinite() {
        return isEmpty()
                || (Double.isFinite(maxX - minX) && Double.isFinite(maxY - minY) && Double.isFinite(maxZ - minZ));
    }

    /** The point in the middle; not a number if empty or without end. */
    public Vec3 middle() {
        return new Vec3((minX + maxX) / 2, (minY + maxY) / 2, (minZ + maxZ) / 2);
    }

    /** The space in the box; 0 if empty. */
    public double volume() {
        return isEmpty() ? 0 : (maxX - minX) * (maxY - minY) * (maxZ - minZ);
    }

    public boolean contains(Vec3 p) {
        return p.x() >= minX && p.x() <= maxX && p.y() >= minY && p.y() <= maxY && p.z() >= minZ && p.z() <= maxZ;
    }

    /** The smallest box that holds both. */
    public Bounds union(Bounds b) {
        return new Bounds(
                Math.min(minX, b.minX), Math.min(minY, b.minY), Math.min(minZ, b.minZ),
                Math.max(maxX, b.maxX), Math.max(maxY, b.maxY), Math.max(maxZ, b.maxZ));
    }

    /** What both have in common; empty if they do not meet. */
    public Bounds intersection(Bounds b) {
        Bounds common = new Bounds(
                Math.max(minX, b.minX), Math.max(minY, b.minY), Math.max(minZ, b.minZ),
                Math.min(maxX, b.maxX), Math.min(maxY, b.maxY), Math.min(maxZ, b.maxZ));
        return common.isEmpty() ? EMPTY : common;
    }

    /** The box grown on all sides by {@code margin}. */
    public Bounds grown(double margin) {
        return isEmpty() ? this
                : new Bounds(minX - margin, minY - margin, minZ - margin, maxX + margin, maxY + margin, maxZ + margin);
    }

    /** The box grown by more than the rounding errors of any arithmetic on its coordinates, so that no hit is lost at its faces. */
    public Bounds padded() {
        return grown(1e-12 * Math.min(magnitude(), Double.MAX_VALUE));
    }

    /** The corner farthest from the origin along each axis: the largest absolute coordinate in the box; 0 if empty. */
    public double magnitude() {
        return isEmpty() ? 0
                : Math.max(Math.max(Math.abs(minX), Math.abs(maxX)),
                        Math.max(Math.max(Math.abs(minY), Math.abs(maxY)), Math.max(Math.abs(minZ), Math.abs(maxZ))));
    }

    /** The box around this box after a map. */
    public Bounds transformed(Affine map) {
        if (isEmpty() || !isFinite()) {
            return isEmpty() ? EMPTY : ALL;
        }
        double cx = (minX + maxX) / 2;
        double cy = (minY + maxY) / 2;
        double cz = (minZ + maxZ) / 2;
        double hx = maxX - cx;
        double hy = maxY - cy;
        double hz = maxZ - cz;
        return around(
                new Vec3(map.pointX(cx, cy, cz), map.pointY(cx, cy, cz), map.pointZ(cx, cy, cz)),
                new Vec3(
                        Math.abs(map.xx()) * hx + Math.abs(map.xy()) * hy + Math.abs(map.xz()) * hz,
                        Math.abs(map.yx()) * hx + Math.abs(map.yy()) * hy + Math.abs(map.yz()) * hz,
                        Math.abs(map.zx()) * hx + Math.abs(map.zy()) * hy + Math.abs(map.zz()) * hz));
    }

    /** The tight box around the map's image of the ellipsoid with semi-axes a, b, c about the origin; 0 for a flat one. */
    public static Bounds ofEllipsoid(Affine map, double a, double b, double c) {
        return around(
                new Vec3(map.xt(), map.yt(), map.zt()),
                new Vec3(
                        norm(map.xx() * a, map.xy() * b, map.xz() * c),
                        norm(map.yx() * a, map.yy() * b, map.yz() * c),
                        norm(map.zx() * a, map.zy() * b, map.zz() * c)));
    }

    private static double norm(double a, double b, double c) {
        return Math.sqrt(a * a + b * b + c * c);
    }
}
