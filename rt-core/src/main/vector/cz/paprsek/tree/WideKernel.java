package cz.paprsek.tree;

import java.util.Optional;
import jdk.incubator.vector.FloatVector;

/** Trees of as many children a node as vectors hold floats, all asked about at once. Loaded by name, and only where the module {@code jdk.incubator.vector} is present. */
final class WideKernel extends Kernel {
    @Override
    Tree tree(BinaryNodes nodes) {
        return WideTree.WIDTH == 16 ? new SixteenTree(nodes) : new EightTree(nodes);
    }

    @Override
    Tree whole(BinaryNodes nodes) {
        return PackedNodes.of(nodes, WideTree.WIDTH).<Tree>map(PackedTree::new).orElseGet(() -> tree(nodes));
    }

    @Override
    Optional<Row> rowOf(double[] balls) {
        return Optional.of(new WideRow(balls));
    }

    @Override
    Optional<Sieve> sieve() {
        return Optional.of(new WideSieve());
    }

    @Override
    String name() {
        return "vectors of " + WideTree.WIDTH + " floats";
    }

    /** Vectors that are wider than the machine's are objects, thousands of times slower. */
    @Override
    boolean isFast() {
        return FloatVector.SPECIES_PREFERRED.length() >= WideTree.WIDTH;
    }
}
