package cz.paprsek.render.hull;

import cz.paprsek.shape.placed.Flat;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/**
 * The walls of a room: opaque figures in planes across the axes, each of which has all the others on one side. Where a ray leaves the room it crosses the
 * plane of one of them, and of those ahead it meets no other: not before, and not beyond, where none of them is. Immutable.
 *
 * <p>Here it is only decided which walls need not be met; the others are met as all bodies are. Whatever rounding may decide is left to them: where planes
 * are crossed in nearly one place, all ahead are met, and so is each that a ray starts near to, or beyond.
 */
public final class Hull {
    /** What is nearer than this, relative to the numbers it comes from, may be in one place: much more than {@link Ray#TOUCH}. */
    private static final double NEAR = 1e-9;
    /** Where there is no wall, there is a plane so many times as far as the others. */
    private static final double FAR = 1000;
    private static final int ALL = 63;
    private static final int SLOTS = 64;
    /** By how much of their numbers the parts of bodies follow each other, mostly. */
    private static final int APART = 4;
    /** No walls. */
    public static final Hull NONE = new Hull(new Flat[0], new int[0], new int[0]);

    /** By side, 2a at the low end of axis a, 2a + 1 at its high end; where there is none, another one. */
    private final Wall[] walls;
    /** By wall: which body it is, and its side. */
    private final int[] order;
    private final int[] sides;
    /** The sides that have a wall, a bit each. */
    private final int present;
    /** Along each axis, what lies midway between two planes, and how far they are from there. */
    private final double middleX;
    private final double middleY;
    private final double middleZ;
    private final double halfX;
    private final double halfY;
    private final double halfZ;
    private final double size;
    /** What is known of a ray that starts from a wall, found by the last digits of its part's number; of all others nothing is. */
    private final Start[] starts = new Start[SLOTS];
    private final Start anywhere;

    private Hull(Flat[] some, int[] order, int[] sides) {
        this.order = order;
        this.sides = sides;
        walls = new Wall[sides.length == 0 ? 0 : 6];
        double largest = 0;
        for (Flat wall : some) {
            largest = Math.max(largest, wall.bounds().magnitude());
        }
        double far = FAR * largest;
        double[] low = {-far, -far, -far};
        double[] high = {far, far, far};
        int found = 0;
        for (int i = 0; i < sides.length; i++) {
            int side = sides[i];
            (side % 2 == 0 ? low : high)[side / 2] = some[i].place();
            found |= 1 << side;
        }
        present = found;
        size = largest;
        middleX = (low[0] + high[0]) / 2;
        middleY = (low[1] + high[1]) / 2;
        middleZ = (low[2] + high[2]) / 2;
        halfX = (high[0] - low[0]) / 2;
        halfY = (high[1] - low[1]) / 2;
        halfZ = (high[2] - low[2]) / 2;
        anywhere = new Start(-1, ALL, halfX, halfY, halfZ);
        Arrays.fill(starts, anywhere);
        if (sides.length > 0) {
            Arrays.fill(walls, Wall.none(some[0]));
        }
        for (int i = 0; i < sides.length; i++) {
            int side = sides[i];
            int part = some[i].part();
            walls[side] = new Wall(some[i], side / 2, low, high);
            starts[slot(part)] = new Start(part, ALL - (1 << side), side / 2 == 0 ? Double.POSITIVE_INFINITY : halfX, side / 2 == 1 ? Double.POSITIVE_INFINITY : halfY,
                    side / 2 == 2 ? Double.POSITIVE_INFINITY : halfZ);
        }
    }

    /**
     * What is known of a ray by what it starts from.
     *
     * @param others all sides but that of the wall that it is: a ray does not meet again what it starts from
     * @param x how far from the middle it may start and be away from all walls but that one
     */
    private record Start(int part, int others, double x, double y, double z) {}

    /**
     * Of bodies that are walls.
     *
     * @param order their numbers, rising
     * @param sides by wall, no two the same
     */
    static Hull of(Flat[] walls, int[] order, int[] sides) {
        return sides.length == 0 ? NONE : new Hull(walls, order, sides);
    }

