package cz.paprsek.shape.field;

import cz.paprsek.formula.Function;

/**
 * Functions of intervals, and how fast they change along a line: of numbers that lie anywhere from {@code low} to {@code high}, and grow with t anywhere
 * from {@code slowest} to {@code fastest}, what comes out does the same. Rounding is allowed for, always outwards. What may be no number, or may jump, is
 * anything at all.
 *
 * <p>Four numbers each, in an array; nothing is allocated.
 *
 * @source Moore, Kearfott, Cloud, Introduction to Interval Analysis, SIAM 2009; Mitchell, Robust Ray Intersection with Interval Arithmetic, Graphics
 *     Interface 1990
 */
final class Enclosed {
    static final int SIZE = 4;
    static final int LOW = 0;
    static final int HIGH = 1;
    static final int SLOWEST = 2;
    static final int FASTEST = 3;
    private static final double INF = Double.POSITIVE_INFINITY;
    static final double DEGREE = Math.PI / 180;

    private Enclosed() {}

    static void set(double[] r, int out, double low, double high, double slowest, double fastest) {
        boolean isNumber = low <= high && slowest <= fastest;
        r[out + LOW] = isNumber ? low : -INF;
        r[out + HIGH] = isNumber ? high : INF;
        r[out + SLOWEST] = isNumber ? slowest : -INF;
        r[out + FASTEST] = isNumber ? fastest : INF;
    }

    private static void anything(double[] r, int out) {
        set(r, out, -INF, INF, -INF, INF);
    }

    /** What is nowhere a number, as the root of numbers that are all below 0; nor is what is made of it. */
    private static void nowhere(double[] r, int out) {
        r[out + LOW] = Double.NaN;
        r[out + HIGH] = Double.NaN;
        r[out + SLOWEST] = Double.NaN;
        r[out + FASTEST] = Double.NaN;
    }

    /** Where not even one operand is a number: true if the outcome is known by that. */
    private static boolean isNowhere(Function function, double[] r, int a, int b, int out) {
        if (!Double.isNaN(r[a + LOW]) && !Double.isNaN(r[b + LOW])) {
            return false;
        }
        switch (function) {
            case LESS, AT_MOST, GREATER, AT_LEAST, EQUAL, UNEQUAL -> {
                return false;
            }
            case AND, OR, NOT -> steps(r, out, 0, 1);
            case IF, POWER, HYPOT, RAND -> anything(r, out);
            default -> nowhere(r, out);
        }
        return true;
    }

    /** What does not change between jumps: its bounds, and whether it jumps. */
    private static void steps(double[] r, int out, double low, double high) {
        boolean jumps = low != high;
        set(r, out, low, high, jumps ? -INF : 0, jumps ? INF : 0);
    }

    private static double down(double x) {
        return Math.nextDown(x);
    }

    private static double up(double x) {
        return Math.nextUp(x);
    }

    /** What StrictMath may be wrong by, and one more. */
    static double lower(double x) {
        return down(down(x));
    }

    static double upper(double x) {
        return up(up(x));
    }

    /** The least of the products of two intervals; 0 times infinity, which the processor has no number for, is 0 here, for infinity stands for large numbers. */
    static double least(double a, double b, double c, double d) {
        double least = Math.min(Math.min(a * c, a * d), Math.min(b * c, b * d));
        return down(Double.isNaN(least) ? Math.min(Math.min(product(a, c), product(a, d)), Math.min(product(b, c), product(b, d))) : least);
    }

    static double most(double a, double b, double c, double d) {
        double most = Math.max(Math.max(a * c, a * d), Math.max(b * c, b * d));
        return up(Double.isNaN(most) ? Math.max(Math.max(product(a, c), product(a, d)), Math.max(product(b, c), product(b, d))) : most);
    }

    private static double product(double a, double b) {
        return a == 0 || b == 0 ? 0 : a * b;
    }

