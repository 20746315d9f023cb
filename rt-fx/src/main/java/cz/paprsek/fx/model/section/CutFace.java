package cz.paprsek.fx.model.section;

import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Surface;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Where a plane cuts a solid: the outlines of what lies in it, found by asking at the corners of squares, and nearer and nearer where the surface passes between two. What is finer than a square may be missed.
 *
 * @param outlines closed ones, in the world; those of holes too
 */
public record CutFace(List<List<Vec3>> outlines) {
    /** How often the place is halved in which the surface lies. */
    private static final int HALVINGS = 8;
    /** How far beyond its box a solid is asked, as a share of its size, so that outlines are closed. */
    private static final double AIR = 1e-3;
    /** From which of its sides to which the outline goes through a square, by which corners lie inside: bottom, right, top, left. */
    private static final int[][] WAYS = {{}, {3, 0}, {0, 1}, {3, 1}, {1, 2}, {3, 0, 1, 2}, {0, 2}, {3, 2}, {2, 3}, {2, 0}, {0, 1, 2, 3}, {2, 1}, {1, 3}, {1, 0}, {0, 3}, {}};

    public CutFace {
        outlines = List.copyOf(outlines);
    }

    /**
     * Of one solid.
     *
     * @param place where the plane is along its axis
     * @param squares how many go along the longer side
     */
    public static CutFace of(Surface solid, Axis axis, double place, int squares) {
        Bounds box = solid.bounds();
        if (box.isEmpty() || !box.isFinite() || place <= axis.least(box) || place >= axis.most(box)) {
            return new CutFace(List.of());
        }
        return new CutFace(new Tracing(solid, axis, place, squares, box).outlines());
    }

    /** One search. */
    private static final class Tracing {
        private final Surface solid;
        private final Axis axis;
        private final double place;
        private final double leastU;
        private final double leastV;
        private final double width;
        private final double height;
        private final double air;
        private final int columns;
        private final int rows;
        private final boolean[] inside;
        /** From each side of a square that the outline crosses to the next it does, in the order of the outline. */
        private final Map<Integer, Integer> next = new HashMap<>();

        Tracing(Surface solid, Axis axis, double place, int squares, Bounds box) {
            this.solid = solid;
            this.axis = axis;
            this.place = place;
            Axis u = axis == Axis.X ? Axis.Y : Axis.X;
            Axis v = axis == Axis.Z ? Axis.Y : Axis.Z;
            width = u.most(box) - u.least(box);
            height = v.most(box) - v.least(box);
            double longer = Math.max(width, height);
            air = AIR * longer;
            columns = Math.max(4, (int) Math.ceil(squares * width / longer));
            rows = Math.max(4, (int) Math.ceil(squares * height / longer));
            leastU = u.least(box);
            leastV = v.least(box);
            inside = new boolean[(columns + 1) * (rows + 1)];
        }

        private Vec3 point(double column, double row) {
            double u = leastU + along(column, columns, width);
            double v = leastV + along(row, rows, height);
            return switch (axis) {
                case X -> new Vec3(place, u, v);
                case Y -> new Vec3(u, place, v);
                case Z -> new Vec3(u, v, place);
            };
        }

        /** The outermost squares are thin, half in the air and half in the box, so that corners which touch it are not cut off. */
        private double along(double at, int count, double size) {
            double inner = (size - 2 * air) / (count - 2);
            return at < 1 ? (2 * at - 1) * air : at > count - 1 ? size + (2 * (at - count) + 1) * air : air + (at - 1) * inner;
        }

        private int corner(int column, int row) {
            return row * (columns + 1) + column;
        }

        List<List<Vec3>> outlines() {
            // Those at the rim lie in the air.
            for (int row = 1; row < rows; row++) {
                for (int column = 1; column < columns; column++) {
                    inside[corner(column, row)] = solid.contains(point(column, row));
                }
            }
            for (int row = 0; row < rows; row++) {
                for (int column = 0; column < columns; column++) {
                    square(column, row);
                }
            }
            List<List<Vec3>> outlines = new ArrayList<>();
            while (!next.isEmpty()) {
                List<Vec3> outline = new ArrayList<>();
                Integer at = next.keySet().iterator().next();
                while (at != null) {
                    outline.add(crossing(at));
                    at = next.remove(at);
                }
                outlines.add(outline);
            }
            return outlines;
        }

        private void square(int column, int row) {
            int which = bit(column, row, 1) + bit(column + 1, row, 2) + bit(column + 1, row + 1, 4) + bit(column, row + 1, 8);
            // Twice the number of the corner where a side begins, and one more if it goes up.
            int[] sides = {2 * corner(column, row), 2 * corner(column + 1, row) + 1, 2 * corner(column, row + 1), 2 * corner(column, row) + 1};
            int[] ways = WAYS[which];
            for (int i = 0; i < ways.length; i += 2) {
                next.put(sides[ways[i]], sides[ways[i + 1]]);
            }
        }

        private int bit(int column, int row, int value) {
            return inside[corner(column, row)] ? value : 0;
        }

        private Vec3 crossing(int side) {
            int corner = side / 2;
            int column = corner % (columns + 1);
            int row = corner / (columns + 1);
            boolean isUp = side % 2 == 1;
            boolean isFirstInside = inside[corner];
            double from = 0;
            double to = 1;
            for (int i = 0; i < HALVINGS; i++) {
                double middle = (from + to) / 2;
                boolean is = solid.contains(isUp ? point(column, row + middle) : point(column + middle, row));
                from = is == isFirstInside ? middle : from;
                to = is == isFirstInside ? to : middle;
            }
            double at = (from + to) / 2;
            return isUp ? point(column, row + at) : point(column + at, row);
        }
    }
}