    /** Without the walls that are not kept: the others still have each other on one side. */
    public Hull only(IntPredicate isKept) {
        int[] kept = IntStream.range(0, order.length).filter(i -> isKept.test(order[i])).toArray();
        return kept.length == order.length ? this
                : of(Arrays.stream(kept).mapToObj(i -> walls[sides[i]].flat).toArray(Flat[]::new), Arrays.stream(kept).map(i -> order[i]).toArray(),
                        Arrays.stream(kept).map(i -> sides[i]).toArray());
    }

    /** Whether there are no walls. */
    public boolean isNone() {
        return present == 0;
    }

    /** Whether a body is one of the walls. */
    public boolean has(int body) {
        return Arrays.binarySearch(order, body) >= 0;
    }

    /** As of a surface. */
    public void nearest(Ray ray) {
        if (!isNone() && !leaves(ray)) {
            for (int left = near(ray, first(exit(ray), ray.reach)); left != 0; left &= left - 1) {
                walls[Integer.numberOfTrailingZeros(left)].flat.nearest(ray);
            }
        }
    }

    /**
     * As {@link #nearest}, of a ray that starts away from all walls but the one that it may start from, and leaves the room away from all but the one through which it leaves. Most do:
     * then that wall alone is met, and nearly always by its plane alone.
     *
     * @return false if it may not be such a ray; then no other wall has been met
     */
    private boolean leaves(Ray ray) {
        double slack = slack(ray);
        double x = ray.ox - middleX;
        double y = ray.oy - middleY;
        double z = ray.oz - middleZ;
        Start start = start(ray.left);
        if (!(start.x - Math.abs(x) > slack && start.y - Math.abs(y) > slack && start.z - Math.abs(z) > slack && ray.min >= -slack)) {
            return false;
        }
        double atX = (Math.copySign(halfX, ray.dx) - x) / ray.dx;
        double atY = (Math.copySign(halfY, ray.dy) - y) / ray.dy;
        double atZ = (Math.copySign(halfZ, ray.dz) - z) / ray.dz;
        if (atX < atY && atX < atZ) {
            Wall wall = walls[1 - isNegative(ray.dx)];
            double t = t(wall, ray.ox, ray.dx);
            return leaves(ray, wall, t, y + t * ray.dy, z + t * ray.dz, halfY - slack, halfZ - slack, slack);
        }
        if (atY < atZ) {
            Wall wall = walls[3 - isNegative(ray.dy)];
            double t = t(wall, ray.oy, ray.dy);
            return leaves(ray, wall, t, x + t * ray.dx, z + t * ray.dz, halfX - slack, halfZ - slack, slack);
        }
        Wall wall = walls[5 - isNegative(ray.dz)];
        double t = t(wall, ray.oz, ray.dz);
        return leaves(ray, wall, t, x + t * ray.dx, y + t * ray.dy, halfX - slack, halfY - slack, slack);
    }

    /** As above, where it crosses the plane of a wall: at p and q from the middle, where the room reaches up to halfP and halfQ, and by a slack farther. */
    private static boolean leaves(Ray ray, Wall wall, double t, double p, double q, double halfP, double halfQ, double slack) {
        if (isWithin(p, wall.middleP, wall.halfP - slack) && isWithin(q, wall.middleQ, wall.halfQ - slack)) {
            return meets(ray, wall, t);
        }
        return isWithin(p, 0, halfP) && isWithin(q, 0, halfQ) && asks(ray, wall);
    }

    /** Where a line crosses the plane of a wall, as it is told by its map. */
    private static double t(Wall wall, double o, double d) {
        return -(wall.factor * o + wall.shift) / (wall.factor * d);
    }

    private static boolean isWithin(double place, double middle, double half) {
        return Math.abs(place - middle) < half;
    }

    /** Makes a wall that the ray meets at t its hit, unless it ends before. */
    private static boolean meets(Ray ray, Wall wall, double t) {
        if (wall.part == ray.left) {
            return false;
        }
        if (t > ray.min && t < ray.reach) {
            ray.accept(t, wall.part, 0);
        }
        return true;
    }