    /** Puts the outcome of a function of up to three others at a place of its own. */
    static void apply(Function function, double[] r, int a, int b, int c, int out) {
        double al = r[a + LOW];
        double ah = r[a + HIGH];
        double bl = r[b + LOW];
        double bh = r[b + HIGH];
        if (isNowhere(function, r, a, b, out)) {
            return;
        }
        switch (function) {
            case NEGATE -> set(r, out, -ah, -al, -r[a + FASTEST], -r[a + SLOWEST]);
            case PLUS -> set(r, out, down(al + bl), up(ah + bh), down(r[a + SLOWEST] + r[b + SLOWEST]), up(r[a + FASTEST] + r[b + FASTEST]));
            case MINUS -> set(r, out, down(al - bh), up(ah - bl), down(r[a + SLOWEST] - r[b + FASTEST]), up(r[a + FASTEST] - r[b + SLOWEST]));
            case TIMES -> {
                if (a == b) {
                    square(r, a, out);
                } else {
                    times(r, a, b, out);
                }
            }
            case DIVIDE -> divide(r, a, b, out);
            case POWER -> power(r, a, b, out);
            case LESS -> steps(r, out, ah < bl ? 1 : 0, al < bh ? 1 : 0);
            case AT_MOST -> steps(r, out, ah <= bl ? 1 : 0, al <= bh ? 1 : 0);
            case GREATER -> steps(r, out, al > bh ? 1 : 0, ah > bl ? 1 : 0);
            case AT_LEAST -> steps(r, out, al >= bh ? 1 : 0, ah >= bl ? 1 : 0);
            case EQUAL -> steps(r, out, al == bh && ah == bl ? 1 : 0, al <= bh && bl <= ah ? 1 : 0);
            case UNEQUAL -> steps(r, out, al > bh || bl > ah ? 1 : 0, al == bh && ah == bl ? 0 : 1);
            case AND -> steps(r, out, isTrue(al, ah) && isTrue(bl, bh) ? 1 : 0, isFalse(al, ah) || isFalse(bl, bh) ? 0 : 1);
            case OR -> steps(r, out, isTrue(al, ah) || isTrue(bl, bh) ? 1 : 0, isFalse(al, ah) && isFalse(bl, bh) ? 0 : 1);
            case NOT -> steps(r, out, isFalse(al, ah) ? 1 : 0, isTrue(al, ah) ? 0 : 1);
            case IF -> choice(r, isTrue(al, ah), isFalse(al, ah), b, c, out);
            case SIN -> Wave.of(r, a, 0, out);
            case COS -> Wave.of(r, a, 90, out);
            case TAN -> tangent(r, a, out);
            case ASIN, ACOS -> arc(function, r, a, out);
            case ATAN -> rising(r, a, out, StrictMath.atan(al) / DEGREE, StrictMath.atan(ah) / DEGREE, 1 / DEGREE / (1 + largest(al, ah) * largest(al, ah)), 1 / DEGREE / (1 + smallest(al, ah) * smallest(al, ah)));
            case SQRT -> rising(r, a, out, Math.sqrt(al), Math.sqrt(ah), 0.5 / Math.sqrt(ah), 0.5 / Math.sqrt(al));
            case CBRT -> rising(r, a, out, StrictMath.cbrt(al), StrictMath.cbrt(ah), third(largest(al, ah)), third(smallest(al, ah)));
            case EXP -> rising(r, a, out, StrictMath.exp(al), StrictMath.exp(ah), StrictMath.exp(al), StrictMath.exp(ah));
            case LN -> rising(r, a, out, StrictMath.log(al), StrictMath.log(ah), 1 / ah, al > 0 ? 1 / al : Double.NaN);
            case LOG10 -> rising(r, a, out, StrictMath.log10(al), StrictMath.log10(ah), 0.43429448190325176 / ah, al > 0 ? 0.4342944819032519 / al : Double.NaN);
            case ABS -> larger(r, a, al, ah, -ah, -al, -r[a + FASTEST], -r[a + SLOWEST], out);
            case MAX -> larger(r, a, al, ah, bl, bh, r[b + SLOWEST], r[b + FASTEST], out);
            case MIN -> smaller(r, a, b, out);
            case SIGN -> steps(r, out, Math.signum(al), Math.signum(ah));
            case FLOOR -> steps(r, out, Math.floor(al), Math.floor(ah));
            case CEIL -> steps(r, out, Math.ceil(al), Math.ceil(ah));
            case ROUND -> steps(r, out, Math.floor(al + 0.5), Math.floor(ah + 0.5));
            case RAND -> {
                boolean isOne = al == ah && bl == bh;
                steps(r, out, isOne ? function.of(al, bl, 0) : 0, isOne ? function.of(al, bl, 0) : 1);
            }
            case MOD, REMAINDER -> rest(function, r, a, b, out);
            case HYPOT -> hypot(r, a, b, out);
            case ATAN2 -> angle(r, a, b, out);
            case CLAMP, MIX -> throw new IllegalStateException(function + " is written in other words");
        }
    }

