package cz.paprsek.render.sample;

/**
 * The samples of paths, any number of them: summed pass by pass, and each of the sequences they are taken from by itself. After each whole pass, and so the sums
 * of a picture's pixels can be kept between two passes without any difference, the sums are rounded to what {@link #save} keeps of them.
 */
public final class PassSums extends PixelSums {
    /** How many samples are summed before their sum is added to the others'. */
    public static final int PASS = 64;
    /** If so many paths meet something but bring no light, there is none. */
    private static final int FEWEST_OF_BLACK = 512;
    /** In place of the brightest, of black pixels where nothing is met. */
    private static final double NOTHING = -1;
    private static final int CHANNELS = 3;

    private final boolean isSigned;
    private final boolean isJudged;
    private final Target target;
    private final Sum pass = new Sum();
    private final Sum all = new Sum();
    private final Sum now = new Sum();
    private final Sum[] scrambles = new Sum[Sampler.SCRAMBLES];
    private int count;
    private double brightestRed;
    private double brightestGreen;
    private double brightestBlue;

    /**
     * No samples yet.
     *
     * @param isSigned whether the filter takes away somewhere
     * @param isJudged whether what each sequence brings is to be known
     */
    PassSums(double mass, boolean isSigned, boolean isJudged, Target target) {
        super(mass);
        this.isSigned = isSigned;
        this.isJudged = isJudged;
        this.target = target;
        for (int i = 0; i < scrambles.length; i++) {
            scrambles[i] = new Sum();
        }
    }

    @Override
    public void clear() {
        count = 0;
        meets = false;
        pass.clear();
        all.clear();
        brightestRed = 0;
        brightestGreen = 0;
        brightestBlue = 0;
        if (isJudged) {
            for (Sum one : scrambles) {
                one.clear();
            }
        }
    }

    @Override
    public void add(double r, double g, double b, boolean isNegative) {
        pass.add(r, g, b, isNegative);
        if (isJudged) {
            scrambles[Sampler.scramble(count)].add(r, g, b, isNegative);
            brightestRed = Math.max(brightestRed, r);
            brightestGreen = Math.max(brightestGreen, g);
            brightestBlue = Math.max(brightestBlue, b);
        }
        if (++count % PASS == 0) {
            end();
        }
    }

    /** Adds the pass to the others. */
    private void end() {
        addToAll(pass);
        pass.clear();
        if (isJudged) {
            for (Sum one : scrambles) {
                one.addR = single(one.addR);
                one.addG = single(one.addG);
                one.addB = single(one.addB);
                one.takeR = single(one.takeR);
                one.takeG = single(one.takeG);
                one.takeB = single(one.takeB);
            }
            brightestRed = single(!meets && brightestRed == 0 && brightestGreen == 0 && brightestBlue == 0 ? NOTHING : brightestRed);
            brightestGreen = single(brightestGreen);
            brightestBlue = single(brightestBlue);
        }
        meets = false;
    }

    /** As one machine and several do: a pass by itself is rounded to what is kept of it, and so is the sum. */
    private void addToAll(Sum other) {
        all.below += other.below;
        all.addR = pair(all.addR + pair(other.addR));
        all.addG = pair(all.addG + pair(other.addG));
        all.addB = pair(all.addB + pair(other.addB));
        if (isSigned) {
            all.takeR = pair(all.takeR + pair(other.takeR));
            all.takeG = pair(all.takeG + pair(other.takeG));
            all.takeB = pair(all.takeB + pair(other.takeB));
        }
    }

    /** Adds a pass that was made by itself, the one that comes after those that are there; of sums that are not judged. */
    public void join(PassSums next) {
        addToAll(next.all);
        count = next.count;
    }

    /** The nearest float. */
    private static double single(double x) {
        return (float) x;
    }

    /** The nearest number that is the sum of two floats. */
    private static double pair(double x) {
        return (double) (float) x + low(x);
    }

    /** What a float lacks to a number; nothing if that is too large for one. */
    private static float low(double x) {
        return Float.isFinite((float) x) ? (float) (x - (float) x) : 0;
    }

    /** Whether there are whole passes only. */
    public boolean areWhole() {
        return count % PASS == 0;
    }

    @Override
    public int count() {
        return count;
    }

