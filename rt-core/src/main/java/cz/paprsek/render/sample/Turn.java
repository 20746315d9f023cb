package cz.paprsek.render.sample;

/**
 * Scratch of one worker: cosine and sine of a share of a full turn, both at once, the same on every machine, to within 4·10⁻¹⁶. Random directions ask for
 * them by the billion: a polynomial takes a fraction of the time of {@link StrictMath}.
 */
public final class Turn {
    /** The factors of cos x = 1 + Σ c·x²ⁿ and sin x = x + x·Σ s·x²ⁿ, for n from 1: up to a quarter of a turn the first one left out is worth 3·10⁻¹⁷ at most. */
    private static final double C1 = -1.0 / 2;
    private static final double C2 = 1.0 / 24;
    private static final double C3 = -1.0 / 720;
    private static final double C4 = 1.0 / 40_320;
    private static final double C5 = -1.0 / 3_628_800;
    private static final double C6 = 1.0 / 479_001_600;
    private static final double C7 = -1.0 / 87_178_291_200.0;
    private static final double C8 = 1.0 / 20_922_789_888_000.0;
    private static final double C9 = -1.0 / 6_402_373_705_728_000.0;
    private static final double C10 = 1.0 / 2_432_902_008_176_640_000.0;
    private static final double S1 = -1.0 / 6;
    private static final double S2 = 1.0 / 120;
    private static final double S3 = -1.0 / 5040;
    private static final double S4 = 1.0 / 362_880;
    private static final double S5 = -1.0 / 39_916_800;
    private static final double S6 = 1.0 / 6_227_020_800.0;
    private static final double S7 = -1.0 / 1_307_674_368_000.0;
    private static final double S8 = 1.0 / 355_687_428_096_000.0;
    private static final double S9 = -1.0 / 121_645_100_408_832_000.0;
    private static final double S10 = 1.0 / 51_090_942_171_709_440_000.0;

    public double cosine;
    public double sine;

    /** @param share of a full turn, 1 being 360°: any number up to 10⁹ in size */
    public void by(double share) {
        double halves = Math.rint(2 * share);
        double sign = 1 - 2 * ((int) halves & 1);
        double x = 2 * Math.PI * (share - halves / 2);
        double t = x * x;
        double c = 1 + t * (C1 + t * (C2 + t * (C3 + t * (C4 + t * (C5 + t * (C6 + t * (C7 + t * (C8 + t * (C9 + t * C10)))))))));
        double s = 1 + t * (S1 + t * (S2 + t * (S3 + t * (S4 + t * (S5 + t * (S6 + t * (S7 + t * (S8 + t * (S9 + t * S10)))))))));
        cosine = sign * c;
        sine = sign * x * s;
    }

    /**
     * The same of many shares, bit for bit, times a factor for each: in plain loops, which the JVM makes vectors of.
     *
     * @param shares between 0 and 1; become angles
     * @param factors change their sign where that of both does
     */
    static void by(int count, double[] shares, double[] factors, double[] cosines, double[] sines) {
        halve(count, shares, factors);
        cosines(count, shares, factors, cosines);
        sines(count, shares, factors, sines);
    }

    private static void halve(int count, double[] shares, double[] factors) {
        for (int i = 0; i < count; i++) {
            double halves = Math.rint(2 * shares[i]);
            factors[i] *= 1 - 2 * (halves * (2 - halves));
            shares[i] = 2 * Math.PI * (shares[i] - halves / 2);
        }
    }

    private static void cosines(int count, double[] angles, double[] factors, double[] cosines) {
        for (int i = 0; i < count; i++) {
            double t = angles[i] * angles[i];
            cosines[i] = factors[i] * (1 + t * (C1 + t * (C2 + t * (C3 + t * (C4 + t * (C5 + t * (C6 + t * (C7 + t * (C8 + t * (C9 + t * C10))))))))));
        }
    }

    private static void sines(int count, double[] angles, double[] factors, double[] sines) {
        for (int i = 0; i < count; i++) {
            double t = angles[i] * angles[i];
            double s = 1 + t * (S1 + t * (S2 + t * (S3 + t * (S4 + t * (S5 + t * (S6 + t * (S7 + t * (S8 + t * (S9 + t * S10)))))))));
            sines[i] = factors[i] * (angles[i] * s);
        }
    }
}