    /** The angle of (b, a), which grows by (b·a′ − a·b′)/(a² + b²); where it may jump, or has none, it is anything from −180 to 180. */
    private static void angle(double[] r, int a, int b, int out) {
        double al = r[a + LOW];
        double ah = r[a + HIGH];
        double bl = r[b + LOW];
        double bh = r[b + HIGH];
        if (!(bl > 0 || al > 0 || ah < 0)) {
            set(r, out, -180, 180, -INF, INF);
            return;
        }
        double one = Function.ATAN2.of(al, bl, 0);
        double two = Function.ATAN2.of(al, bh, 0);
        double three = Function.ATAN2.of(ah, bl, 0);
        double four = Function.ATAN2.of(ah, bh, 0);
        double near = smallest(al, ah) * smallest(al, ah) + smallest(bl, bh) * smallest(bl, bh);
        double slow = least(bl, bh, r[a + SLOWEST], r[a + FASTEST]) - most(al, ah, r[b + SLOWEST], r[b + FASTEST]);
        double fast = most(bl, bh, r[a + SLOWEST], r[a + FASTEST]) - least(al, ah, r[b + SLOWEST], r[b + FASTEST]);
        double far = largest(al, ah) * largest(al, ah) + largest(bl, bh) * largest(bl, bh);
        double low = lower(1 / DEGREE / far);
        double high = upper(upper(1 / DEGREE / near));
        set(r, out, lower(lower(Math.min(Math.min(one, two), Math.min(three, four)))), upper(upper(Math.max(Math.max(one, two), Math.max(three, four)))),
                least(slow, fast, low, high), most(slow, fast, low, high));
    }

    private static boolean isTrue(double low, double high) {
        return low > 0 || high < 0;
    }

    private static boolean isFalse(double low, double high) {
        return low == 0 && high == 0;
    }

    private static double smallest(double low, double high) {
        return low > 0 ? low : high < 0 ? -high : 0;
    }

    static double largest(double low, double high) {
        return Math.max(Math.abs(low), Math.abs(high));
    }

    private static double third(double x) {
        double root = StrictMath.cbrt(x);
        return 1 / (3 * root * root);
    }

    private static void times(double[] r, int a, int b, int out) {
        double al = r[a + LOW];
        double ah = r[a + HIGH];
        double bl = r[b + LOW];
        double bh = r[b + HIGH];
        double slowest = down(least(al, ah, r[b + SLOWEST], r[b + FASTEST]) + least(bl, bh, r[a + SLOWEST], r[a + FASTEST]));
        double fastest = up(most(al, ah, r[b + SLOWEST], r[b + FASTEST]) + most(bl, bh, r[a + SLOWEST], r[a + FASTEST]));
        set(r, out, least(al, ah, bl, bh), most(al, ah, bl, bh), slowest, fastest);
    }

    private static void square(double[] r, int a, int out) {
        double al = r[a + LOW];
        double ah = r[a + HIGH];
        double small = smallest(al, ah);
        double large = largest(al, ah);
        double slowest = 2 * least(al, ah, r[a + SLOWEST], r[a + FASTEST]);
        set(r, out, Math.max(0, down(small * small)), up(large * large), slowest, 2 * most(al, ah, r[a + SLOWEST], r[a + FASTEST]));
    }

