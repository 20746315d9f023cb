package cz.paprsek.shape;

import cz.paprsek.math.Bounds;
import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;

/**
 * Which of many boxes a ray meets, without asking all: a tree of boxes, halved where their centres are spread widest. Node n has the
 * children 2n + 1 and 2n + 2, and the last level holds the boxes themselves. Boxes without end stand apart and are always met.
 */
final class OperandTree {
    private final Bounds[] nodes;
    /** By place on the last level: the number of the box there, or −1. */
    private final int[] number;
    private final int[] endless;

    OperandTree(Bounds[] boxes) {
        endless = IntStream.range(0, boxes.length).filter(i -> !boxes[i].isFinite()).toArray();
        Integer[] finite = IntStream.range(0, boxes.length).filter(i -> boxes[i].isFinite()).boxed().toArray(Integer[]::new);
        int places = Math.max(1, Integer.highestOneBit(Math.max(1, finite.length - 1)) * 2);
        number = new int[places];
        Arrays.fill(number, -1);
        nodes = new Bounds[2 * places - 1];
        fill(0, 0, places, boxes, finite, 0, finite.length);
    }

    /** Halves the boxes [start, end) over the places [from, to) below a node. */
    private Bounds fill(int node, int from, int to, Bounds[] boxes, Integer[] order, int start, int end) {
        Bounds bounds = Bounds.EMPTY;
        if (to - from == 1) {
            if (start < end) {
                number[from] = order[start];
                bounds = boxes[order[start]];
            }
        } else {
            Arrays.sort(order, start, end, alongWidest(boxes, order, start, end));
            int middle = start + (end - start + 1) / 2;
            int half = (from + to) / 2;
            bounds = fill(2 * node + 1, from, half, boxes, order, start, middle)
                    .union(fill(2 * node + 2, half, to, boxes, order, middle, end));
        }
        nodes[node] = bounds;
        return bounds;
    }

    private static Comparator<Integer> alongWidest(Bounds[] boxes, Integer[] order, int start, int end) {
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int i = start; i < end; i++) {
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], centre(boxes[order[i]], axis));
                high[axis] = Math.max(high[axis], centre(boxes[order[i]], axis));
            }
        }
        int x = high[0] - low[0] >= high[1] - low[1] ? 0 : 1;
        int widest = high[x] - low[x] >= high[2] - low[2] ? x : 2;
        return Comparator.comparingDouble(i -> centre(boxes[i], widest));
    }

    private static double centre(Bounds box, int axis) {
        return switch (axis) {
            case 0 -> box.minX() + box.maxX();
            case 1 -> box.minY() + box.maxY();
            default -> box.minZ() + box.maxZ();
        };
    }

    /** Pushes the numbers of the boxes that the ray meets, in rising order. */
    void meet(Ray ray, IntStack out) {
        int mark = out.size();
        for (int i : endless) {
            out.push(i);
        }
        meet(0, ray, out);
        out.sort(mark);
    }

    private void meet(int node, Ray ray, IntStack out) {
        if (nodes[node].isEmpty() || !ray.meets(nodes[node])) {
            return;
        }
        if (node >= number.length - 1) {
            out.push(number[node - number.length + 1]);
        } else {
            meet(2 * node + 1, ray, out);
            meet(2 * node + 2, ray, out);
        }
    }
}
