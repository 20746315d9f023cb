package cz.paprsek.shape.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;

/** Lines from vertex to vertex: edges joined, and what is too fine left out. */
final class Lines {
    private final int[] ends;
    /** The vertices there are, rising; the edges at each stand side by side, those at the i-th from start[i] to start[i + 1] − 1. */
    private final int[] vertices;
    private final int[] start;
    private final int[] edges;
    private final BitSet used;
    private final int[] walked;

    /** @param ends two different vertices for each edge */
    private Lines(int[] ends) {
        this.ends = ends;
        vertices = Arrays.stream(ends).sorted().distinct().toArray();
        int[] known = new int[ends.length];
        start = new int[vertices.length + 1];
        for (int i = 0; i < ends.length; i++) {
            known[i] = Arrays.binarySearch(vertices, ends[i]);
            start[known[i] + 1]++;
        }
        for (int i = 0; i < vertices.length; i++) {
            start[i + 1] += start[i];
        }
        int[] next = Arrays.copyOf(start, vertices.length);
        edges = new int[ends.length];
        for (int i = 0; i < ends.length; i++) {
            edges[next[known[i]]++] = i / 2;
            ends[i] = known[i];
        }
        used = new BitSet(ends.length / 2);
        walked = new int[ends.length / 2 + 1];
    }

    /** As long as they can be: from where there are not just two edges to where there are not, or round. */
    static List<int[]> joined(int[] ends) {
        Lines lines = new Lines(ends);
        List<int[]> found = new ArrayList<>();
        for (int v = 0; v < lines.vertices.length; v++) {
            for (int i = lines.start[v]; i < lines.start[v + 1] && !lines.goesOn(v); i++) {
                lines.walk(v, lines.edges[i], found);
            }
        }
        for (int edge = 0; edge < ends.length / 2; edge++) {
            lines.walk(ends[2 * edge], edge, found);
        }
        return found;
    }

    private boolean goesOn(int vertex) {
        return start[vertex + 1] - start[vertex] == 2;
    }

    private void walk(int from, int first, List<int[]> found) {
        int count = 0;
        walked[count++] = vertices[from];
        int at = from;
        int edge = first;
        while (!used.get(edge)) {
            used.set(edge);
            at = ends[2 * edge] == at ? ends[2 * edge + 1] : ends[2 * edge];
            walked[count++] = vertices[at];
            if (goesOn(at)) {
                edge = edges[start[at]] == edge ? edges[start[at] + 1] : edges[start[at]];
            }
        }
        if (count > 1) {
            found.add(Arrays.copyOf(walked, count));
        }
    }

    /**
     * Without vertices that lie less far than a tolerance from the line without them.
     *
     * @source Douglas, Peucker, Algorithms for the Reduction of the Number of Points Required to Represent a Digitized Line, Cartographica 10(2), 1973
     */
    static List<int[]> thinned(List<int[]> lines, double[] places, double tolerance) {
        return lines.stream().map(line -> thinned(line, places, tolerance)).toList();
    }

    private static int[] thinned(int[] line, double[] places, double tolerance) {
        BitSet kept = new BitSet(line.length);
        kept.set(0);
        kept.set(line.length - 1);
        int[] open = new int[2 * line.length];
        int top = 0;
        open[top++] = 0;
        open[top++] = line.length - 1;
        while (top > 0) {
            int to = open[--top];
            int from = open[--top];
            double most = tolerance;
            int farthest = -1;
            for (int i = from + 1; i < to; i++) {
                double distance = distance(places, 3 * line[i], 3 * line[from], 3 * line[to]);
                if (distance > most) {
                    most = distance;
                    farthest = i;
                }
            }
            if (farthest > 0) {
                kept.set(farthest);
                open[top++] = from;
                open[top++] = farthest;
                open[top++] = farthest;
                open[top++] = to;
            }
        }
        return kept.stream().map(i -> line[i]).toArray();
    }

    /** From the point that begins at p to the nearest of the line from a to b. */
    private static double distance(double[] at, int p, int a, int b) {
        double bx = at[b] - at[a];
        double by = at[b + 1] - at[a + 1];
        double bz = at[b + 2] - at[a + 2];
        double px = at[p] - at[a];
        double py = at[p + 1] - at[a + 1];
        double pz = at[p + 2] - at[a + 2];
        double length = bx * bx + by * by + bz * bz;
        double t = length > 0 ? Math.max(0, Math.min(1, (px * bx + py * by + pz * bz) / length)) : 0;
        double x = px - t * bx;
        double y = py - t * by;
        double z = pz - t * bz;
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** How many straight pieces there are. */
    static int pieces(List<int[]> lines) {
        return lines.stream().mapToInt(line -> line.length - 1).sum();
    }

    /** Those with the most pieces, if there are more than so many. */
    static List<int[]> longest(List<int[]> lines, int most) {
        return lines.size() <= most ? lines : lines.stream().sorted(Comparator.comparingInt(line -> -line.length)).limit(most).toList();
    }
}
