package cz.paprsek.render.sample;

import cz.paprsek.scene.RenderSettings;

/**
 * What is random in a picture: points of the unit square that are a function of pixel, sample and dimension alone. Scratch of one worker;
 * nothing is allocated once it is made.
 *
 * <p>Ask {@link #start} for a sample of a pixel, then for a dimension, then for {@link #next}, which puts the point in {@link #u} and {@link #v}:
 *
 * <pre>sampler.lights(path, lamp, 16); for (16 times) { sampler.next(); … sampler.u, sampler.v … }</pre>
 *
 * <p>Each dimension is the Sobol sequence in two dimensions, its digits scrambled by Owen's method, and so is the order of its points:
 * any 2ᵐ consecutive points that begin at a multiple of 2ᵐ lie one in each box of every grid of 2ᵐ equal boxes with sides of powers of two.
 * Pixels follow each other in the sequence along a Z curve, so that what is too much in one pixel is too little beside it: what is left of
 * errors is fine grain. Only whole numbers are computed with, so the points are the same everywhere.
 *
 * @source Burley, Practical Hash-based Owen Scrambling, JCGT 9(4), 2020; Ahmed and Wonka, Screen-Space Blue-Noise Diffusion of Monte Carlo
 *     Sampling Error via Hierarchical Ordering of Pixels, ACM TOG 39(6), 2020
 */
public final class Sampler {
    /** The path of a ray from the eye. */
    public static final int EYE = 1;

    private static final int FILTER = 0x2545_F491;
    private static final int LENS = 0x6C8E_9CF5;
    private static final int TIME = 0x1B56_C4E9;
    private static final int LIGHT = 0x4F1B_BCDC;
    private static final int FACET = 0x3A8F_05C7;
    private static final int LOBE = 0x71D6_7FFF;
    private static final int CHOICE = 0x1E3D_9AB5;
    private static final int DIRECTION = 0x5A6B_0C47;
    /** Apart from any dimension, so that scrambling digits and choosing their order have nothing to do with each other. */
    static final int ORDER = 0x632B_E5AB;
    static final int SECOND = 0x5851_F42D;
    private static final int PER_RAY = 0x2C92_77B5;
    private static final int BEYOND = 0x5F35_6495;
    private static final int SCRAMBLE = 0x45D9_F3B3;
    /** Of paths: how many sequences that have nothing to do with each other, and how many points of one are taken before those of the next. */
    private static final int SCRAMBLE_DIGITS = 3;
    private static final int RUN_DIGITS = 3;
    public static final int SCRAMBLES = 1 << SCRAMBLE_DIGITS;
    static final int RUN = 1 << RUN_DIGITS;
    private static final long UNSIGNED = 0xFFFF_FFFFL;
    private static final double ULP = 0x1p-32;

    private final boolean fixed;
    private final boolean isOfPaths;
    /** Digits of the sample's number in a pixel, or in its sequence. */
    private final int bits;
    private int column;
    private int row;
    private int pixel;
    private int sample;
    /** Tells sequences apart. */
    private int scramble;
    /** Of the dimension asked for: what scrambles digits. */
    private int key;
    /** Where the pixel comes in the sequence, counted in pixels; how the points within it are ordered; how many digits number them. */
    private int place;
    private int order;
    private int size;
    private int number;
    /** The first number beyond those of the dimension, and the digits of the number in reversed order. */
    private int end;
    private int reversed;
    private final PassPoints points;
    private final PassTurns turns;
    private final Turn turn = new Turn();
    /** Where among them the point is that is asked for. */
    private int at = PassPoints.ALONE;

    /** The point: above 0 and below 1. */
    public double u;
    public double v;
    /** The direction, of length 1. */
    public double x;
    public double y;
    public double z;

    private Sampler(int samples, boolean fixed, boolean isOfPaths) {
        this.bits = digits(samples);
        this.fixed = fixed;
        this.isOfPaths = isOfPaths;
        this.points = new PassPoints(SCRAMBLE, bits, isOfPaths ? PassPoints.MOST : 0);
        this.turns = points.turns();
    }

    /** A sampler that has other points for each pixel, of which so many samples are taken at most. */
    public static Sampler scrambled(int samples) {
        return new Sampler(samples, false, false);
    }

    /**
     * A sampler that has the same points for all pixels; of a light, also for all samples and paths, so that a few point lights in its
     * place give the same picture.
     */
    public static Sampler fixed(int samples) {
        return new Sampler(samples, true, false);
    }

