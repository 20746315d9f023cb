package cz.paprsek.render.surface;

import cz.paprsek.math.Bounds;
import cz.paprsek.render.buffer.LightBuffer;
import cz.paprsek.render.buffer.LightBuffers;
import cz.paprsek.render.hull.Endless;
import cz.paprsek.render.hull.Few;
import cz.paprsek.render.hull.Hull;
import cz.paprsek.render.hull.Loose;
import cz.paprsek.render.hull.Walls;
import cz.paprsek.shape.placed.Balls;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Sheaf;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.shape.placed.Volume;
import cz.paprsek.tree.Bundle;
import cz.paprsek.tree.Entries;
import cz.paprsek.tree.ItemBoxes;
import cz.paprsek.tree.Row;
import cz.paprsek.tree.Search;
import cz.paprsek.tree.Tree;
import cz.paprsek.tree.TreeBuilder;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/** The bodies of a scene in a tree. Those without end stand apart and are met by every ray. */
public final class Bodies {
    /** The cost up to which a body is asked as fast as a box. */
    private static final double QUICK = 2;
    /** So many bodies within walls are met as they come, where nothing is known of a ray: boxes around them cost more. */
    private static final int LOOSE = 4;

    /** In the order of the tree's leaves. */
    private final Surface[] surfaces;
    private final Balls balls;
    private final boolean[] opaque;
    /** In place of which bodies are opaque, for who wants the boundaries of all. */
    private final boolean[] none;
    private final Tree tree;
    private final Entries whole;
    /** How many bodies there are, also empty ones. */
    private final int count;
    /** Which body, by its number in the scene, each of the surfaces is. */
    private final int[] order;
    /** Walls around the others, which are not in the tree. */
    private final Hull hull;
    /** Whether a ray of which nothing is known meets all without the tree. */
    private final boolean areLoose;
    private final Loose loose;
    private final Endless endless;
    /** Which of the surfaces in the tree are no longer there, and the bodies that are there instead; null if all are. */
    private final BitSet gone;
    private final @Nullable Bodies beside;
    /** What finds what stands in the way of lights in place of the tree. */
    private final Optional<LightBuffers> buffers;
    /** Where among the surfaces each body is; empty until it is asked for. */
    private int[] places = {};

    private Bodies(Surface[] all, boolean[] allOpaque, int[] finite, int[] infinite, Hull hull, Tree tree) {
        this.surfaces = pick(all, finite);
        this.balls = new Balls(surfaces);
        this.opaque = pick(allOpaque, finite);
        this.none = new boolean[finite.length];
        this.tree = tree;
        this.whole = areFew() ? Entries.atOnce(surfaces.length) : tree.whole();
        this.count = all.length;
        this.order = finite;
        this.hull = hull;
        boolean areWithin = !hull.isNone() && finite.length <= LOOSE;
        Optional<Row> row = areWithin || !areFew() ? Optional.empty() : balls.row();
        this.areLoose = areWithin || row.isPresent();
        this.loose = row.<Loose>map(known -> new Few(surfaces, opaque, known)).orElseGet(() -> new Loose(surfaces, opaque));
        this.endless = new Endless(all, allOpaque, infinite);
        this.gone = new BitSet(0);
        this.beside = null;
        this.buffers = areLoose ? Optional.empty() : Optional.of(new LightBuffers(surfaces, balls, opaque));
    }

    private Bodies(Bodies all, BitSet gone, Endless endless, Hull hull, Bodies beside) {
        this.surfaces = all.surfaces;
        this.balls = all.balls;
        this.opaque = all.opaque;
        this.none = all.none;
        this.tree = all.tree;
        this.whole = all.whole;
        this.count = all.count;
        this.order = all.order;
        this.hull = hull;
        this.areLoose = false;
        this.loose = all.loose;
        this.endless = endless;
        this.gone = gone;
        this.beside = beside;
        this.buffers = Optional.empty();
    }

