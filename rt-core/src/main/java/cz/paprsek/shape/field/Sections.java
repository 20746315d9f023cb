package cz.paprsek.shape.field;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Vec3;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** Lines in planes where a formula is 0, found on a grid of squares: what is finer is not seen. */
public final class Sections {
    private static final int HALVINGS = 50;

    private final Field field;
    private final Bounds box;
    private final int cells;
    private final double[] room;

    /** @param cells along each side of the box */
    public Sections(Field field, Bounds box, int cells) {
        this.field = field;
        this.box = box;
        this.cells = cells;
        room = field.newRoom();
    }

    /** In planes across the axis that a view goes along most. */
    public List<Curve> across(Vec3 along, int planes) {
        double x = Math.abs(along.x());
        double y = Math.abs(along.y());
        double z = Math.abs(along.z());
        int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        List<Curve> curves = new ArrayList<>();
        for (int i = 0; i < planes; i++) {
            in(axis, (i + 0.5) / planes, curves);
        }
        return curves;
    }

    /** A point by its shares of the box: the first along the axis, the others along those that follow it. */
    private Vec3 point(int axis, double depth, double a, double b) {
        double u = axis == 0 ? depth : axis == 1 ? b : a;
        double v = axis == 0 ? a : axis == 1 ? depth : b;
        double w = axis == 0 ? b : axis == 1 ? a : depth;
        return new Vec3(box.minX() + u * (box.maxX() - box.minX()), box.minY() + v * (box.maxY() - box.minY()), box.minZ() + w * (box.maxZ() - box.minZ()));
    }

    private boolean isInside(Vec3 p) {
        return field.value(p.x(), p.y(), p.z(), room) < 0;
    }

    private void in(int axis, double depth, List<Curve> into) {
        boolean[] inside = new boolean[(cells + 1) * (cells + 1)];
        for (int i = 0; i < inside.length; i++) {
            inside[i] = isInside(corner(axis, depth, i));
        }
        Map<Integer, List<Integer>> neighbours = new HashMap<>();
        Map<Integer, Vec3> points = new HashMap<>();
        for (int i = 0; i < cells; i++) {
            for (int k = 0; k < cells; k++) {
                int[] around = {k * (cells + 1) + i, k * (cells + 1) + i + 1, (k + 1) * (cells + 1) + i + 1, (k + 1) * (cells + 1) + i};
                List<Integer> crossed = new ArrayList<>();
                for (int side = 0; side < 4; side++) {
                    int one = around[side];
                    int other = around[(side + 1) % 4];
                    if (inside[one] != inside[other]) {
                        // An edge is called by its lesser corner, and whether it leads upwards.
                        int edge = 2 * Math.min(one, other) + (Math.abs(one - other) == 1 ? 0 : 1);
                        points.computeIfAbsent(edge, unknown -> between(corner(axis, depth, one), corner(axis, depth, other), inside[one]));
                        crossed.add(edge);
                    }
                }
                for (int n = 0; n + 1 < crossed.size(); n += 2) {
                    neighbours.computeIfAbsent(crossed.get(n), unknown -> new ArrayList<>()).add(crossed.get(n + 1));
                    neighbours.computeIfAbsent(crossed.get(n + 1), unknown -> new ArrayList<>()).add(crossed.get(n));
                }
            }
        }
        // Lines that end at the box first, from there; what is left is closed.
        for (boolean areClosed : new boolean[] {false, true}) {
            for (Integer edge : List.copyOf(neighbours.keySet())) {
                int ways = Objects.requireNonNull(neighbours.get(edge)).size();
                if (areClosed ? ways > 0 : ways == 1) {
                    into.add(follow(edge, neighbours, points));
                }
            }
        }
    }

    private static Curve follow(Integer from, Map<Integer, List<Integer>> neighbours, Map<Integer, Vec3> points) {
        List<Vec3> line = new ArrayList<>();
        Integer at = from;
        line.add(points.get(at));
        while (!Objects.requireNonNull(neighbours.get(at)).isEmpty()) {
            Integer next = Objects.requireNonNull(neighbours.get(at)).remove(0);
            Objects.requireNonNull(neighbours.get(next)).remove(at);
            at = next;
            line.add(points.get(at));
        }
        return new Curve(line);
    }

    private Vec3 corner(int axis, double depth, int number) {
        int row = number / (cells + 1);
        return point(axis, depth, (double) (number % (cells + 1)) / cells, (double) row / cells);
    }

    private Vec3 between(Vec3 one, Vec3 other, boolean isInside) {
        Vec3 low = one;
        Vec3 high = other;
        for (int i = 0; i < HALVINGS; i++) {
            Vec3 middle = low.plus(high).times(0.5);
            if (isInside(middle) == isInside) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low.plus(high).times(0.5);
    }
}
