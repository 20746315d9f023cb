package cz.paprsek.format.openscad;

import cz.paprsek.format.model.Doubles;
import cz.paprsek.format.model.Polygon;
import cz.paprsek.math.Angles;
import cz.paprsek.shape.mesh.Triangles;

/** Bodies of triangles: what a polygon passes through as it is moved. */
final class Sweep {
    private final Triangles.Builder builder = Triangles.builder();
    private final Doubles places = new Doubles();
    private final double[] corners;
    private int rings;

    private Sweep(double[] corners) {
        this.corners = corners;
    }

    /**
     * Upwards, while it is turned and made smaller or larger.
     *
     * @param corners counter-clockwise
     * @param twist degrees, clockwise as seen from above
     */
    static Triangles up(double[] corners, double from, double to, double scaleX, double scaleY, double twist, int slices) {
        Sweep sweep = new Sweep(corners);
        for (int i = 0; i <= slices; i++) {
            double t = (double) i / slices;
            double c = Angles.cos(-twist * t);
            double s = Angles.sin(-twist * t);
            double sx = 1 + (scaleX - 1) * t;
            double sy = 1 + (scaleY - 1) * t;
            for (int k = 0; k < corners.length; k += 2) {
                double x = corners[k] * sx;
                double y = corners[k + 1] * sy;
                sweep.vertex(c * x - s * y, s * x + c * y, from + (to - from) * t);
            }
            sweep.rings++;
        }
        return sweep.closed(false);
    }

    /** Around the z axis, from the x axis on; x of the corners is the distance, y the height. */
    static Triangles around(double[] corners, double degrees, int steps) {
        Sweep sweep = new Sweep(corners);
        boolean isWhole = Math.abs(degrees) >= 360;
        for (int i = 0; i < (isWhole ? steps : steps + 1); i++) {
            double angle = (isWhole ? 360 : degrees) * i / steps;
            for (int k = 0; k < corners.length; k += 2) {
                sweep.vertex(corners[k] * Angles.cos(angle), corners[k] * Angles.sin(angle), corners[k + 1]);
            }
            sweep.rings++;
        }
        return sweep.closed(isWhole);
    }

    private Triangles closed(boolean isRing) {
        int n = corners.length / 2;
        for (int i = 0; i < (isRing ? rings : rings - 1); i++) {
            int below = i * n;
            int above = (i + 1) % rings * n;
            for (int k = 0; k < n; k++) {
                int next = (k + 1) % n;
                triangle(below + k, below + next, above + next);
                triangle(below + k, above + next, above + k);
            }
        }
        if (!isRing) {
            Polygon polygon = new Polygon();
            for (int k = 0; k < n; k++) {
                polygon.add(k, corners[2 * k], corners[2 * k + 1], 0);
            }
            int top = (rings - 1) * n;
            polygon.cut((a, b, c) -> {
                triangle(a, c, b);
                triangle(top + a, top + b, top + c);
            });
        }
        return builder.build().oriented();
    }

    /** But for those that have shrunk to nothing, at an axis or a tip. */
    private void triangle(int a, int b, int c) {
        if (!isSame(a, b) && !isSame(b, c) && !isSame(a, c)) {
            builder.triangle(a, b, c);
        }
    }

    private boolean isSame(int a, int b) {
        return places.get(3 * a) == places.get(3 * b) && places.get(3 * a + 1) == places.get(3 * b + 1) && places.get(3 * a + 2) == places.get(3 * b + 2);
    }

    private void vertex(double x, double y, double z) {
        builder.vertex(x, y, z);
        places.add(x);
        places.add(y);
        places.add(z);
    }
}
