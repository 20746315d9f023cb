package cz.paprsek.shape.outline;

import cz.paprsek.ray.Line;
import java.util.stream.DoubleStream;

/**
 * A piece of an outline, from u = 0 to u = 1. A straight line a·x + b·y + c = 0 crosses it where the left side changes its sign; at its ends that
 * is worked out by the same arithmetic as for the neighbours, so that no line slips through between two pieces or is counted by both.
 */
abstract class Piece {
    final double x0;
    final double y0;
    final double x1;
    final double y1;

    Piece(double x0, double y0, double x1, double y1) {
        this.x0 = x0;
        this.y0 = y0;
        this.x1 = x1;
        this.y1 = y1;
    }

    abstract double x(double u);

    abstract double y(double u);

    /** How fast x changes with u. */
    abstract double dx(double u);

    abstract double dy(double u);

    /** The u of a point of the piece. */
    abstract double parameter(double x, double y);

    /**
     * Notes where the line crosses it, by how far along the line that is: b·x − a·y.
     *
     * @param face that is crossed if the sign falls along the piece; if it rises it is the next number
     */
    abstract void cross(double a, double b, double c, int face, Line out);

    /** As cubic Bézier curves, four points each, x and y in turn, one after the other the way the outline runs. */
    abstract double[] controls();

    /** Whether the outline runs from its end to its beginning. */
    boolean isBackward() {
        return false;
    }

    /** Where x or y turns round within the piece. */
    DoubleStream turns() {
        return DoubleStream.empty();
    }

    static boolean isAbove(double side) {
        return side >= 0;
    }
}
