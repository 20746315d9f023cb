package cz.paprsek.render.hull;

import cz.paprsek.math.Bounds;
import cz.paprsek.shape.placed.Flat;
import cz.paprsek.shape.placed.Surface;
import java.util.Arrays;
import java.util.stream.IntStream;

/** Finds the walls of a room among bodies, for a {@link Hull}. */
public final class Walls {
    /** Fewer are bodies like others. */
    private static final int LEAST = 3;
    /** How far, relative to its numbers, a wall may stand beyond the plane of another one. */
    private static final double SLACK = 1e-12;
    /** How many times as large as the room the scene may be: beside a small one most rays would be asked about it for nothing. */
    private static final double LARGEST = 2;

    private Walls() {}

    /**
     * Of those that are the outermost ones along an axis, each that is the only one at its end.
     *
     * @param finite the bodies that have an end
     */
    public static Hull among(Surface[] surfaces, boolean[] opaque, int[] finite) {
        int[] some = Arrays.stream(finite).filter(i -> opaque[i] && surfaces[i] instanceof Flat flat && flat.axis() >= 0).sorted().toArray();
        Bounds around = Bounds.EMPTY;
        for (int before = -1; some.length != before;) {
            if (some.length < LEAST) {
                return Hull.NONE;
            }
            before = some.length;
            Bounds box = around(surfaces, some);
            some = Arrays.stream(some).filter(i -> side(box, flat(surfaces, i)) >= 0).toArray();
            around = box;
        }
        int[] at = new int[6];
        for (int i : some) {
            at[side(around, flat(surfaces, i))]++;
        }
        Bounds room = around;
        int[] walls = Arrays.stream(some).filter(i -> at[side(room, flat(surfaces, i))] == 1).toArray();
        if (walls.length < LEAST || !isMostOf(around(surfaces, finite), room)) {
            return Hull.NONE;
        }
        return Hull.of(Arrays.stream(walls).mapToObj(i -> flat(surfaces, i)).toArray(Flat[]::new), walls,
                Arrays.stream(walls).map(i -> side(room, flat(surfaces, i))).toArray());
    }

    private static Flat flat(Surface[] surfaces, int i) {
        return (Flat) surfaces[i];
    }

    private static Bounds around(Surface[] surfaces, int[] some) {
        return IntStream.of(some).mapToObj(i -> surfaces[i].bounds()).reduce(Bounds.EMPTY, Bounds::union);
    }

    /** At which side of a box a figure lies; −1 if at none, or if that has no width. */
    private static int side(Bounds box, Flat flat) {
        double slack = SLACK * box.magnitude();
        int axis = flat.axis();
        double low = flat.place() - (axis == 0 ? box.minX() : axis == 1 ? box.minY() : box.minZ());
        double high = (axis == 0 ? box.maxX() : axis == 1 ? box.maxY() : box.maxZ()) - flat.place();
        return Math.abs(low) <= slack ? high <= slack ? -1 : 2 * axis : Math.abs(high) <= slack ? 2 * axis + 1 : -1;
    }

    private static boolean isMostOf(Bounds all, Bounds room) {
        return all.maxX() - all.minX() <= LARGEST * (room.maxX() - room.minX()) && all.maxY() - all.minY() <= LARGEST * (room.maxY() - room.minY())
                && all.maxZ() - all.minZ() <= LARGEST * (room.maxZ() - room.minZ());
    }
}
