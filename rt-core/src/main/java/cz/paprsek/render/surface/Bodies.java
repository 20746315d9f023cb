package cz.paprsek.render.surface;

import cz.paprsek.shape.placed.Balls;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.tree.Bundle;
import cz.paprsek.tree.Entries;
import cz.paprsek.tree.Search;
import cz.paprsek.tree.Tree;
import cz.paprsek.tree.TreeBuilder;
import java.util.Arrays;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/** The bodies of a scene in a tree. Those without end stand apart and are met by every ray. */
public final class Bodies {
    /** In the order of the tree's leaves. */
    private final Surface[] surfaces;
    private final Balls balls;
    private final boolean[] opaque;
    /** In place of which bodies are opaque, for who wants the boundaries of all. */
    private final boolean[] none;
    private final Surface[] endless;
    private final boolean[] endlessOpaque;
    private final Tree tree;

    private Bodies(Surface[] all, boolean[] allOpaque, int[] finite, int[] infinite, Tree tree) {
        this.surfaces = pick(all, finite);
        this.balls = new Balls(surfaces);
        this.opaque = pick(allOpaque, finite);
        this.none = new boolean[finite.length];
        this.endless = pick(all, infinite);
        this.endlessOpaque = pick(allOpaque, infinite);
        this.tree = tree;
    }

    /** Builds the tree; empty surfaces are left out. */
    public static Bodies of(Surface[] surfaces, boolean[] opaque, BooleanSupplier stop) {
        int count = surfaces.length;
        double[] box = new double[6 * count];
        float[] cost = new float[count];
        IntStream.range(0, count).parallel().forEach(i -> {
            TreeBuilder.stopIfAsked(i, stop);
            TreeBuilder.put(box, i, surfaces[i].bounds().padded());
            cost[i] = (float) surfaces[i].cost();
        });
        int[] infinite = IntStream.range(0, count).filter(i -> !isEmpty(box, i) && !isFinite(box, i)).toArray();
        int[] finite = IntStream.range(0, count).filter(i -> !isEmpty(box, i) && isFinite(box, i)).toArray();
        for (int i = 0; i < finite.length && finite.length < count; i++) {
            System.arraycopy(box, 6 * finite[i], box, 6 * i, 6);
        }
        // Building puts the numbers of the finite ones into the order of the leaves.
        Tree tree = new TreeBuilder(box, finite, cost, stop).build();
        return new Bodies(surfaces, opaque, finite, infinite, tree);
    }

    private static boolean isEmpty(double[] box, int i) {
        return box[6 * i] > box[6 * i + 3] || box[6 * i + 1] > box[6 * i + 4] || box[6 * i + 2] > box[6 * i + 5];
    }

    private static boolean isFinite(double[] box, int i) {
        return Double.isFinite(box[6 * i + 3] - box[6 * i]) && Double.isFinite(box[6 * i + 4] - box[6 * i + 1])
                && Double.isFinite(box[6 * i + 5] - box[6 * i + 2]);
    }

    /** Where a search starts that knows nothing of its ray. */
    public Entries whole() {
        return tree.whole();
    }

    /** Finds the subtrees that hold whatever the rays of a bundle can meet. */
    public void enter(Bundle bundle, Entries entries) {
        tree.enter(bundle, entries);
    }

    /** Whether a search of these subtrees can find nothing at all. */
    public boolean isClear(Entries entries) {
        return entries.isEmpty() && endless.length == 0;
    }

    /** The scratch that one worker needs to look for bodies. */
    public Finder newFinder() {
        return new Finder(surfaces, balls, opaque);
    }

    /** The scratch that one worker needs to gather {@link #crossings}. */
    public Finder newGatherer(Spans into) {
        Finder gatherer = new Finder(surfaces, balls, none);
        gatherer.pushTo(into);
        return gatherer;
    }

    /** Pushes every boundary between the ray's min and max, whatever it belongs to. */
    public void crossings(Ray ray, Finder gatherer) {
        for (Surface surface : endless) {
            surface.crossings(ray, gatherer.through);
        }
        tree.any(gatherer, ray, tree.whole());
    }

    /** Finds the ray's nearest hit in the given subtrees. */
    public void nearest(Ray ray, Entries entries, Finder finder) {
        for (Surface surface : endless) {
            surface.nearest(ray);
        }
        tree.nearest(finder, ray, entries, ray.max);
    }

    /**
     * Looks in the given subtrees for what stands between the ray's min and max.
     *
     * @param through receives the boundaries of transparent bodies; incomplete if the answer is not null
     * @return the first opaque body found, or null
     */
    public @Nullable Surface occluder(Ray ray, Entries entries, Finder finder, Spans through) {
        for (int i = 0; i < endless.length; i++) {
            if (blocks(endless[i], endlessOpaque[i], ray, through)) {
                return endless[i];
            }
        }
        finder.pushTo(through);
        return tree.any(finder, ray, entries) ? surfaces[finder.occluder] : null;
    }

    private static boolean blocks(Surface surface, boolean isOpaque, Ray ray, Spans through) {
        if (isOpaque) {
            return surface.occludes(ray);
        }
        surface.crossings(ray, through);
        return false;
    }

    /** What is done at the leaves: scratch of one worker. */
    public static final class Finder extends Search<Ray> {
        private final Surface[] surfaces;
        private final Balls balls;
        private final boolean[] opaque;
        private Spans through = new Spans();
        private int occluder;
        /** Where the ray starts, for the tree: not before its origin, or a little. */
        private double back;

        private Finder(Surface[] surfaces, Balls balls, boolean[] opaque) {
            this.surfaces = surfaces;
            this.balls = balls;
            this.opaque = opaque;
        }

        private void pushTo(Spans spans) {
            if (through != spans) {
                through = spans;
            }
        }

        @Override
        protected void aim(Ray ray) {
            ray.needReciprocals();
            // Trees measure from where a line starts, and know nothing of what lies behind.
            back = ray.min < 0 ? ray.min : 0;
            along(ray.ox + back * ray.dx, ray.oy + back * ray.dy, ray.oz + back * ray.dz, ray.rx, ray.ry, ray.rz,
                    ray.min - back, ray.max - back);
        }

        @Override
        protected double meet(Ray ray, int first, int end) {
            for (int i = end - 1; i >= first; i--) {
                if (balls.mayBeMet(i, ray)) {
                    surfaces[i].nearest(ray);
                }
            }
            // What lies in one place with the hit may still replace it.
            return ray.max + ray.touch(ray.max) - back;
        }

        @Override
        protected boolean stopsAt(Ray ray, int first, int end) {
            for (int i = end - 1; i >= first; i--) {
                if (balls.mayBeMet(i, ray) && blocks(surfaces[i], opaque[i], ray, through)) {
                    occluder = i;
                    return true;
                }
            }
            return false;
        }
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
