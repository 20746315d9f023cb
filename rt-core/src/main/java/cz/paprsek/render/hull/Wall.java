package cz.paprsek.render.hull;

import cz.paprsek.math.Bounds;
import cz.paprsek.shape.placed.Flat;

/** A wall of a room, and what tells without its map whether a ray that leaves the room through it meets it, and where. Immutable. */
final class Wall {
    private static final Stretch UNKNOWN = new Stretch(0, Double.NaN);

    final Flat flat;
    final int part;
    /** The figure's own z is factor · coordinate + shift, by the same numbers as by its map. */
    final double factor;
    final double shift;
    /** Along the two axes that it lies along, from the middle of the room: the middle of the wall, and how far it reaches from there; not a number if nothing is told by that. */
    final double middleP;
    final double halfP;
    final double middleQ;
    final double halfQ;

    /**
     * A wall of a room.
     *
     * @param axis across which it lies
     * @param low corner of the room
     * @param high the opposite one
     */
    Wall(Flat flat, int axis, double[] low, double[] high) {
        this(flat, flat.growth(), stretch(flat, axis == 0 ? 1 : 0, low, high), stretch(flat, axis == 2 ? 1 : 2, low, high));
    }

    private Wall(Flat flat, double factor, Stretch p, Stretch q) {
        this.flat = flat;
        this.factor = factor;
        part = flat.part();
        shift = flat.atOrigin();
        middleP = p.middle;
        halfP = p.half;
        middleQ = q.middle;
        halfQ = q.half;
    }

    /** Where no wall is: nothing is told of it. Any other one stands for it. */
    static Wall none(Flat other) {
        return new Wall(other, Double.NaN, UNKNOWN, UNKNOWN);
    }

    /** What a wall covers along an axis, as far as the room goes. */
    private record Stretch(double middle, double half) {}

    private static Stretch stretch(Flat flat, int axis, double[] low, double[] high) {
        if (!flat.fillsBounds()) {
            return UNKNOWN;
        }
        Bounds box = flat.bounds();
        double from = Math.max(low[axis], axis == 0 ? box.minX() : axis == 1 ? box.minY() : box.minZ());
        double to = Math.min(high[axis], axis == 0 ? box.maxX() : axis == 1 ? box.maxY() : box.maxZ());
        return new Stretch((from + to) / 2 - (low[axis] + high[axis]) / 2, (to - from) / 2);
    }
}
