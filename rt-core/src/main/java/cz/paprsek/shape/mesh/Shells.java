package cz.paprsek.shape.mesh;

import cz.paprsek.math.Bounds;
import java.util.Arrays;
import java.util.BitSet;

/**
 * What is known of the edges of a mesh, and the shells that it consists of: triangles that hang together.
 *
 * @param openEdges how many edges are not passed as often in one direction as in the other, with triangles turned
 * @param turned the triangles to be turned round so that neighbours fit and insides are inside
 * @param rim the places, by their first vertices, that open edges lead between
 */
record Shells(int openEdges, BitSet turned, BitSet rim) {
    /** Above so many pairs of shells it is not asked which lies in which. */
    private static final long MOST_PAIRS = 20_000_000;

    /** Whether all triangles are right as they are. */
    boolean isOriented() {
        return turned.isEmpty();
    }

    static Shells of(double[] places, int[] corners, Bounds bounds) {
        int[] first = Weld.firsts(places);
        Edges edges = new Edges(first, corners);
        BitSet turned = new BitSet();
        int open = edges.open(turned);
        if (open > 0 && edges.fit(turned)) {
            open = edges.open(turned);
        }
        if (open == 0) {
            turnInsidesIn(places, corners, bounds, first, turned);
        }
        return new Shells(open, turned, open == 0 ? new BitSet() : edges.rim(turned));
    }

    /** Turns what is inside out: everything, if that is what the volume says; and single shells that lie within no other. */
    private static void turnInsidesIn(double[] places, int[] corners, Bounds bounds, int[] first, BitSet turned) {
        int[] root = shells(first, corners);
        int[] shellOf = new int[corners.length / 3];
        int count = number(root, first, corners, shellOf);
        double[] volume = new double[count];
        double[] box = new double[6 * count];
        Arrays.fill(box, Double.POSITIVE_INFINITY);
        double all = 0;
        for (int t = 0; t < corners.length / 3; t++) {
            int shell = shellOf[t];
            double part = Measures.sixfoldVolume(places, corners, t, (bounds.minX() + bounds.maxX()) / 2, (bounds.minY() + bounds.maxY()) / 2, (bounds.minZ() + bounds.maxZ()) / 2);
            part = turned.get(t) ? -part : part;
            all += part;
            volume[shell] += part;
            for (int k = 0; k < 9; k++) {
                double value = places[3 * corners[3 * t + k / 3] + k % 3];
                int at = 6 * shell + k % 3;
                box[at] = Math.min(box[at], value);
                box[at + 3] = Math.min(box[at + 3], -value);
            }
        }
        boolean inverted = all < 0;
        boolean[] turns = new boolean[count];
        long negative = 0;
        for (int shell = 0; shell < count; shell++) {
            volume[shell] = inverted ? -volume[shell] : volume[shell];
            negative += volume[shell] < 0 ? 1 : 0;
        }
        for (int shell = 0; shell < count; shell++) {
            turns[shell] = inverted != (volume[shell] < 0 && negative * count <= MOST_PAIRS && !isWithinAnother(shell, volume, box));
        }
        for (int t = 0; t < corners.length / 3; t++) {
            if (turns[shellOf[t]]) {
                turned.flip(t);
            }
        }
    }

    /** Numbers the shells in the order of their first triangles, and returns how many there are. */
    private static int number(int[] root, int[] first, int[] corners, int[] shellOf) {
        int[] numbers = new int[root.length];
        int count = 0;
        for (int t = 0; t < shellOf.length; t++) {
            int place = root[first[corners[3 * t]]];
            if (numbers[place] == 0) {
                numbers[place] = ++count;
            }
            shellOf[t] = numbers[place] - 1;
        }
        return count;
    }

    /** Whether the box of a shell lies in that of one which is not inside out. */
    private static boolean isWithinAnother(int shell, double[] volume, double[] box) {
        for (int other = 0; other < volume.length; other++) {
            boolean holds = volume[other] > 0;
            for (int k = 0; k < 6 && holds; k++) {
                holds = box[6 * other + k] <= box[6 * shell + k];
            }
            if (holds) {
                return true;
            }
        }
        return false;
    }

    /** For each place another one of its shell, that of the shell's first in the end: union and find. */
    private static int[] shells(int[] first, int[] corners) {
        int[] root = new int[first.length];
        for (int v = 0; v < root.length; v++) {
            root[v] = v;
        }
        for (int t = 0; t < corners.length; t += 3) {
            int a = find(root, first[corners[t]]);
            a = join(root, a, find(root, first[corners[t + 1]]));
            join(root, a, find(root, first[corners[t + 2]]));
        }
        for (int v = 0; v < root.length; v++) {
            root[v] = find(root, v);
        }
        return root;
    }

    private static int join(int[] root, int a, int b) {
        int low = Math.min(a, b);
        root[Math.max(a, b)] = low;
        return low;
    }

    private static int find(int[] root, int of) {
        int at = of;
        while (root[at] != at) {
            root[at] = root[root[at]];
            at = root[at];
        }
        return at;
    }
}
