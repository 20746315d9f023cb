package cz.paprsek.format.openscad;

import cz.paprsek.math.Affine;

/** A figure in the plane, to be extruded. */
sealed interface Figure {
    /** How many sides stand for a circle that is made of triangles. */
    int ROUND = 96;

    /** Its corners, x and y in turn, counter-clockwise; after a map of the plane. */
    double[] corners(Affine map);

    /** Whether corners only stand for it. */
    default boolean isRound() {
        return false;
    }

    record Square(double minX, double minY, double maxX, double maxY) implements Figure {
        @Override
        public double[] corners(Affine map) {
            return mapped(new double[] {minX, minY, maxX, minY, maxX, maxY, minX, maxY}, map);
        }
    }

    /** @param sides of a polygon that is meant as one; 0 for a circle */
    record Circle(double radius, int sides) implements Figure {
        @Override
        public double[] corners(Affine map) {
            return mapped(ring(radius, sides > 0 ? sides : ROUND), map);
        }

        @Override
        public boolean isRound() {
            return sides == 0;
        }
    }

    /** Any outline. */
    final class Path implements Figure {
        private final double[] points;

        Path(double[] points) {
            this.points = points;
        }

        @Override
        public double[] corners(Affine map) {
            return mapped(points, map);
        }
    }

    /** A regular polygon about the origin; its first corner is on the x axis. */
    static double[] ring(double radius, int sides) {
        double[] points = new double[2 * sides];
        for (int i = 0; i < sides; i++) {
            double angle = 2 * Math.PI * i / sides;
            points[2 * i] = radius * StrictMath.cos(angle);
            points[2 * i + 1] = radius * StrictMath.sin(angle);
        }
        return points;
    }

    private static double[] mapped(double[] points, Affine map) {
        double[] mapped = new double[points.length];
        for (int i = 0; i < points.length; i += 2) {
            mapped[i] = map.pointX(points[i], points[i + 1], 0);
            mapped[i + 1] = map.pointY(points[i], points[i + 1], 0);
        }
        if (area(mapped) < 0) {
            reverse(mapped);
        }
        return mapped;
    }

    /** Above 0 if the corners run counter-clockwise. */
    static double area(double[] points) {
        double twice = 0;
        for (int i = 0, j = points.length - 2; i < points.length; j = i, i += 2) {
            twice += (points[j] - points[0]) * (points[i + 1] - points[1]) - (points[i] - points[0]) * (points[j + 1] - points[1]);
        }
        return twice / 2;
    }

    private static void reverse(double[] points) {
        for (int i = 0, j = points.length - 2; i < j; i += 2, j -= 2) {
            double x = points[i];
            double y = points[i + 1];
            points[i] = points[j];
            points[i + 1] = points[j + 1];
            points[j] = x;
            points[j + 1] = y;
        }
    }
}