    /**
     * A sampler of paths: the samples of a pixel are {@value #RUN} of one sequence, then as many of the next, of {@value #SCRAMBLES} that are scrambled independently, and round
     * again. How far the means of these are apart tells how far that of all may be from the truth. Points do not depend on how many there will be.
     *
     * @param fixed whether all pixels have the same points
     */
    static Sampler ofPaths(boolean fixed) {
        return new Sampler(RenderSettings.MOST_PATHS / SCRAMBLES, fixed, true);
    }

    /** Of which sequence a sample of paths is. */
    public static int scramble(int number) {
        return number >>> RUN_DIGITS & (SCRAMBLES - 1);
    }

    /** The path of what is mirrored at the end of a path. */
    public static int mirrored(int path) {
        return PER_RAY * path + 1;
    }

    /** The path of what goes on beyond the surface at the end of a path. */
    public static int refracted(int path) {
        return PER_RAY * path + BEYOND;
    }

    /** Begins a sample, counted from 0, of a pixel, counted in the whole picture. */
    public void start(int x, int y, int number) {
        if (x != column || y != row) {
            column = x;
            row = y;
            pixel = fixed ? 0 : spread(x) | spread(y) << 1;
        }
        again(number);
    }

    /** Begins another sample of the same pixel. */
    public void again(int number) {
        if (isOfPaths) {
            scramble = SCRAMBLE * scramble(number);
            sample = inSequence(number);
            points.turnTo(pixel, number);
        } else {
            sample = number;
        }
    }

    /** The next point is where in the pixel the ray goes through. */
    public void filter() {
        dimension(FILTER, sample, bits, 1);
    }

    /** The next point is where on the lens the ray begins. */
    public void lens() {
        dimension(LENS, sample, bits, 1);
    }

    /** The next point's u is when the ray is sent, from opening to closing of the shutter. */
    public void time() {
        dimension(TIME, sample, bits, 1);
    }

    /**
     * The next points are those of a light that are looked for from one point.
     *
     * @param path how the ray got there: {@link #EYE}, {@link #mirrored}, {@link #refracted}
     * @param lamp number of the light
     * @param count how many points there are
     */
    public void lights(int path, int lamp, int count) {
        if (fixed && !isOfPaths) {
            dimension(LIGHT + mixed(lamp), 0, 0, count);
        } else {
            dimension(LIGHT + mixed(lamp + mixed(path)), sample, bits, count);
        }
    }

    /**
     * As {@link #lights}, of one point of a path.
     *
     * @param asked what was asked there before
     */
    public void light(int path, int lamp, Asked asked) {
        if (asked.is(path, lamp, points.plans)) {
            at = points.again(asked);
            return;
        }
        lights(path, lamp, 1);
        if (at != PassPoints.ALONE) {
            points.note(LIGHT + mixed(lamp + mixed(path)), asked);
            asked.note(path, lamp, points.plans);
        }
    }

    /** The next point is which facet of a rough surface is met at the end of a path. */
    public void facet(int path) {
        dimension(FACET + mixed(path), sample, bits, 1);
    }

    /** The next point is by which of a surface's lobes a path goes on at its end, and whether it does. */
    public void choice(int path) {
        dimension(CHOICE + mixed(path), sample, bits, 1);
    }

    /** The next point is in which direction of the lobe. */
    public void direction(int path) {
        dimension(DIRECTION + mixed(path), sample, bits, 1);
    }

    /**
     * Puts the direction that the point of {@link #direction} stands for, about the z axis and as often as its cosine is large, in {@link #x} and so on.
     *
     * @param asked what was asked there before
     */
    public void strew(int path, Asked asked) {
        int which;
        if (asked.is(path, 0, points.plans)) {
            which = points.turnAgain(asked);
        } else {
            int what = DIRECTION + mixed(path);
            which = isOfPaths ? points.findTurn(what) : PassPoints.ALONE;
            if (which == PassPoints.ALONE) {
                strewAlone(what);
                return;
            }
            points.note(what, asked);
            asked.note(path, 0, points.plans);
        }
        x = turns.x[which];
        y = turns.y[which];
        z = turns.z[which];
    }

    private void strewAlone(int what) {
        size = bits;
        number = sample;
        end = sample + 1;
        at = PassPoints.ALONE;
        begin(what);
        next();
        turn.by(v);
        double sine = Math.sqrt(u);
        x = sine * turn.cosine;
        y = sine * turn.sine;
        z = Math.sqrt(1 - u);
    }

