package cz.paprsek.render;

import cz.paprsek.shape.Ray;
import cz.paprsek.shape.Spans;
import cz.paprsek.shape.Surface;
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
    /** Says that there is no tree: every surface is unbounded. */
    static final int NOTHING = Integer.MIN_VALUE;

    private final Surface[] surfaces;
    private final boolean[] opaque;
    private final Surface[] endless;
    private final boolean[] endlessOpaque;
    private final double[] boxes;
    private final int[] child;
    private final int root;
    private final int depth;

    Bvh(Surface[] surfaces, boolean[] opaque, Surface[] endless, boolean[] endlessOpaque, double[] boxes, int[] child, int root, int depth) {
        this.surfaces = surfaces;
        this.opaque = opaque;
        this.endless = endless;
        this.endlessOpaque = endlessOpaque;
        this.boxes = boxes;
        this.child = child;
        this.root = root;
        this.depth = depth;
    }

    /** The scratch that one worker needs to search the tree. */
    Stack newStack() {
        return new Stack(depth + 2);
    }

    /** Scratch of one worker: nodes still to visit, and where the ray enters their boxes. */
    static final class Stack {
        private final int[] node;
        private final int[] near;
        /** The number of tree nodes visited so far, leaves included. */
        long visits;

        private Stack(int depth) {
            node = new int[depth];
            near = new int[depth];
        }
    }

    /** Finds the ray's nearest hit. */
    void nearest(Ray ray, Stack stack) {
        for (Surface surface : endless) {
            surface.nearest(ray);
        }
        if (root == NOTHING) {
            return;
        }
        double ox = ray.ox;
        double oy = ray.oy;
        double oz = ray.oz;
        double rx = ray.rx;
        double ry = ray.ry;
        double rz = ray.rz;
        int begin = order(ray.min);
        // Where in a box the planes lie that the ray crosses first and last.
        int ax = rx < 0 ? 3 : 0;
        int bx = 3 - ax;
        int ay = ry < 0 ? 4 : 1;
        int by = 5 - ay;
        int az = rz < 0 ? 5 : 2;
        int bz = 7 - az;
        int end = order(ray.max);
        int top = 0;
        int node = root;
        while (true) {
            stack.visits++;
            if (node < 0) {
                int first = ~node / LEAF;
                for (int i = first + ~node % LEAF; i >= first; i--) {
                    surfaces[i].nearest(ray);
                }
                end = order(ray.max);
            } else {
                int b = 12 * node;
                int nearL = Math.max(
                        Math.max(order((boxes[b + ax] - ox) * rx), order((boxes[b + ay] - oy) * ry)),
                        Math.max(order((boxes[b + az] - oz) * rz), begin));
                int farL = Math.min(
                        Math.min(order((boxes[b + bx] - ox) * rx), order((boxes[b + by] - oy) * ry)),
                        Math.min(order((boxes[b + bz] - oz) * rz), end)) + 1;
                b += 6;
                int nearR = Math.max(
                        Math.max(order((boxes[b + ax] - ox) * rx), order((boxes[b + ay] - oy) * ry)),
                        Math.max(order((boxes[b + az] - oz) * rz), begin));
                int farR = Math.min(
                        Math.min(order((boxes[b + bx] - ox) * rx), order((boxes[b + by] - oy) * ry)),
                        Math.min(order((boxes[b + bz] - oz) * rz), end)) + 1;
                int left = child[2 * node];
                int right = child[2 * node + 1];
                if (nearL <= farL) {
                    if (nearR <= farR) {
                        boolean leftFirst = nearL <= nearR;
                        stack.node[top] = leftFirst ? right : left;
                        stack.near[top++] = leftFirst ? nearR : nearL;
                        node = leftFirst ? left : right;
                    } else {
                        node = left;
                    }
                    continue;
                }
                if (nearR <= farR) {
                    node = right;
                    continue;
                }
            }
            do {
                if (top == 0) {
                    return;
                }
                node = stack.node[--top];
            } while (stack.near[top] > end);
        }
    }

    /**
     * Looks for what stands between the ray's min and max.
     *
     * @param through receives the boundaries of transparent bodies; incomplete if the answer is not null
     * @return the first opaque body found, or null
     */
    @Nullable Surface occluder(Ray ray, Stack stack, Spans through) {
        for (int i = 0; i < endless.length; i++) {
            if (blocks(endless[i], endlessOpaque[i], ray, through)) {
                return endless[i];
            }
        }
        if (root == NOTHING) {
            return null;
        }
        double ox = ray.ox;
        double oy = ray.oy;
        double oz = ray.oz;
        double rx = ray.rx;
        double ry = ray.ry;
        double rz = ray.rz;
        int begin = order(ray.min);
        int end = order(ray.max);
        int ax = rx < 0 ? 3 : 0;
        int bx = 3 - ax;
        int ay = ry < 0 ? 4 : 1;
        int by = 5 - ay;
        int az = rz < 0 ? 5 : 2;
        int bz = 7 - az;
        int top = 0;
        int node = root;
        while (true) {
            stack.visits++;
            if (node < 0) {
                int first = ~node / LEAF;
                for (int i = first + ~node % LEAF; i >= first; i--) {
                    if (blocks(surfaces[i], opaque[i], ray, through)) {
                        return surfaces[i];
                    }
                }
            } else {
                int b = 12 * node;
                int nearL = Math.max(
                        Math.max(order((boxes[b + ax] - ox) * rx), order((boxes[b + ay] - oy) * ry)),
                        Math.max(order((boxes[b + az] - oz) * rz), begin));
                int farL = Math.min(
                        Math.min(order((boxes[b + bx] - ox) * rx), order((boxes[b + by] - oy) * ry)),
                        Math.min(order((boxes[b + bz] - oz) * rz), end)) + 1;
                b += 6;
                int nearR = Math.max(
                        Math.max(order((boxes[b + ax] - ox) * rx), order((boxes[b + ay] - oy) * ry)),
                        Math.max(order((boxes[b + az] - oz) * rz), begin));
                int farR = Math.min(
                        Math.min(order((boxes[b + bx] - ox) * rx), order((boxes[b + by] - oy) * ry)),
                        Math.min(order((boxes[b + bz] - oz) * rz), end)) + 1;
                if (nearL <= farL) {
                    if (nearR <= farR) {
                        stack.node[top++] = child[2 * node + 1];
                    }
                    node = child[2 * node];
                    continue;
                }
                if (nearR <= farR) {
                    node = child[2 * node + 1];
                    continue;
                }
            }
            if (top == 0) {
                return null;
            }
            node = stack.node[--top];
        }
    }

    private static boolean blocks(Surface surface, boolean isOpaque, Ray ray, Spans through) {
        if (isOpaque) {
            return surface.occludes(ray);
        }
        surface.crossings(ray, through);
        return false;
    }

    /**
     * The upper half of a double as an integer, by which values of t are compared: the JVM makes two instructions of the maximum of
     * integers, but eleven, three of them slow, of that of doubles. For numbers not below 0 the order is the same, only coarser, which the
     * + 1 on the far side makes up for. A t below 0 becomes a negative integer, of wrong order among its kind, but below where every ray
     * starts, which is all that matters.
     */
    private static int order(double t) {
        return (int) (Double.doubleToRawLongBits(t) >>> 32);
    }
}
