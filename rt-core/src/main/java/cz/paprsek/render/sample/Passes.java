package cz.paprsek.render.sample;

import cz.paprsek.scene.RenderSettings;

/**
 * Paths: the same number for every pixel, pass by pass; or some for every pixel, and more until they tell its value well enough. That is judged only when their number has
 * doubled, as often as it can double at most, whatever number is asked for: so who asks for more later gets what he would have got at once.
 */
public final class Passes extends Sampling {
    private static final int PASS = PassSums.PASS;
    /** How often a number of paths can double from that of a pass on before there are {@value RenderSettings#MOST_PATHS}, and so how often a pixel is judged at most. */
    private static final int LOOKS = 14;

    private final RenderSettings settings;
    private final boolean isJudged;
    private final int least;
    private final int most;

    /** @param fixed whether what is random is the same in every pixel */
    public Passes(RenderSettings settings, boolean fixed) {
        this(settings, fixed, settings.isAdaptive());
    }

    /**
     * Paths of which it is known how near they bring a pixel.
     *
     * @param isJudged whether that is to be known, also if no pixel is to get more or fewer for it
     */
    public Passes(RenderSettings settings, boolean fixed, boolean isJudged) {
        super(settings, settings.mostRays(), fixed);
        this.settings = settings;
        this.isJudged = isJudged || settings.isAdaptive();
        least = settings.samples();
        most = settings.mostRays();
    }

    @Override
    public Sampler newSampler() {
        return Sampler.ofPaths(isFixed());
    }

    @Override
    public PassSums newSums() {
        return newSums(isJudged);
    }

    @Override
    public PassSums newOtherSums() {
        return newSums(false);
    }

    private PassSums newSums(boolean areJudged) {
        return new PassSums(mass(), isSigned(), areJudged, new Target(settings, Sampler.SCRAMBLES, LOOKS));
    }

    /** How many standard deviations of the mean the truth is within, with the confidence that is asked for, if that of independent sequences is looked at once. */
    public double deviations() {
        return Target.quantile(1 - settings.confidence(), Sampler.SCRAMBLES - 1);
    }

    /** How many numbers keep the sums of a pixel. */
    public int kept() {
        return PassSums.size(isSigned(), isJudged);
    }

    /** How many numbers keep {@linkplain #newOtherSums other sums} of a pixel. */
    public int keptOfOthers() {
        return PassSums.size(isSigned(), false);
    }

    /** How many passes there are at most. */
    public static int passes(RenderSettings settings) {
        return (settings.mostRays() + PASS - 1) / PASS;
    }

    @Override
    public boolean isPlain() {
        return false;
    }

    @Override
    public int rays() {
        return Math.min(PASS, most);
    }

    @Override
    public int further(PixelSums own) {
        int count = own.count();
        if (count >= most || (count >= least && settings.isAdaptive() && isLook(count) && own.areNear())) {
            return 0;
        }
        return Math.min(PASS, most - count);
    }

    /** Whether a number is that of the first pass, or that doubled and doubled again. */
    private static boolean isLook(int count) {
        return count % PASS == 0 && Integer.bitCount(count / PASS) == 1;
    }

    @Override
    public void place(Sampler sampler, int x, int y, int sample, Place out) {
        sampler.start(x, y, sample);
        sampler.filter();
        sampler.next();
        place(sampler.u, sampler.v, out);
    }
}
