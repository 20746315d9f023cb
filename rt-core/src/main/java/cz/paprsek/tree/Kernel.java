package cz.paprsek.tree;

import java.util.Optional;

/** What makes trees and searches them: one for any machine, and one for those whose vectors hold eight floats or sixteen. Both find the same. */
public abstract class Kernel {
    /** What was asked for: {@code scalar} or {@code vector} for all trees; else each gets what suits it. */
    private static final String WISH = System.getProperty("paprsek.kernel", "");
    private static final Kernel SCALAR = new Scalar();
    private static final Kernel BEST = best();
    /** Below so many items for each unit of what one costs, a binary tree is searched as fast, and at once: vectors are slow until compiled. */
    private static final int MANY = 256;

    /** How the one for large trees is called in reports. */
    public static String inUse() {
        return BEST.name();
    }

    /** The one for a tree over so many items which cost so much to meet, all together. */
    static Kernel suitedTo(int items, double cost) {
        return items == 0 || (items < MANY * (cost / items) && !"vector".equals(WISH)) ? SCALAR : BEST;
    }

    static Optional<Row> row(double[] balls) {
        return BEST.rowOf(balls);
    }

    /** What asks a few balls at once, if it is faster so. */
    Optional<Row> rowOf(double[] balls) {
        return Optional.empty();
    }

    /** What passes by triangles, if it is faster so. */
    Optional<Sieve> sieve() {
        return Optional.empty();
    }

    abstract String name();

    abstract Tree tree(BinaryNodes nodes);

    /** The same for who always searches the whole: perhaps in less memory. */
    Tree whole(BinaryNodes nodes) {
        return tree(nodes);
    }

    /**
     * The one with vectors needs a module that is there only if Java was told so, and a compiler that makes machine code of vectors: else each
     * of them is an object.
     */
    private static Kernel best() {
        String machine = System.getProperty("java.vm.name", "");
        String compiler = System.getProperty("java.vm.info", "");
        boolean compiles = machine.endsWith("64-Bit Server VM") && compiler.startsWith("mixed mode") && !compiler.contains("emulated-client")
                && !System.getProperty("java.vm.version", "").contains("jvmci");
        if (!compiles || "scalar".equals(WISH)) {
            return SCALAR;
        }
        return ModuleLayer.boot().findModule("jdk.incubator.vector").map(Kernel::wide).orElse(SCALAR);
    }

    private static Kernel wide(Module vectors) {
        Kernel.class.getModule().addReads(vectors);
        try {
            Kernel wide = Class.forName("cz.paprsek.tree.WideKernel").asSubclass(Kernel.class).getDeclaredConstructor().newInstance();
            return wide.isFast() ? wide : SCALAR;
        } catch (ReflectiveOperationException | LinkageError e) {
            // Not compiled into this jar, or against other vectors than this Java has.
            return SCALAR;
        }
    }

    /** Whether this machine's vectors are wide enough. */
    boolean isFast() {
        return true;
    }

    private static final class Scalar extends Kernel {
        @Override
        String name() {
            return "scalar";
        }

        @Override
        Tree tree(BinaryNodes nodes) {
            return nodes.count() < FourTree.MANY ? new BinaryTree(nodes) : new FourTree(new WideNodes(nodes, FourTree.WIDTH));
        }
    }
}
