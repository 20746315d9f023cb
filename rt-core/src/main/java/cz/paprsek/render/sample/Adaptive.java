package cz.paprsek.render.sample;

import cz.paprsek.scene.RenderSettings;

/** Random rays: some for every pixel, then twice as many and so on, until those there are tell its value well enough. */
final class Adaptive extends Sampling {
    private final int least;
    private final int most;

    Adaptive(RenderSettings settings, boolean fixed) {
        super(settings, settings.mostRays(), fixed);
        least = settings.samples() * settings.samples();
        most = settings.mostRays();
    }

    /** How often a pixel that gets all rays is judged: each time before it gets more, but for those too few to be judged. */
    static int looks(RenderSettings settings) {
        int looks = 0;
        for (int n = Math.max(Target.FEWEST, settings.samples() * settings.samples()); n < settings.mostRays(); n *= 2) {
            looks++;
        }
        return looks;
    }

    @Override
    public boolean isPlain() {
        return false;
    }

    @Override
    public int rays() {
        return least;
    }

    @Override
    public int further(PixelSums own) {
        int count = own.count();
        if (count >= most || (count >= Target.FEWEST && own.areNear())) {
            return 0;
        }
        return Math.min(Math.max(Target.FEWEST, 2 * count), most) - count;
    }

    @Override
    public void place(Sampler sampler, int x, int y, int sample, Place out) {
        sampler.start(x, y, sample);
        sampler.filter();
        sampler.next();
        place(sampler.u, sampler.v, out);
    }
}
