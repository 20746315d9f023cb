package cz.paprsek.render.sample;

import cz.paprsek.scene.RenderSettings;

/** Where in a pixel its rays go through, and how many there are: one class for each pattern. Immutable; each worker has scratch of its own. */
public abstract class Sampling {
    private final int most;
    private final int together;
    private final boolean fixed;
    private final RenderSettings settings;
    private final Strewing strewing;

    /**
     * What all kinds have in common.
     *
     * @param most how many rays a pixel gets at most
     * @param together how many of them are summed before their sum is added to the others'
     */
    Sampling(RenderSettings settings, int most, int together, boolean fixed) {
        this.most = most;
        this.together = together;
        this.fixed = fixed;
        this.settings = settings;
        this.strewing = Strewing.of(settings.filter());
    }

    /**
     * What a picture is rendered with.
     *
     * @param fixed whether what is random is the same in every pixel
     */
    public static Sampling of(RenderSettings settings, boolean fixed) {
        return settings.isAdaptive() ? new Adaptive(settings, fixed) : new Grid(settings, fixed);
    }

    /** A regular grid of so many rays along each side of a pixel. */
    public static Sampling grid(int perSide) {
        return of(RenderSettings.DEFAULT.withSamples(perSide), false);
    }

    /**
     * A number of paths for each pixel.
     *
     * @param paths how many, from 1 on
     * @param fixed whether what is random is the same in every pixel
     */
    public static Sampling paths(RenderSettings settings, int paths, boolean fixed) {
        return new Passes(settings, paths, fixed);
    }

    /** The worker's scratch that says what is random in the pixels. */
    public final Sampler newSampler() {
        return fixed ? Sampler.fixed(most) : Sampler.scrambled(most);
    }

    /** The worker's scratch that holds the samples of a pixel. */
    public final PixelSums newSums() {
        return new PixelSums(most, together, strewing.mass() * strewing.mass(), new Target(settings, Adaptive.looks(settings)));
    }

    /** How many rays a pixel gets at most. */
    public final int most() {
        return most;
    }

    /** How many pixels beyond its own a pixel's rays may reach, to each side. */
    public final int reach() {
        return strewing.reach();
    }

    /** Whether every pixel gets one ray, and is what this brings. */
    public abstract boolean isPlain();

    /** How many rays every pixel gets. */
    public abstract int rays();

    /** How many rays a pixel is to get beyond those whose light is there; 0 if these are enough. */
    public abstract int further(PixelSums own);

    /** Says where a sample's ray goes through. */
    public abstract void place(Sampler sampler, int x, int y, int sample, Place out);

    final void place(double u, double v, Place out) {
        out.x = strewing.place(u);
        out.y = strewing.place(v);
        out.isNegative = strewing.isNegative(out.x) != strewing.isNegative(out.y);
    }
}