    private static boolean asks(Ray ray, Wall wall) {
        wall.flat.nearest(ray);
        return wall.part != ray.left;
    }

    /** Whether a ray starts and ends away from all walls, but for the one it may start from: as most that look for a lamp in the room, so this is asked first. */
    private boolean isInside(Ray ray) {
        double slack = slack(ray);
        double x = ray.ox - middleX;
        double y = ray.oy - middleY;
        double z = ray.oz - middleZ;
        Start start = start(ray.left);
        return start.x - Math.abs(x) > slack && start.y - Math.abs(y) > slack && start.z - Math.abs(z) > slack && ray.min >= -slack
                && isWithin(x + ray.max * ray.dx, 0, halfX - slack) && isWithin(y + ray.max * ray.dy, 0, halfY - slack) && isWithin(z + ray.max * ray.dz, 0, halfZ - slack);
    }

    private Start start(int part) {
        Start known = starts[slot(part)];
        return known.part == part ? known : anywhere;
    }

    private static int slot(int part) {
        return part >> APART & (SLOTS - 1);
    }

    /** The wall that a ray meets between what touches its start and its end; null if none. */
    public @Nullable Surface occluder(Ray ray) {
        if (!isNone() && !isInside(ray)) {
            for (int left = near(ray, first(exit(ray), ray.max)); left != 0; left &= left - 1) {
                Flat wall = walls[Integer.numberOfTrailingZeros(left)].flat;
                if (wall.occludes(ray)) {
                    return wall;
                }
            }
        }
        return null;
    }

    /** As of a surface. */
    public void crossings(Ray ray, Spans out) {
        for (int left = isNone() ? 0 : near(ray, first(exit(ray), ray.max)); left != 0; left &= left - 1) {
            walls[Integer.numberOfTrailingZeros(left)].flat.crossings(ray, out);
        }
    }

    /** By when the first of the planes ahead has been crossed for certain, if the ray starts from where none is beyond. */
    private double exit(Ray ray) {
        double slack = slack(ray);
        double x = (halfX + slack - along(ray.ox - middleX, ray.dx)) / Math.abs(ray.dx);
        double y = (halfY + slack - along(ray.oy - middleY, ray.dy)) / Math.abs(ray.dy);
        double z = (halfZ + slack - along(ray.oz - middleZ, ray.dz)) / Math.abs(ray.dz);
        return first(first(x, y), z);
    }

    /** The sides of the walls that a ray may meet up to a t, a bit each: if no plane is crossed before, those near to the start, and those near to the end. */
    private int near(Ray ray, double t) {
        double slack = slack(ray);
        double x = along(ray.ox - middleX, ray.dx);
        double y = along(ray.oy - middleY, ray.dy);
        double z = along(ray.oz - middleZ, ray.dz);
        int known = present & start(ray.left).others;
        return halfX - x > slack && halfY - y > slack && halfZ - z > slack && ray.min >= -slack
                ? known & (sides(halfX - slack, x, ray.dx, t) | sides(halfY - slack, y, ray.dy, t) << 2 | sides(halfZ - slack, z, ray.dz, t) << 4) : known;
    }

    private double slack(Ray ray) {
        return NEAR * (size + ray.scale);
    }

    /** How far from the middle a ray starts, along its way. */
    private static double along(double from, double d) {
        return from * Math.copySign(1, d);
    }

    /** Which of the two sides across an axis are near, without a branch: which way a ray goes cannot be foretold. */
    private static int sides(double half, double along, double d, double t) {
        int behind = isNegative(half + along);
        int ahead = isNegative(half - along - t * Math.abs(d));
        int backwards = isNegative(d);
        return behind << backwards | ahead << (1 - backwards);
    }

    /** The lesser of two numbers not below 0. */
    private static double first(double a, double b) {
        return Double.longBitsToDouble(Math.min(Double.doubleToRawLongBits(a), Double.doubleToRawLongBits(b)));
    }

    private static int isNegative(double d) {
        return (int) (Double.doubleToRawLongBits(d) >>> 63);
    }
}
