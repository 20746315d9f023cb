package cz.paprsek.render.hull;

import cz.paprsek.math.Bounds;
import cz.paprsek.shape.placed.Flat;

/** A wall of a room, and what tells without its map whether a ray that leaves the room through it meets it, and where. Immutable. */
final class Wall {
    private static final Stretch[] UNKNOWN = {new Stretch(0, Double.NaN), new Stretch(0, Double.NaN), new Stretch(0, Double.NaN)};

    final Flat flat;
    final int part;
    /** The figure's own z is factor · coordinate + shift, by the same numbers as by its map. */
    final double factor;
    final double shift;
    /** Along each axis, from the middle of the room: the middle of the wall, and how far it reaches from there; not a number if nothing is told by that. */
    final double middleX;
    final double middleY;
    final double middleZ;
    final double halfX;
    final double halfY;
    final double halfZ;

    /**
     * A wall of a room.
     *
     * @param low corner of the room
     * @param high the opposite one
     */
    Wall(Flat flat, double[] low, double[] high) {
        this(flat, flat.growth(), flat.fillsBounds() ? new Stretch[] {stretch(flat, 0, low, high), stretch(flat, 1, low, high), stretch(flat, 2, low, high)} : UNKNOWN);
    }

    private Wall(Flat flat, double factor, Stretch[] stretches) {
        this.flat = flat;
        this.factor = factor;
        part = flat.part();
        shift = flat.atOrigin();
        middleX = stretches[0].middle;
        middleY = stretches[1].middle;
        middleZ = stretches[2].middle;
        halfX = stretches[0].half;
        halfY = stretches[1].half;
        halfZ = stretches[2].half;
    }

    /** Where no wall is: nothing is told of it. Any other one stands for it. */
    static Wall none(Flat other) {
        return new Wall(other, Double.NaN, UNKNOWN);
    }

    /** What a wall covers along an axis, as far as the room goes. */
    private record Stretch(double middle, double half) {}

    private static Stretch stretch(Flat flat, int axis, double[] low, double[] high) {
        Bounds box = flat.bounds();
        double from = Math.max(low[axis], axis == 0 ? box.minX() : axis == 1 ? box.minY() : box.minZ());
        double to = Math.min(high[axis], axis == 0 ? box.maxX() : axis == 1 ? box.maxY() : box.maxZ());
        return new Stretch((from + to) / 2 - (low[axis] + high[axis]) / 2, (to - from) / 2);
    }
}
