package cz.paprsek.render;

import cz.paprsek.math.Bounds;
import cz.paprsek.shape.Ray;
import cz.paprsek.shape.Spans;
import cz.paprsek.shape.Surface;
import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/**
 * A bounding volume hierarchy over surfaces, flat: an inner node n has two children. {@code child[2n]} and {@code child[2n + 1]} name
 * them: an inner node if not negative, else the complement of a leaf, its first surface · {@value #LEAF} + its count − 1.
 * {@code boxes[12n…]} holds the boxes of both, each as minimum x y z, maximum x y z, world space. Bodies without end stand apart and are
 * tested for every ray.
 */
final class Bvh {
    /** The most surfaces in one leaf. */
    static final int LEAF = 8;
    /** The cost up to which all surfaces of a leaf are tested rather than first its box. */
    private static final double QUICK = 4;

    /** How many objects, surfaces or records are dealt with between two questions whether to stop. */
    private static final int BATCH = 1024;

    private final Surface[] surfaces;
    private final boolean[] opaque;
    private final Surface[] endless;
    private final boolean[] endlessOpaque;
    private final double[] boxes;
    private final int[] child;
    private final int depth;
    private final Entries whole;

    private Bvh(Surface[] all, boolean[] allOpaque, int[] finite, int[] infinite, BvhBuilder builder) {
        this.depth = finite.length == 0 ? 0 : builder.build();
        this.surfaces = pick(all, finite);
        this.opaque = pick(allOpaque, finite);
        this.endless = pick(all, infinite);
        this.endlessOpaque = pick(allOpaque, infinite);
        this.boxes = builder.boxes;
        this.child = builder.child;
        this.whole = new Entries(1);
        if (finite.length > 0) {
            whole.add(builder.root(), Entries.ANYWHERE, 0);
        }
    }

    /** Builds the hierarchy; empty surfaces are left out. */
    static Bvh of(Surface[] surfaces, boolean[] opaque, RenderMonitor monitor) {
        Bounds[] bounds = new Bounds[surfaces.length];
        IntStream.range(0, bounds.length).parallel().forEach(i -> {
            stopIfAsked(i, monitor);
            bounds[i] = surfaces[i].bounds().padded();
        });
        int[] infinite = IntStream.range(0, bounds.length).filter(i -> !bounds[i].isFinite()).toArray();
        int[] finite = IntStream.range(0, bounds.length).filter(i -> bounds[i].isFinite() && !bounds[i].isEmpty()).toArray();
        double[] box = new double[6 * finite.length];
        float[] cost = new float[surfaces.length];
        IntStream.range(0, finite.length).parallel().forEach(i -> {
            stopIfAsked(i, monitor);
            BvhBuilder.put(box, i, bounds[finite[i]]);
            cost[finite[i]] = (float) surfaces[finite[i]].cost();
        });
        return new Bvh(surfaces, opaque, finite, infinite, new BvhBuilder(box, finite, cost, monitor));
    }

    /** To be called with every number of a count while a scene is prepared: once in a while, asks whether to stop. */
    static void stopIfAsked(int i, RenderMonitor monitor) {
        if (i % BATCH == 0 && monitor.cancelled()) {
            throw new CancellationException("the preparation of the scene was cancelled");
        }
    }

    /** Where a search starts that knows nothing of its ray. */
    Entries whole() {
        return whole;
    }

    /** Whether a search of these subtrees can find nothing at all. */
    boolean isClear(Entries entries) {
        return entries.size == 0 && endless.length == 0;
    }

    /** The scratch that one worker needs to search the tree. */
    Stack newStack() {
        return new Stack(depth + 2);
    }

    /** Scratch of one worker: nodes still to visit, and where the ray enters their boxes. */
    static final class Stack {
        private final int[] node;
        private final int[] near;
        private final Probe probe = new Probe();
        /** The number of tree nodes visited so far, leaves included. */
        long visits;

        private Stack(int depth) {
            node = new int[depth];
            near = new int[depth];
        }
    }

    /**
     * Finds the subtrees that hold whatever the rays of a bundle can meet. The nearest inner node is opened again and again until all are
     * leaves, or there would be too many.
     */
    void enter(Bundle bundle, Entries entries) {
        double unit = bundle.shortest();
        entries.clear();
        if (whole.size > 0) {
            entries.add(whole.node[0], Entries.ANYWHERE, 0);
        }
        int i = 0;
        while (i < entries.size) {
            int node = entries.node[i];
            if (node < 0 || entries.isFull()) {
                i++;
                continue;
            }
            entries.remove(i);
            for (int side = 0; side < 2; side++) {
                double near = bundle.enter(boxes, 12 * node + 6 * side);
                if (near < Double.POSITIVE_INFINITY) {
                    int subtree = child[2 * node + side];
                    entries.add(subtree, isQuick(subtree) ? Entries.ANYWHERE : 12 * node + 6 * side, near * unit);
                }
            }
        }
    }

