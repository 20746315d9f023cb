package cz.paprsek.render.glow;

import cz.paprsek.tree.ItemBoxes;
import cz.paprsek.tree.Tree;
import cz.paprsek.tree.TreeBuilder;
import java.util.Arrays;
import java.util.stream.IntStream;

/** Lights that are seen, in a tree. Immutable. */
final class GlowTree {
    final Tree tree;
    /** In the order of the tree's leaves. */
    final Glow[] ordered;

    private GlowTree(Tree tree, Glow[] ordered) {
        this.tree = tree;
        this.ordered = ordered;
    }

    static GlowTree of(Glow[] bodies) {
        double[] boxes = new double[6 * bodies.length];
        float[] cost = new float[bodies.length];
        for (int i = 0; i < bodies.length; i++) {
            TreeBuilder.put(boxes, i, bodies[i].surface.bounds().padded());
            cost[i] = (float) bodies[i].surface.cost();
        }
        int[] order = IntStream.range(0, bodies.length).toArray();
        Tree tree = new TreeBuilder(ItemBoxes.of(boxes), order, cost, () -> false).build();
        return new GlowTree(tree, Arrays.stream(order).mapToObj(i -> bodies[i]).toArray(Glow[]::new));
    }
}