    private static void divide(double[] r, int a, int b, int out) {
        double bl = r[b + LOW];
        double bh = r[b + HIGH];
        if (!(bl > 0 || bh < 0)) {
            anything(r, out);
            return;
        }
        double al = r[a + LOW];
        double ah = r[a + HIGH];
        double low = down(1 / bh);
        double high = up(1 / bl);
        double quotientLow = least(al, ah, low, high);
        double quotientHigh = most(al, ah, low, high);
        // (a′ − (a/b)·b′)/b
        double slow = down(r[a + SLOWEST] - most(quotientLow, quotientHigh, r[b + SLOWEST], r[b + FASTEST]));
        double fast = up(r[a + FASTEST] - least(quotientLow, quotientHigh, r[b + SLOWEST], r[b + FASTEST]));
        set(r, out, quotientLow, quotientHigh, least(slow, fast, low, high), most(slow, fast, low, high));
    }

    /** Whole exponents of any number, others of positive ones. */
    private static void power(double[] r, int a, int b, int out) {
        double n = r[b + LOW];
        double al = r[a + LOW];
        double ah = r[a + HIGH];
        boolean isWhole = n == Math.rint(n) && Math.abs(n) < 1e6;
        if (n == r[b + HIGH] && !isWhole && ah < 0 && n != Math.rint(n)) {
            nowhere(r, out);
            return;
        }
        if (n != r[b + HIGH] || !(al > 0 || (isWhole && (n >= 0 || ah < 0)))) {
            anything(r, out);
            return;
        }
        if (n == 2) {
            square(r, a, out);
            return;
        }
        double slopeLow = n * powered(al, ah, n - 1, isWhole, n < 0);
        double slopeHigh = n * powered(al, ah, n - 1, isWhole, n >= 0);
        double low = n == 0 ? 0 : lower(lower(slopeLow));
        double high = n == 0 ? 0 : upper(upper(slopeHigh));
        set(r, out, lower(powered(al, ah, n, isWhole, false)), upper(powered(al, ah, n, isWhole, true)),
                least(low, high, r[a + SLOWEST], r[a + FASTEST]), most(low, high, r[a + SLOWEST], r[a + FASTEST]));
    }

    /** The largest power, or the smallest, of the numbers of an interval. */
    private static double powered(double low, double high, double n, boolean isWhole, boolean isLargest) {
        boolean isEven = isWhole && n % 2 == 0;
        double from = isEven ? smallest(low, high) : low;
        double to = isEven ? largest(low, high) : high;
        double one = StrictMath.pow(from, n);
        double other = StrictMath.pow(to, n);
        return isLargest ? Math.max(one, other) : Math.min(one, other);
    }

    private static void choice(double[] r, boolean isTrue, boolean isFalse, int b, int c, int out) {
        if (isTrue || isFalse) {
            System.arraycopy(r, isTrue ? b : c, r, out, SIZE);
        } else {
            set(r, out, Math.min(r[b + LOW], r[c + LOW]), Math.max(r[b + HIGH], r[c + HIGH]), -INF, INF);
        }
    }

    private static void tangent(double[] r, int a, int out) {
        double al = r[a + LOW];
        double ah = r[a + HIGH];
        double slack = 1e-9 * (1 + largest(al, ah));
        if (!(ah - al < 180) || Math.floor((al - 90 - slack) / 180) != Math.floor((ah - 90 + slack) / 180)) {
            anything(r, out);
            return;
        }
        double low = Function.TAN.of(al, 0, 0);
        double high = Function.TAN.of(ah, 0, 0);
        double small = smallest(low, high);
        double large = largest(low, high);
        double error = 1e-13 * (1 + large * large) * (1 + largest(al, ah));
        rising(r, a, out, low - error, high + error, DEGREE * (1 + small * small) - error, DEGREE * (1 + large * large) + error);
    }

    private static void arc(Function function, double[] r, int a, int out) {
        double al = r[a + LOW];
        double ah = r[a + HIGH];
        double fast = 1 / DEGREE / Math.sqrt(1 - largest(al, ah) * largest(al, ah));
        double slow = 1 / DEGREE / Math.sqrt(1 - smallest(al, ah) * smallest(al, ah));
        if (function == Function.ASIN) {
            rising(r, a, out, function.of(al, 0, 0), function.of(ah, 0, 0), slow, fast);
            return;
        }
        rising(r, a, out, -function.of(al, 0, 0), -function.of(ah, 0, 0), slow, fast);
        set(r, out, -r[out + HIGH], -r[out + LOW], -r[out + FASTEST], -r[out + SLOWEST]);
    }