    /** Whether a leaf takes less time than a test of its box for every ray would: the bundle is narrow, and has met it. */
    private boolean isQuick(int subtree) {
        if (subtree >= 0) {
            return false;
        }
        double cost = 0;
        int start = ~subtree / LEAF;
        for (int i = start + ~subtree % LEAF; i >= start; i--) {
            cost += surfaces[i].cost();
        }
        return cost <= QUICK;
    }

    /** Finds the ray's nearest hit in the given subtrees. */
    void nearest(Ray ray, Entries entries, Stack stack) {
        for (Surface surface : endless) {
            surface.nearest(ray);
        }
        Probe probe = stack.probe;
        if (entries.haveBoxes()) {
            probe.set(ray);
        }
        for (int i = 0; i < entries.size && entries.near[i] < ray.max; i++) {
            if (entries.box[i] == Entries.ANYWHERE || probe.enter(boxes, entries.box[i]) != Probe.MISS) {
                nearest(ray, entries.node[i], stack);
            }
        }
    }

    private void nearest(Ray ray, int subtree, Stack stack) {
        if (subtree < 0) {
            meetLeaf(ray, subtree, stack.probe, stack);
            return;
        }
        Probe probe = stack.probe;
        int top = 0;
        int node = subtree;
        while (true) {
            while (node >= 0) {
                stack.visits++;
                int left = probe.enter(boxes, 12 * node);
                int right = probe.enter(boxes, 12 * node + 6);
                int first = left <= right ? 2 * node : 2 * node + 1;
                if (left != Probe.MISS && right != Probe.MISS) {
                    stack.node[top] = child[first ^ 1];
                    stack.near[top++] = Math.max(left, right);
                } else if (left == right) {
                    break;
                }
                node = child[first];
            }
            if (node < 0) {
                meetLeaf(ray, node, probe, stack);
            }
            do {
                if (top == 0) {
                    return;
                }
                node = stack.node[--top];
            } while (!probe.reaches(stack.near[top]));
        }
    }

    private void meetLeaf(Ray ray, int leaf, Probe probe, Stack stack) {
        stack.visits++;
        int start = ~leaf / LEAF;
        for (int i = start + ~leaf % LEAF; i >= start; i--) {
            surfaces[i].nearest(ray);
        }
        probe.end(ray.max);
    }

    /**
     * Looks in the given subtrees for what stands between the ray's min and max.
     *
     * @param through receives the boundaries of transparent bodies; incomplete if the answer is not null
     * @return the first opaque body found, or null
     */
    @Nullable Surface occluder(Ray ray, Entries entries, Stack stack, Spans through) {
        for (int i = 0; i < endless.length; i++) {
            if (blocks(endless[i], endlessOpaque[i], ray, through)) {
                return endless[i];
            }
        }
        Probe probe = stack.probe;
        if (entries.haveBoxes()) {
            probe.set(ray);
        }
        for (int i = 0; i < entries.size; i++) {
            if (entries.box[i] == Entries.ANYWHERE || probe.enter(boxes, entries.box[i]) != Probe.MISS) {
                Surface found = occluder(ray, entries.node[i], stack, through);
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }

    private @Nullable Surface occluder(Ray ray, int subtree, Stack stack, Spans through) {
        if (subtree < 0) {
            return leafOccluder(ray, subtree, stack, through);
        }
        Probe probe = stack.probe;
        int top = 0;
        int node = subtree;
        while (true) {
            while (node >= 0) {
                stack.visits++;
                boolean left = probe.enter(boxes, 12 * node) != Probe.MISS;
                boolean right = probe.enter(boxes, 12 * node + 6) != Probe.MISS;
                if (left && right) {
                    stack.node[top++] = child[2 * node + 1];
                } else if (!left && !right) {
                    break;
                }
                node = child[left ? 2 * node : 2 * node + 1];
            }
            if (node < 0) {
                Surface found = leafOccluder(ray, node, stack, through);
                if (found != null) {
                    return found;
                }
            }
            if (top == 0) {
                return null;
            }
            node = stack.node[--top];
        }
    }

    private @Nullable Surface leafOccluder(Ray ray, int leaf, Stack stack, Spans through) {
        stack.visits++;
        int start = ~leaf / LEAF;
        for (int i = start + ~leaf % LEAF; i >= start; i--) {
            if (blocks(surfaces[i], opaque[i], ray, through)) {
                return surfaces[i];
            }
        }
        return null;
    }

    private static boolean blocks(Surface surface, boolean isOpaque, Ray ray, Spans through) {
        if (isOpaque) {
            return surface.occludes(ray);
        }
        surface.crossings(ray, through);
        return false;
    }

    private static Surface[] pick(Surface[] from, int[] which) {
        return Arrays.stream(which).mapToObj(i -> from[i]).toArray(Surface[]::new);
    }

    private static boolean[] pick(boolean[] from, int[] which) {
        boolean[] picked = new boolean[which.length];
        for (int i = 0; i < which.length; i++) {
            picked[i] = from[which[i]];
        }
        return picked;
    }
}
