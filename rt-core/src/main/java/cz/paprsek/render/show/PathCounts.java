package cz.paprsek.render.show;

import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.integrate.Paths;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.render.sample.PassSums;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.surface.World;

/** The tracer of paths, watched for how many rays they take, and how near they bring a pixel. */
public final class PathCounts extends Paths {
    private final RenderMode mode;
    private final Passes sampling;
    private final PassSums sums;
    private final Heat heat;
    private final float[] kept;

    public PathCounts(World scene, RenderMode mode, int maxDepth, Passes sampling, boolean numbers) {
        super(scene, maxDepth, sampling);
        this.mode = mode;
        this.sampling = sampling;
        this.heat = Heat.of(mode, numbers);
        sums = sampling.newSums();
        kept = new float[kept(sampling)];
    }

    /** How many numbers of a pixel are kept from pass to pass: its sums, and what was counted, of which more than 2²⁴ are rounded. */
    public static int kept(Passes sampling) {
        return sampling.kept() + 1;
    }

    @Override
    protected void pass(Eye eye, int x, int y, Film film) {
        film.kept(x, y, kept);
        int at = sums.load(kept, 0);
        int more = sampling.further(sums);
        if (more == 0) {
            return;
        }
        double interval = sums.interval();
        forget();
        long before = counted();
        for (int i = 0; i < more; i++) {
            traceAlone(eye, x, y, sums.count());
            sums.meets |= alone().ray.part >= 0;
            sums.add(alone().red, alone().green, alone().blue, alone().isNegative);
        }
        if (isCancelled()) {
            return;
        }
        kept[at] += counted() - before;
        if (sums.areWhole()) {
            sums.save(kept, 0);
            film.keep(x, y, kept);
            interval = sums.interval();
        }
        heat.show(mode == RenderMode.ERROR ? interval : mode == RenderMode.SAMPLES ? sums.count() : kept[at], x, y, film);
        if (sampling.further(sums) > 0) {
            film.wantMore(1);
        }
    }

    private long counted() {
        return mode == RenderMode.RAYS ? rays() : nodeVisits();
    }
}