    /**
     * These bodies, of which none has been exchanged, with others in the place of some: in a tree of their own, while this one's passes over
     * those that are gone.
     *
     * @param which numbers in the scene, rising
     */
    Bodies with(int[] which, Surface[] fresh, boolean[] freshOpaque, BooleanSupplier stop) {
        int[] known = places();
        BitSet missing = new BitSet();
        for (int body : which) {
            if (known[body] >= 0) {
                missing.set(known[body]);
            }
        }
        IntPredicate isKept = body -> Arrays.binarySearch(which, body) < 0;
        return new Bodies(this, missing, endless.only(isKept), hull.only(isKept), of(fresh, freshOpaque, stop));
    }

    /** Found once; several threads that do so find the same. */
    private int[] places() {
        int[] known = places;
        if (known.length < count) {
            known = new int[count];
            Arrays.fill(known, -1);
            for (int i = 0; i < order.length; i++) {
                known[order[i]] = i;
            }
            places = known;
        }
        return known;
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
        Hull hull = Walls.among(surfaces, opaque, finite);
        int[] inside = hull.isNone() ? finite : Arrays.stream(finite).filter(i -> !hull.has(i)).toArray();
        // Building puts the numbers of those inside into the order of the leaves.
        Tree tree = new TreeBuilder(ItemBoxes.of(box), inside, cost, stop).build();
        return new Bodies(surfaces, opaque, inside, infinite, hull, tree);
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
        return whole;
    }

    /** Whether all are asked at least as fast as boxes around them: nearly all rays pass by most bodies, which balls tell. */
    private boolean areFew() {
        return surfaces.length <= Tree.LEAF && balls.areMost && Arrays.stream(surfaces).allMatch(surface -> surface.cost() <= QUICK);
    }

    /** Finds the subtrees that hold whatever the rays of a bundle can meet. */
    public void enter(Bundle bundle, Entries entries) {
        tree.enter(bundle, entries);
    }

    /** The same of a bundle with a frustum, whose rays are in a sheaf: much is met by all of them at once, and need not be looked for any more. */
    public void enter(Bundle bundle, Entries entries, Sheaf sheaf) {
        if (beside == null) {
            sheaf.bind(bundle.frustum());
            tree.enter(bundle, entries, sheaf);
        } else {
            tree.enter(bundle, entries);
        }
    }

    /** Whether a search of these subtrees can find nothing at all. */
    public boolean isClear(Entries entries) {
        return entries.isEmpty() && endless.isNone() && hull.isNone() && beside == null;
    }

    /** Whether some of them are walls of which a ray meets but the one through which it leaves the room. */
    boolean haveHull() {
        return !hull.isNone();
    }

    /** Whether no solid that has an end reaches into a box. */
    boolean areFree(Bounds box) {
        return !tree.any(box, i -> !gone.get(i) && surfaces[i] instanceof Volume solid && !solid.bounds().padded().intersection(box).isEmpty())
                && (beside == null || beside.areFree(box));
    }

    /** The scratch that one worker needs to look for bodies. */
    public Finder newFinder() {
        return newFinder(opaque, beside == null ? null : beside.newFinder());
    }

    /** The scratch that one worker needs to meet bodies with many rays at once. */
    public Sheaf newSheaf() {
        return new Sheaf(surfaces, balls);
    }

    /** The scratch that one worker needs to gather {@link #crossings}. */
    public Finder newGatherer(Spans into) {
        Finder gatherer = newFinder(none, beside == null ? null : beside.newGatherer(into));
        gatherer.pushTo(into);
        return gatherer;
    }

    private Finder newFinder(boolean[] takenAsOpaque, @Nullable Finder among) {
        return among == null ? new Finder(this, takenAsOpaque, null) : new PassingFinder(this, takenAsOpaque, among);
    }

    /** Pushes every boundary between the ray's min and max, whatever it belongs to. */
    public void crossings(Ray ray, Finder gatherer) {
        endless.crossings(ray, gatherer.through);
        hull.crossings(ray, gatherer.through);
        tree.any(gatherer, ray, whole);
        Finder more = gatherer.beside;
        if (more != null) {
            more.bodies.crossings(ray, more);
        }
    }

    /** Finds the ray's nearest hit in the given subtrees. */
    public void nearest(Ray ray, Entries entries, Finder finder) {
        hull.nearest(ray);
        endless.nearest(ray);
        if (areLoose && entries == whole && finder.isSoFar(loose)) {
            loose.nearest(ray, finder.scratch);
            return;
        }
        tree.nearest(finder, ray, entries, ray.reach);
        Finder more = finder.beside;
        if (more != null) {
            more.bodies.nearest(ray, more.bodies.whole(), more);
        }
    }

