package cz.paprsek.pov;

import cz.paprsek.math.Vec3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/** What lies within polygons of the plane, by the even-odd rule, in triangles: trapezoids between two edges each, from one height at which anything changes to another. */
final class PovFlats {
    private final Edge[] edges;
    private final double[] heights;

    /** Is told of triangles, counter-clockwise. */
    @FunctionalInterface
    interface Found {
        void triangle(Vec3 a, Vec3 b, Vec3 c);
    }

    /** Upwards. */
    private record Edge(int number, Vec3 low, Vec3 high) {
        double x(double y) {
            double share = (y - low.y()) / (high.y() - low.y());
            return y <= low.y() ? low.x() : y >= high.y() ? high.x() : low.x() + share * (high.x() - low.x());
        }
    }

    private record Pair(Edge left, Edge right) {}

    /** @param polygons of each the corners, the first again at the end */
    PovFlats(List<List<Vec3>> polygons) {
        List<Edge> all = new ArrayList<>();
        TreeSet<Double> changes = new TreeSet<>();
        for (List<Vec3> polygon : polygons) {
            for (int i = 0; i + 1 < polygon.size(); i++) {
                Vec3 a = polygon.get(i);
                Vec3 b = polygon.get(i + 1);
                if (a.y() != b.y()) {
                    all.add(a.y() < b.y() ? new Edge(all.size(), a, b) : new Edge(all.size(), b, a));
                    changes.add(a.y());
                    changes.add(b.y());
                }
            }
        }
        edges = all.stream().sorted(Comparator.comparingDouble((Edge edge) -> edge.low.y())).toArray(Edge[]::new);
        for (int i = 0; i < edges.length; i++) {
            for (int k = i + 1; k < edges.length && edges[k].low.y() < edges[i].high.y(); k++) {
                addCrossing(edges[i], edges[k], changes);
            }
        }
        heights = changes.stream().mapToDouble(y -> y).toArray();
    }

    private static void addCrossing(Edge one, Edge other, Set<Double> changes) {
        double low = Math.max(one.low.y(), other.low.y());
        double high = Math.min(one.high.y(), other.high.y());
        double before = one.x(low) - other.x(low);
        double after = one.x(high) - other.x(high);
        if ((before < 0 && after > 0) || (before > 0 && after < 0)) {
            changes.add(low + (high - low) * before / (before - after));
        }
    }

    void triangles(Found found) {
        Map<Pair, Double> open = new LinkedHashMap<>();
        List<Edge> active = new ArrayList<>();
        int next = 0;
        for (int i = 0; i + 1 < heights.length; i++) {
            double low = heights[i];
            double middle = (low + heights[i + 1]) / 2;
            active.removeIf(edge -> edge.high.y() <= low);
            for (; next < edges.length && edges[next].low.y() <= low; next++) {
                active.add(edges[next]);
            }
            Edge[] row = active.toArray(Edge[]::new);
            Arrays.sort(row, Comparator.comparingDouble((Edge edge) -> edge.x(middle)).thenComparingInt(Edge::number));
            Map<Pair, Double> now = new LinkedHashMap<>();
            for (int k = 0; k + 1 < row.length; k += 2) {
                Pair pair = new Pair(row[k], row[k + 1]);
                Double from = open.remove(pair);
                now.put(pair, from == null ? low : from);
            }
            open.forEach((pair, from) -> trapezoid(pair, from, low, found));
            open = now;
        }
        open.forEach((pair, from) -> trapezoid(pair, from, heights[heights.length - 1], found));
    }

    private static void trapezoid(Pair pair, double low, double high, Found found) {
        Vec3 a = new Vec3(pair.left.x(low), low, 0);
        Vec3 b = new Vec3(pair.right.x(low), low, 0);
        Vec3 c = new Vec3(pair.right.x(high), high, 0);
        Vec3 d = new Vec3(pair.left.x(high), high, 0);
        if (b.x() > a.x()) {
            found.triangle(a, b, c);
        }
        if (c.x() > d.x()) {
            found.triangle(a, c, d);
        }
    }
}