    @Override
    public void mean() {
        now.below = all.below + pass.below;
        now.addR = all.addR + pass.addR;
        now.addG = all.addG + pass.addG;
        now.addB = all.addB + pass.addB;
        now.takeR = all.takeR + pass.takeR;
        now.takeG = all.takeG + pass.takeG;
        now.takeB = all.takeB + pass.takeB;
        mean(now, count);
    }

    /** Finds what one of the sequences that whole passes are taken from brings: red, green and blue. Of judged samples only. */
    public void sequence(int number) {
        mean(scrambles[number], count / scrambles.length);
    }

    @Override
    boolean areNear() {
        return target.isMet(halfWidth()) && isTrusted();
    }

    @Override
    public double interval() {
        if (count < PASS) {
            return Target.UNKNOWN;
        }
        double half = halfWidth();
        return isTrusted() ? half : half > 0 ? -half : Target.UNKNOWN;
    }

    /** What many paths have not found is thought not to be there. */
    private boolean isTrusted() {
        boolean isBlack = brightestRed == 0 && brightestGreen == 0 && brightestBlue == 0;
        return isBlack ? count >= FEWEST_OF_BLACK : target.isTrusted(brightestRed / count, brightestGreen / count, brightestBlue / count);
    }

    private double halfWidth() {
        tellGroups();
        // The groups may happen to agree: what is as bright as the brightest, but so rare that it may well not have been met, is always thought possible.
        double k = target.unmet() / count;
        return target.halfWidth(k * brightestRed, k * brightestGreen, k * brightestBlue);
    }

    private void tellGroups() {
        for (int i = 0; i < scrambles.length; i++) {
            sequence(i);
            target.group(i, this);
        }
    }

    /** How many numbers {@link #save} keeps. */
    static int size(boolean isSigned, boolean isJudged) {
        int one = isSigned ? 1 + 2 * CHANNELS : CHANNELS;
        return 1 + one + (isSigned ? 2 : 1) * CHANNELS + (isJudged ? CHANNELS + Sampler.SCRAMBLES * one : 0);
    }

    /** Keeps the sums of whole passes, from a place on; where what follows them begins. */
    public int save(float[] numbers, int from) {
        numbers[from] = count;
        int at = save(all, numbers, from + 1);
        numbers[at++] = low(all.addR);
        numbers[at++] = low(all.addG);
        numbers[at++] = low(all.addB);
        if (isSigned) {
            numbers[at++] = low(all.takeR);
            numbers[at++] = low(all.takeG);
            numbers[at++] = low(all.takeB);
        }
        if (isJudged) {
            numbers[at++] = (float) brightestRed;
            numbers[at++] = (float) brightestGreen;
            numbers[at++] = (float) brightestBlue;
            for (Sum one : scrambles) {
                at = save(one, numbers, at);
            }
        }
        return at;
    }

    /** Goes on with sums that were kept, from a place on; with none if there is nothing but zeros. Where what follows them begins. */
    public int load(float[] numbers, int from) {
        count = (int) numbers[from];
        meets = false;
        pass.clear();
        int at = load(all, numbers, from + 1);
        all.addR += numbers[at++];
        all.addG += numbers[at++];
        all.addB += numbers[at++];
        if (isSigned) {
            all.takeR += numbers[at++];
            all.takeG += numbers[at++];
            all.takeB += numbers[at++];
        }
        if (isJudged) {
            brightestRed = numbers[at++];
            brightestGreen = numbers[at++];
            brightestBlue = numbers[at++];
            for (Sum one : scrambles) {
                at = load(one, numbers, at);
            }
        }
        return at;
    }

    private int save(Sum sum, float[] numbers, int from) {
        int at = from;
        numbers[at++] = (float) sum.addR;
        numbers[at++] = (float) sum.addG;
        numbers[at++] = (float) sum.addB;
        if (isSigned) {
            numbers[at++] = sum.below;
            numbers[at++] = (float) sum.takeR;
            numbers[at++] = (float) sum.takeG;
            numbers[at++] = (float) sum.takeB;
        }
        return at;
    }

    private int load(Sum sum, float[] numbers, int from) {
        int at = from;
        sum.clear();
        sum.addR = numbers[at++];
        sum.addG = numbers[at++];
        sum.addB = numbers[at++];
        if (isSigned) {
            sum.below = (int) numbers[at++];
            sum.takeR = numbers[at++];
            sum.takeG = numbers[at++];
            sum.takeB = numbers[at++];
        }
        return at;
    }
}
