package cz.paprsek.render.integrate;

import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.sample.PassSums;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.sample.PixelSums;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;

/**
 * Renders what moves while the shutter is open. Each ray from the eye has a time of its own, which the sampler says: in which of a row of worlds, an instant each, it and all that come of it are traced. The instants are evenly
 * spread, in the middle of parts of the time as long as each other, so that where something is may be wrong by half a part at most.
 */
public final class Exposure implements Integrator {
    private final List<BlockTracer> instants;
    private final List<Eye> eyes;
    private final Sampling sampling;
    private final Sampler sampler;
    private final PixelSums sums;
    /** The same of pixels in passes; null of others. */
    private final @Nullable PassSums passes;
    private final float[] kept;
    private boolean cancelled;

    /**
     * What traces pictures of what moves.
     *
     * @param worlds one for each instant
     * @param eyes in each of them
     */
    public Exposure(List<World> worlds, List<Eye> eyes, int maxDepth, Sampling sampling) {
        this.instants = worlds.stream().<BlockTracer>map(world -> sampling instanceof Passes inPasses ? new Paths(world, maxDepth, inPasses) : new Whitted(world, maxDepth, sampling)).toList();
        // Few rays come to each, so that nothing is worth being found out for them all.
        this.instants.forEach(BlockTracer::forget);
        this.eyes = List.copyOf(eyes);
        this.sampling = sampling;
        this.sampler = sampling.newSampler();
        this.sums = sampling.newSums();
        this.passes = sums instanceof PassSums inPasses ? inPasses : null;
        this.kept = new float[sampling instanceof Passes inPasses ? inPasses.kept() : 0];
    }

    @Override
    public void begin(BooleanSupplier stop) {
        cancelled = false;
        instants.forEach(one -> one.begin(stop));
    }

    @Override
    public void block(Eye first, int x, int y, int width, int height, Film film) {
        for (int i = 0; i < width * height && !cancelled; i++) {
            sums.clear();
            if (passes != null) {
                pass(passes, x + i % width, y + i / width, film);
            } else {
                whole(x + i % width, y + i / width, film);
            }
        }
    }

    private void whole(int x, int y, Film film) {
        for (int more = sampling.rays(); more > 0 && !cancelled; more = sampling.further(sums)) {
            trace(x, y, more);
        }
        sums.mean();
        film.set(x, y, sums.red, sums.green, sums.blue);
    }

    /** As {@link Paths} does. */
    private void pass(PassSums own, int x, int y, Film film) {
        film.kept(x, y, kept);
        own.load(kept, 0);
        int more = sampling.further(own);
        if (more == 0) {
            return;
        }
        trace(x, y, more);
        if (cancelled) {
            return;
        }
        if (own.areWhole()) {
            own.save(kept, 0);
            film.keep(x, y, kept);
        }
        own.mean();
        film.set(x, y, own.red, own.green, own.blue);
        if (sampling.further(own) > 0) {
            film.wantMore(1);
        }
    }

    private void trace(int x, int y, int more) {
        for (int i = 0; i < more && !cancelled; i++) {
            int number = sums.count();
            sampler.start(x, y, number);
            sampler.time();
            sampler.next();
            int when = (int) (sampler.u * instants.size());
            BlockTracer tracer = instants.get(when);
            tracer.traceAlone(eyes.get(when), x, y, number);
            Level level = tracer.alone();
            cancelled = tracer.isCancelled();
            sums.meets |= level.ray.part >= 0;
            sums.add(level.red, level.green, level.blue, level.isNegative);
        }
    }

    @Override
    public boolean isCancelled() {
        return cancelled;
    }

    @Override
    public long rays() {
        long rays = 0;
        for (BlockTracer one : instants) {
            rays += one.rays();
        }
        return rays;
    }

    @Override
    public Work work() {
        Work all = new Work(0, 0, 0, 0, 0);
        for (BlockTracer one : instants) {
            Work own = one.work();
            all = new Work(all.primary() + own.primary(), all.reflected() + own.reflected(), all.refracted() + own.refracted(), all.shadows() + own.shadows(), all.hits() + own.hits());
        }
        return all;
    }
}
