package cz.paprsek.tree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ReinsertionTest {
    private static final int ITEMS = 5000;
    private final double[] boxes = new double[6 * ITEMS];
    private final double[] nodes = new double[12 * (ITEMS - 1)];
    private final int[] child = new int[2 * (ITEMS - 1)];
    private final int[] items = IntStream.range(0, ITEMS).toArray();
    private int nodeCount;

    /** Halves in the order of their numbers, which has nothing to do with where they are. */
    private int build(int from, int to, double[] box, int at) {
        if (to - from == 1) {
            System.arraycopy(boxes, 6 * from, box, at, 6);
            return Tree.leaf(from, 1, 1);
        }
        int node = nodeCount++;
        child[2 * node] = build(from, (from + to) / 2, nodes, 12 * node);
        child[2 * node + 1] = build((from + to) / 2, to, nodes, 12 * node + 6);
        Grid.empty(box, at);
        Grid.grow(box, at, nodes, 12 * node);
        Grid.grow(box, at, nodes, 12 * node + 6);
        return node;
    }

    private void scatter(long seed, double step) {
        Random random = new Random(seed);
        for (int i = 0; i < ITEMS; i++) {
            for (int k = 0; k < 3; k++) {
                boxes[6 * i + k] = random.nextInt(8) + step * random.nextDouble();
                boxes[6 * i + k + 3] = boxes[6 * i + k] + 0.01;
            }
        }
        build(0, ITEMS, new double[6], 0);
    }

    private double surface() {
        BinaryNodes tree = new BinaryNodes(nodes, child, 0, 1, place -> 1, () -> false);
        return IntStream.range(0, ITEMS - 1).mapToDouble(tree::halfAreaOf).sum();
    }

    /** Checks that boxes are those of what they hold, and returns how many nodes lie one below another. */
    private int check(int name, double[] in, int at) {
        double[] box = new double[6];
        int levels = 0;
        Grid.empty(box, 0);
        if (name < 0) {
            Grid.grow(box, 0, boxes, 6 * items[Tree.first(name)]);
        } else {
            for (int side = 0; side < 2; side++) {
                levels = Math.max(levels, check(child[2 * name + side], nodes, 12 * name + 6 * side));
                Grid.grow(box, 0, nodes, 12 * name + 6 * side);
            }
        }
        assertThat(box).isEqualTo(Arrays.copyOfRange(in, at, at + 6));
        return levels + 1;
    }

    private int check(int root) {
        double[] whole = new double[6];
        Grid.empty(whole, 0);
        Grid.grow(whole, 0, nodes, 12 * root);
        Grid.grow(whole, 0, nodes, 12 * root + 6);
        return check(root, whole, 0);
    }

    @Test
    void aPoorTreeHasLessSurfaceAfterwardsAndHoldsTheSameItems() {
        scatter(7, 0.1);
        double before = surface();
        // The budget is for trees that were built well: of this one it lasts for a part of the way.
        int depth = new Reinsertion(nodes, child, items, () -> false).run(14);
        assertThat(surface()).isLessThan(0.95 * before);
        for (int run = 1; run < 4; run++) {
            depth = new Reinsertion(nodes, child, items, () -> false).run(depth);
        }
        assertThat(surface()).isLessThan(0.65 * before);
        assertThat(check(0)).isEqualTo(depth);
        assertThat(items).containsExactlyInAnyOrder(IntStream.range(0, ITEMS).toArray());
    }

    @Test
    void whatIsInOnePlaceIsLeftAsItWas() {
        build(0, ITEMS, new double[6], 0);
        assertThat(new Reinsertion(nodes, child, items, () -> false).run(14)).isEqualTo(14);
        assertThat(items).isSorted();
        assertThat(check(0)).isEqualTo(14);
    }

    @Test
    void itStopsIfAsked() {
        scatter(7, 0.1);
        assertThatExceptionOfType(CancellationException.class).isThrownBy(() -> new Reinsertion(nodes, child, items, () -> true).run(14));
    }
}
