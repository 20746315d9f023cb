package cz.paprsek.render.integrate;

import cz.paprsek.math.Vec3;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.sample.PixelSums;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Bodies;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import cz.paprsek.shape.placed.Sheaf;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.tree.Bundle;
import cz.paprsek.tree.Entries;

/**
 * Renders blocks of pixels by following the rays that each of them gets. What a block's rays can meet, and what can stand between their hits
 * and each light, is found once for all of them.
 */
abstract class BlockTracer extends Shading {
    /** Into how many subtrees a block's search is split at most: as measured. Rays stop at the first that lies behind what they hit. */
    private static final int MOST_ENTRIES = 24;

    private final Bodies bodies;
    private final CameraRays cameraRays;
    private final Sampling sampling;
    private final Bundle bundle = new Bundle();
    private final Entries entries = new Entries(MOST_ENTRIES);
    private final Sheaf sheaf;
    private final PixelSums sums;
    private final Spans spans;
    private Level[] block = {};
    private Level[] further = {};

    /** @param isPath whether one ray is followed at each hit, rather than one for each way that light comes */
    BlockTracer(World scene, int levels, Sampling sampling, boolean isPath, Spans spans, Witness witness) {
        super(scene, levels, sampling.newSampler(), isPath, spans, witness);
        this.spans = spans;
        this.bodies = scene.bodies();
        this.sampling = sampling;
        this.cameraRays = new CameraRays(scene, sampling, sampler);
        this.sheaf = bodies.newSheaf();
        this.sums = sampling.newSums();
    }

    /** Renders a block of pixels. */
    @Override
    public void block(Eye eye, int x, int y, int width, int height, Film film) {
        Level[] rays = trace(eye, x, y, width, height);
        for (int i = 0; i < width * height && !cancelled; i++) {
            if (sampling.isPlain()) {
                film.set(x + i % width, y + i / width, rays[i].red, rays[i].green, rays[i].blue);
            } else {
                develop(rays, i, eye, x + i % width, y + i / width, film);
            }
        }
    }

    private void develop(Level[] rays, int pixel, Eye eye, int x, int y, Film film) {
        sums.clear();
        add(rays, pixel * sampling.rays(), sampling.rays(), sums);
        complete(eye, x, y);
        sums.mean();
        film.set(x, y, sums.red, sums.green, sums.blue);
    }

    /** Traces all rays of a pixel, and says what they come to. */
    public final PixelSums pixel(Eye eye, int x, int y) {
        sums.clear();
        add(trace(eye, x, y, 1, 1), 0, sampling.rays(), sums);
        complete(eye, x, y);
        sums.mean();
        return sums;
    }

    /** Traces all rays of a pixel one by one, as if there were no others; how many, is told. */
    protected final int eachAlone(Eye eye, int x, int y) {
        sums.clear();
        for (int more = sampling.rays(); more > 0 && !cancelled; more = sampling.further(sums)) {
            for (int i = 0; i < more; i++) {
                traceAlone(eye, x, y, sums.count());
                add(levels, 0, 1, sums);
                tracedAlone();
            }
        }
        return sums.count();
    }

    /** How near to the true value the pixel is whose rays were traced so last, if they are judged. */
    protected final double interval() {
        return sums.interval();
    }

    /** One of a pixel's rays has been traced by itself; the light it brought is in {@link #alone}. */
    protected void tracedAlone() {}

    private void complete(Eye eye, int x, int y) {
        for (int more = sampling.further(sums); more > 0 && !cancelled; more = sampling.further(sums)) {
            add(more, eye, x, y, sums);
        }
    }

    /** Traces so many more rays of a pixel. */
    final void add(int more, Eye eye, int x, int y, PixelSums to) {
        further = levels(further, more);
        trace(eye, x, y, 1, 1, to.count(), more, further);
        add(further, 0, more, to);
    }

    private static void add(Level[] rays, int from, int count, PixelSums to) {
        for (int i = from; i < from + count; i++) {
            to.meets |= rays[i].ray.part >= 0;
            to.add(rays[i].red, rays[i].green, rays[i].blue, rays[i].isNegative);
        }
    }

    /**
     * Traces the rays that every pixel of a block gets; the light they bring is in the levels returned, pixel by pixel. What they can meet, and
     * what can stand between their hits and each light, is found once for all; the light is the same as for each ray alone.
     */
    public final Level[] trace(Eye eye, int x, int y, int width, int height) {
        block = levels(block, width * height * sampling.rays());
        trace(eye, x, y, width, height, 0, sampling.rays(), block);
        return block;
    }