    /** A function that grows, by its values at both ends and the bounds of how fast it does; no numbers for what is nowhere there. */
    private static void rising(double[] r, int a, int out, double low, double high, double slow, double fast) {
        if (Double.isNaN(high)) {
            nowhere(r, out);
            return;
        }
        if (Double.isNaN(low) || Double.isNaN(slow) || Double.isNaN(fast)) {
            anything(r, out);
            return;
        }
        double least = lower(lower(low));
        double most = upper(upper(high));
        double slower = lower(lower(slow));
        double faster = upper(upper(fast));
        set(r, out, least, most, least(slower, faster, r[a + SLOWEST], r[a + FASTEST]), most(slower, faster, r[a + SLOWEST], r[a + FASTEST]));
    }

    private static void larger(double[] r, int a, double al, double ah, double bl, double bh, double slowest, double fastest, int out) {
        double slow = al > bh ? r[a + SLOWEST] : bl > ah ? slowest : Math.min(r[a + SLOWEST], slowest);
        double fast = al > bh ? r[a + FASTEST] : bl > ah ? fastest : Math.max(r[a + FASTEST], fastest);
        set(r, out, Math.max(al, bl), Math.max(ah, bh), slow, fast);
    }

    private static void smaller(double[] r, int a, int b, int out) {
        double al = r[a + LOW];
        double ah = r[a + HIGH];
        double bl = r[b + LOW];
        double bh = r[b + HIGH];
        double slow = ah < bl ? r[a + SLOWEST] : bh < al ? r[b + SLOWEST] : Math.min(r[a + SLOWEST], r[b + SLOWEST]);
        double fast = ah < bl ? r[a + FASTEST] : bh < al ? r[b + FASTEST] : Math.max(r[a + FASTEST], r[b + FASTEST]);
        set(r, out, Math.min(al, bl), Math.min(ah, bh), slow, fast);
    }

    /** Of a divisor that stays the same, a − b times the number of whole steps, as long as that stays the same. */
    private static void rest(Function function, double[] r, int a, int b, int out) {
        double divisor = r[b + LOW];
        double al = r[a + LOW];
        double ah = r[a + HIGH];
        double size = Math.abs(divisor);
        double slack = 1e-15 * largest(al, ah);
        if (divisor == r[b + HIGH] && divisor != 0 && Math.floor((al - slack) / size) == Math.floor((ah + slack) / size)) {
            double low = function.of(al, divisor, 0);
            double high = function.of(ah, divisor, 0);
            set(r, out, down(Math.min(low, high)), up(Math.max(low, high)), r[a + SLOWEST], r[a + FASTEST]);
            return;
        }
        double most = largest(r[b + LOW], r[b + HIGH]);
        set(r, out, -most, most, -INF, INF);
    }

    /** √(a² + b²), which grows by (a·a′ + b·b′) divided by itself. */
    private static void hypot(double[] r, int a, int b, int out) {
        double al = r[a + LOW];
        double ah = r[a + HIGH];
        double bl = r[b + LOW];
        double bh = r[b + HIGH];
        double low = Math.max(0, lower(StrictMath.hypot(smallest(al, ah), smallest(bl, bh))));
        double high = upper(StrictMath.hypot(largest(al, ah), largest(bl, bh)));
        double slow = down(least(al, ah, r[a + SLOWEST], r[a + FASTEST]) + least(bl, bh, r[b + SLOWEST], r[b + FASTEST]));
        double fast = up(most(al, ah, r[a + SLOWEST], r[a + FASTEST]) + most(bl, bh, r[b + SLOWEST], r[b + FASTEST]));
        double reach = Math.max(Math.abs(r[a + SLOWEST]), Math.abs(r[a + FASTEST])) + Math.max(Math.abs(r[b + SLOWEST]), Math.abs(r[b + FASTEST]));
        // Nowhere does it change faster than both of them together.
        set(r, out, low, high, low > 0 ? Math.max(-reach, least(slow, fast, down(1 / high), up(1 / low))) : -reach,
                low > 0 ? Math.min(reach, most(slow, fast, down(1 / high), up(1 / low))) : reach);
    }
}