    /**
     * Looks in the given subtrees for what stands between the ray's min and max.
     *
     * @param through receives the boundaries of transparent bodies; incomplete if the answer is not null
     * @return the first opaque body found, or null
     */
    public @Nullable Surface occluder(Ray ray, Entries entries, Finder finder, Spans through) {
        Surface before = endless.occluder(ray, through);
        if (before != null) {
            return before;
        }
        if (areLoose && entries == whole && finder.isSoFar(loose)) {
            Surface near = loose.occluder(ray, through, finder.scratch);
            return near == null ? hull.occluder(ray) : near;
        }
        finder.pushTo(through);
        if (tree.any(finder, ray, entries)) {
            return surfaces[finder.occluder];
        }
        Surface wall = hull.occluder(ray);
        if (wall != null) {
            return wall;
        }
        Finder more = finder.beside;
        return more == null ? null : more.bodies.occluder(ray, more.bodies.whole(), more, through);
    }

    /** What finds the same for lights, where it is of use. */
    public Optional<LightBuffers> buffers() {
        return buffers;
    }

    /** The same as from anywhere in the tree, by one of the {@link #buffers}. */
    public @Nullable Surface occluder(Ray ray, LightBuffer buffer, Spans through) {
        Surface found = endless.occluder(ray, through);
        found = found == null ? buffer.occluder(ray, through) : found;
        return found == null ? hull.occluder(ray) : found;
    }

    /** What is done at the leaves: scratch of one worker. */
    public static class Finder extends Search<Ray> {
        private final Bodies bodies;
        private final Surface[] surfaces;
        private final Balls balls;
        private final boolean[] opaque;
        /** Looks among those that are beside them. */
        private final @Nullable Finder beside;
        private Spans through = new Spans();
        private int occluder;
        private final Loose.Scratch scratch = new Loose.Scratch();
        /** Where the ray starts, for the tree: not before its origin, or a little. */
        private double back;

        private Finder(Bodies bodies, boolean[] opaque, @Nullable Finder beside) {
            this.bodies = bodies;
            this.surfaces = bodies.surfaces;
            this.balls = bodies.balls;
            this.opaque = opaque;
            this.beside = beside;
        }

        /** The number of tree nodes visited so far. */
        public final long visited() {
            return visits() + (beside == null ? 0 : beside.visited());
        }

        private boolean isSoFar(Loose among) {
            boolean is = among.take(scratch);
            visit(is ? among.visits() : 0);
            return is;
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
                    ray.min - back, ray.reach - back);
        }

        @Override
        protected double meet(Ray ray, int first, int end) {
            for (int i = end - 1; i >= first; i--) {
                if (balls.mayBeMet(i, ray)) {
                    surfaces[i].nearest(ray);
                }
            }
            return reach(ray);
        }

        /** How far the search goes on: what lies in one place with the hit may still replace it. */
        final double reach(Ray ray) {
            return ray.max + ray.touch(ray.max) - back;
        }

        @Override
        protected boolean stopsAt(Ray ray, int first, int end) {
            for (int i = end - 1; i >= first; i--) {
                if (balls.mayBeMet(i, ray) && Loose.blocks(surfaces[i], opaque[i], ray, through)) {
                    occluder = i;
                    return true;
                }
            }
            return false;
        }
    }

    /** Passes over those that are gone. */
    private static final class PassingFinder extends Finder {
        private final BitSet gone;

        PassingFinder(Bodies bodies, boolean[] opaque, Finder beside) {
            super(bodies, opaque, beside);
            gone = bodies.gone;
        }

        @Override
        protected double meet(Ray ray, int first, int end) {
            for (int i = end - 1; i >= first; i--) {
                if (!gone.get(i)) {
                    super.meet(ray, i, i + 1);
                }
            }
            return reach(ray);
        }

        @Override
        protected boolean stopsAt(Ray ray, int first, int end) {
            for (int i = end - 1; i >= first; i--) {
                if (!gone.get(i) && super.stopsAt(ray, i, i + 1)) {
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