    private void trace(Eye eye, int x, int y, int width, int height, int sample, int perPixel, Level[] first) {
        int rays = width * height * perPixel;
        Entries among = start(eye, x, y, width, height, sample, perPixel, first);
        for (int i = 0; i < rays; i++) {
            if (!first[i].ray.isBlind()) {
                intersector.find(first[i], among);
            }
        }
        primary += rays;
        lighting.starts.prepare(first, rays);
        if (lighting.ofBlocks.isPresent()) {
            shade(first, rays, lighting.ofBlocks.get());
            return;
        }
        boolean isRandom = lighting.isRandom();
        for (int i = 0; i < rays; i++) {
            if (isRandom) {
                int pixel = i / perPixel;
                sampler.start(x + pixel % width, y + pixel / width, sample + i % perPixel);
            }
            shade(first[i], 0);
        }
    }

    /** Finds the light of rays of which is known what they hit, that of lights for all hits at once. */
    private void shade(Level[] first, int rays, BlockLighting light) {
        for (int i = 0; i < rays; i++) {
            arrive(first[i]);
        }
        light.illuminate(first, rays);
        for (int i = 0; i < rays; i++) {
            if (first[i].ray.part >= 0) {
                scatter(first[i], 0, first[i].finish);
                leave(first[i]);
            }
        }
    }

    /** Starts the rays, and finds where to look for what they meet and have not met yet. */
    private Entries start(Eye eye, int x, int y, int width, int height, int sample, int perPixel, Level[] first) {
        int rays = width * height * perPixel;
        int reach = sampling.reach();
        cameraRays.from(eye);
        boolean areAimed = cameraRays.aim(first, eye, x, y, width, height, sample, perPixel);
        boolean isSheafOfUse = areAimed && sheaf.isOfUse();
        if (isSheafOfUse) {
            sheaf.start(rays);
            for (int i = 0; i < rays; i++) {
                cameraRays.start(first[i], eye, i);
                sheaf.add(first[i].ray);
            }
        } else if (areAimed) {
            for (int i = 0; i < rays; i++) {
                cameraRays.start(first[i], eye, i);
            }
        }
        if (!eye.bundle(bundle, x - reach, y - reach, width + 2 * reach, height + 2 * reach)) {
            return bodies.whole();
        }
        if (isSheafOfUse && bundle.hasFrustum()) {
            bodies.enter(bundle, entries, sheaf);
        } else {
            bodies.enter(bundle, entries);
        }
        return entries;
    }

    /** The same, or more if there are too few. */
    private Level[] levels(Level[] made, int size) {
        if (made.length >= size) {
            return made;
        }
        Level[] levels = new Level[size];
        for (int i = 0; i < size; i++) {
            levels[i] = new Level(spans);
            levels[i].path = Sampler.EYE;
        }
        return levels;
    }

    /** The level of a ray that is traced by itself: to be started by {@link #startAlone}, then traced by {@link #traceAlone()}. */
    public final Level alone() {
        return levels[0];
    }

    /** Starts the ray of {@link #alone} through a point of the picture, where it is in what is around there. */
    public final void startAlone(Eye eye, double x, double y) {
        cameraRays.from(eye);
        cameraRays.start(levels[0], eye, x, y);
    }

    /** Starts the ray of {@link #alone} anywhere, in a direction of length 1. */
    public final void startAlone(Vec3 origin, Vec3 direction) {
        cameraRays.start(levels[0], origin, direction);
    }

    /** Finds what the ray of {@link #alone} hits. */
    public final void findAlone() {
        intersector.find(levels[0], bodies.whole());
    }

    /** Traces a sample's ray from the eye by itself; the light it brings is in {@link #alone}. */
    public final void traceAlone(Eye eye, int column, int row, int sample) {
        cameraRays.from(eye);
        cameraRays.start(levels[0], eye, column, row, sample);
        sampler.start(column, row, sample);
        traceAlone();
    }

    /** Traces the ray of {@link #alone}, as if it were that of the first sample of the first pixel. */
    public final void traceAlone() {
        primary++;
        lighting.starts.prepareNothing();
        trace(0);
    }

    /** Forgets what rays before have shown: what those that follow take hangs on nothing before them then. */
    protected final void forget() {
        lighting.forget();
    }

    /** Nodes of the tree visited so far, leaves included, those of bundles not. */
    public final long nodeVisits() {
        return intersector.nodeVisits();
    }
}
