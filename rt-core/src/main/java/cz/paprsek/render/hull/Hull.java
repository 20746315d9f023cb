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
    /** No walls. */
    public static final Hull NONE = new Hull(new Flat[0], new int[0], new int[0]);

    /** By side, 2a at the low end of axis a, 2a + 1 at its high end; where there is none, another one. */
    private final Flat[] walls;
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
    /** The last bits of the numbers of parts lead to those of walls, and to all sides but that wall's: a ray does not meet again what it starts from. */
    private final int[] parts = new int[SLOTS];
    private final int[] others = new int[SLOTS];

    private Hull(Flat[] some, int[] order, int[] sides) {
        this.order = order;
        this.sides = sides;
        walls = new Flat[sides.length == 0 ? 0 : 6];
        Arrays.fill(parts, -1);
        Arrays.fill(others, ALL);
        double largest = 0;
        for (Flat wall : some) {
            Arrays.fill(walls, wall);
            largest = Math.max(largest, wall.bounds().magnitude());
        }
        double far = FAR * largest;
        double[] place = {-far, far, -far, far, -far, far};
        int found = 0;
        for (int i = 0; i < sides.length; i++) {
            int side = sides[i];
            int part = some[i].part();
            walls[side] = some[i];
            place[side] = some[i].place();
            found |= 1 << side;
            parts[part & (SLOTS - 1)] = part;
            others[part & (SLOTS - 1)] = ALL - (1 << side);
        }
        present = found;
        size = largest;
        middleX = (place[0] + place[1]) / 2;
        middleY = (place[2] + place[3]) / 2;
        middleZ = (place[4] + place[5]) / 2;
        halfX = (place[1] - place[0]) / 2;
        halfY = (place[3] - place[2]) / 2;
        halfZ = (place[5] - place[4]) / 2;
    }

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
                : of(Arrays.stream(kept).mapToObj(i -> walls[sides[i]]).toArray(Flat[]::new), Arrays.stream(kept).map(i -> order[i]).toArray(),
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
        for (int left = isNone() ? 0 : near(ray, first(exit(ray), ray.reach)); left != 0; left &= left - 1) {
            walls[Integer.numberOfTrailingZeros(left)].nearest(ray);
        }
    }

    /** The wall that a ray meets between what touches its start and its end; null if none. */
    public @Nullable Surface occluder(Ray ray) {
        if (!isNone() && near(ray, ray.max) != 0) {
            for (int left = near(ray, first(exit(ray), ray.max)); left != 0; left &= left - 1) {
                Flat wall = walls[Integer.numberOfTrailingZeros(left)];
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
            walls[Integer.numberOfTrailingZeros(left)].crossings(ray, out);
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
        int slot = ray.left & (SLOTS - 1);
        int known = parts[slot] == ray.left ? present & others[slot] : present;
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
