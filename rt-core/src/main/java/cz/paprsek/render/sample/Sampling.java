package cz.paprsek.render.sample;

import cz.paprsek.scene.RenderSettings;

/** Where in a pixel its rays go through, and how many there are: one class for each pattern. Immutable; each worker has scratch of its own. */
public abstract class Sampling {
    private final int most;
    private final boolean fixed;
    private final RenderSettings settings;
    private final Strewing strewing;

    /**
     * What all kinds have in common.
     *
     * @param most how many rays a pixel gets at most
     */
    Sampling(RenderSettings settings, int most, boolean fixed) {
        this.most = most;
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
        return settings.isPath() ? new Passes(settings, fixed) : settings.isAdaptive() ? new Adaptive(settings, fixed) : new Grid(settings, fixed);
    }

    /** A regular grid of so many rays along each side of a pixel. */
    public static Sampling grid(int perSide) {
        return of(RenderSettings.DEFAULT.withSamples(perSide), false);
    }

    /** The worker's scratch that says what is random in the pixels. */
    public Sampler newSampler() {
        return fixed ? Sampler.fixed(most) : Sampler.scrambled(most);
    }

    /** The worker's scratch that holds the samples of a pixel. */
    public PixelSums newSums() {
        return new HeldSums(most, mass(), new Target(settings, HeldSums.GROUPS, Adaptive.looks(settings)));
    }

    /** Sums of what else there is of a pixel's samples, by which nobody judges them. */
    public PixelSums newOtherSums() {
        return newSums();
    }

    final boolean isFixed() {
        return fixed;
    }

    /** What the filter weighs in all, if what is below nothing is counted as if it were above. */
    final double mass() {
        return strewing.mass() * strewing.mass();
    }

    /** Whether the filter is below nothing somewhere. */
    final boolean isSigned() {
        return mass() > 1;
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