    /** The next point's u is what becomes of light there. */
    public void lobe(int path) {
        dimension(LOBE + mixed(path), sample, bits, 1);
    }

    private void dimension(int what, int first, int digits, int count) {
        at = isOfPaths && count == 1 ? points.find(what) : PassPoints.ALONE;
        if (at == PassPoints.ALONE) {
            int perSample = digits(count);
            size = digits + perSample;
            number = first << perSample;
            end = number + count;
            begin(what);
        }
    }

    private void begin(int what) {
        reversed = Integer.reverse(number);
        sequence(what + scramble);
    }

    /** Which number of its sequence a sample of paths has. */
    static int inSequence(int number) {
        return number >>> (RUN_DIGITS + SCRAMBLE_DIGITS) << RUN_DIGITS | (number & (RUN - 1));
    }

    private void sequence(int dimension) {
        place = scrambled(pixel, mixed(dimension ^ ORDER));
        order = mixed(place ^ mixed(dimension));
        // Of a picture so large that its pixels have no more room in the sequence, parts far from each other get other digits.
        key = mixed(dimension + (int) ((place & UNSIGNED) >>> (Integer.SIZE - size)));
    }

    /** Puts the next point of the dimension in {@link #u} and {@link #v}. */
    public void next() {
        if (at != PassPoints.ALONE) {
            u = unit(points.u(at));
            v = unit(points.v(at));
            return;
        }
        int within = (1 << size) - 1;
        int index = place << size | (Integer.reverse(permuted(reversed, order)) & within);
        if (++number < end) {
            reversed = Integer.reverse(number);
        }
        // Both coordinates at once: what takes longest is to reverse digits.
        long both = Long.reverse((long) permuted(second(index), key ^ SECOND) << Integer.SIZE | (permuted(index, key) & UNSIGNED));
        u = unit(both >>> Integer.SIZE);
        v = unit(both & UNSIGNED);
    }

    /** How many binary digits it takes to count so many. */
    private static int digits(int count) {
        return Integer.SIZE - Integer.numberOfLeadingZeros(count - 1);
    }

    /** A fraction whose first 32 binary digits are given: the middle of the interval of all that begin so. */
    private static double unit(long digits) {
        return (digits + 0.5) * ULP;
    }

    /** The same of digits that are not known to be below 2³¹. */
    static double unit(int digits) {
        return unit(digits & UNSIGNED);
    }

    /** Of a number of the Sobol sequence, its second coordinate, in reversed order, as the number itself is its first: Pascal's triangle, modulo 2. */
    static int second(int index) {
        int x = index;
        x ^= x >>> 1 & 0x5555_5555;
        x ^= x >>> 2 & 0x3333_3333;
        x ^= x >>> 4 & 0x0F0F_0F0F;
        x ^= x >>> 8 & 0x00FF_00FF;
        return x ^ x >>> 16;
    }

    /** Exchanges halves, in each half its halves, and so on: which, depends on the seed. */
    private static int scrambled(int x, int seed) {
        return Integer.reverse(permuted(Integer.reverse(x), seed));
    }

    /**
     * Changes each binary digit depending on lower ones only.
     *
     * @source Laine and Karras, Stratified Sampling for Stochastic Transparency, EGSR 2011; the constants from Vegdahl, Building a Better
     *     LK Hash, 2021
     */
    static int permuted(int x, int seed) {
        int y = x;
        y ^= y * 0x3D20_ADEA;
        y += seed;
        y *= seed >>> 16 | 1;
        y ^= y * 0x0552_6C56;
        return y ^ y * 0x53A2_2864;
    }

    /** @source Wellons, Prospecting for Hash Functions, 2018 */
    static int mixed(int x) {
        int y = x;
        y = (y ^ y >>> 16) * 0x7FEB_352D;
        y = (y ^ y >>> 15) * 0x846C_A68B;
        return y ^ y >>> 16;
    }

    /** Puts a 0 before each of the lower 16 binary digits. */
    private static int spread(int x) {
        int y = x & 0xFFFF;
        y = (y | y << 8) & 0x00FF_00FF;
        y = (y | y << 4) & 0x0F0F_0F0F;
        y = (y | y << 2) & 0x3333_3333;
        return (y | y << 1) & 0x5555_5555;
    }
}
