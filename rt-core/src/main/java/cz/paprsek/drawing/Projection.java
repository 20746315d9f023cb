package cz.paprsek.drawing;

import cz.paprsek.math.Vec3;

/** The world seen from far away along an axis. */
public enum Projection {
    FRONT("Front (x, y)"),
    TOP("Top (x, z)"),
    RIGHT("Right (z, y)");

    private final String title;

    Projection(String title) {
        this.title = title;
    }

    public String title() {
        return title;
    }

    /** Where the view goes. */
    Vec3 along() {
        return switch (this) {
            case FRONT -> new Vec3(0, 0, -1);
            case TOP -> new Vec3(0, -1, 0);
            case RIGHT -> new Vec3(-1, 0, 0);
        };
    }

    /** To the right, in scene units. */
    public double right(Vec3 point) {
        return this == RIGHT ? -point.z() : point.x();
    }

    /** Upwards, in scene units. */
    public double up(Vec3 point) {
        return this == TOP ? -point.z() : point.y();
    }

    /** The part of a line within the square from 0,0 to side,side, as x and y of both ends; empty if there is none. */
    static double[] clipped(double x1, double y1, double x2, double y2, double side) {
        double begin = 0;
        double end = 1;
        double[][] axes = {{x1, x2 - x1}, {y1, y2 - y1}};
        for (double[] axis : axes) {
            if (axis[1] == 0 && (axis[0] < 0 || axis[0] > side)) {
                return new double[0];
            }
            if (axis[1] != 0) {
                double a = -axis[0] / axis[1];
                double b = (side - axis[0]) / axis[1];
                begin = Math.max(begin, Math.min(a, b));
                end = Math.min(end, Math.max(a, b));
            }
        }
        return begin > end ? new double[0]
                : new double[] {x1 + begin * (x2 - x1), y1 + begin * (y2 - y1), x1 + end * (x2 - x1), y1 + end * (y2 - y1)};
    }
}
