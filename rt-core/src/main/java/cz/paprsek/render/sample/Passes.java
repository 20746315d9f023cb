package cz.paprsek.render.sample;

import cz.paprsek.scene.RenderSettings;

/** Random rays, the same number for every pixel, pass by pass: what a pass brings is summed by itself. */
final class Passes extends Sampling {
    /** How many rays of a pixel a pass has. */
    private static final int PASS = 64;

    private final int paths;

    Passes(RenderSettings settings, int paths, boolean fixed) {
        super(settings, paths, PASS, fixed);
        this.paths = paths;
    }

    @Override
    public boolean isPlain() {
        return false;
    }

    @Override
    public int rays() {
        return Math.min(PASS, paths);
    }

    @Override
    public int further(PixelSums own) {
        return Math.min(PASS, paths - own.count());
    }

    @Override
    public void place(Sampler sampler, int x, int y, int sample, Place out) {
        sampler.start(x, y, sample);
        sampler.filter();
        sampler.next();
        place(sampler.u, sampler.v, out);
    }
}
