package cz.paprsek.format.model;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.math.BigInteger;
import java.nio.ByteOrder;

/**
 * Decimal digits, eight at a time: a word of eight bytes, of which the lowest comes first.
 *
 * @source Lemire, Number Parsing at a Gigabyte per Second, Software: Practice and Experience 51(8), 2021
 */
public final class Digits {
    /** How many are read at a time, and so how many bytes must be there from the first on. */
    public static final int MOST = 8;
    /** How many fit into a long. */
    public static final int FITTING = 18;
    private static final VarHandle WORDS = MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
    private static final long ZEROS = 0x3030303030303030L;
    private static final long SIXES = 0x0606060606060606L;
    private static final long FOURTEENS = 0x0E0E0E0E0E0E0E0EL;
    private static final long HIGH_BITS = 0x8080808080808080L;
    private static final long HIGH_HALVES = 0xF0F0F0F0F0F0F0F0L;

    private static final long EXACT = 1L << 53;
    private static final double[] POWERS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    /** Powers of ten from the least to the largest, each as two words: its first 128 bits, of which the highest is 1. */
    private static final int LEAST = -64;
    private static final int LARGEST = 64;
    private static final long[] BITS = bits();
    private static final int NINE_BITS = 0x1FF;
    private static final long[] TENS = {1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000};

    private Digits() {}

    private static long[] bits() {
        long[] bits = new long[2 * (LARGEST - LEAST + 1)];
        for (int power = LEAST; power <= LARGEST; power++) {
            BigInteger ten = BigInteger.TEN.pow(Math.abs(power));
            BigInteger shifted = power < 0 ? BigInteger.ONE.shiftLeft(128 + ten.bitLength()).divide(ten) : ten.shiftLeft(128);
            BigInteger first = shifted.shiftRight(shifted.bitLength() - 128);
            bits[2 * (power - LEAST)] = first.shiftRight(64).longValue();
            bits[2 * (power - LEAST) + 1] = first.longValue();
        }
        return bits;
    }

    /** Whether {@link #scaled} rounds once only: up to 2⁵³ digits, and powers of ten up to 22, are exact. */
    public static boolean areExact(long digits, int power) {
        return digits <= EXACT && power <= 22 && power >= -22;
    }

    /** Digits times a power of ten, from −22 to 22. */
    public static double scaled(long digits, int power) {
        return power < 0 ? digits / POWERS[-power] : digits * POWERS[power];
    }

    /** Digits, at most {@value #FITTING} of them, times a power of ten, rounded to the nearest double; NaN where that takes more digits of the power. */
    public static double rounded(long digits, int power) {
        if (areExact(digits, power)) {
            return scaled(digits, power);
        }
        if (digits == 0 || power < LEAST || power > LARGEST) {
            return digits == 0 ? 0 : Double.NaN;
        }
        int zeros = Long.numberOfLeadingZeros(digits);
        long first = digits << zeros;
        long tens = BITS[2 * (power - LEAST)];
        long high = highProduct(first, tens);
        long low = first * tens;
        if ((high & NINE_BITS) == NINE_BITS && Long.compareUnsigned(low + first, first) < 0) {
            // What the power has below its first word may reach into the bits that count.
            tens = BITS[2 * (power - LEAST) + 1];
            long sum = low + highProduct(first, tens);
            high += Long.compareUnsigned(sum, low) < 0 ? 1 : 0;
            low = sum;
            if ((high & NINE_BITS) == NINE_BITS && low == -1 && Long.compareUnsigned(first * tens + first, first) < 0) {
                return Double.NaN;
            }
        }
        int top = (int) (high >>> 63);
        long bits = high >>> (top + 9);
        if (low == 0 && (high & NINE_BITS) == 0 && (bits & 3) == 1) {
            return Double.NaN;
        }
        // The lowest bit is half of what counts. The highest adds one to the exponent, and so does what is carried.
        long exponent = ((217_706L * power) >> 16) + 1085 - zeros + top;
        return Double.longBitsToDouble((exponent << 52) + ((bits + (bits & 1)) >>> 1));
    }

    private static long highProduct(long a, long b) {
        return Math.multiplyHigh(a, b) + ((a >> 63) & b) + ((b >> 63) & a);
    }

    /** How many of the digits of a number say nothing: zeros at its beginning, before and behind the point. */
    public static int leadingZeros(byte[] b, int from, int to) {
        int zeros = 0;
        for (int at = from; at < to && (b[at] == '0' || b[at] == '.'); at++) {
            zeros += b[at] == '0' ? 1 : 0;
        }
        return zeros;
    }

    /** Whether eight bytes are none of those below 14, among which all line ends are. */
    public static boolean areWithinLine(byte[] b, int at) {
        long word = (long) WORDS.get(b, at);
        return ((word - FOURTEENS) & ~word & HIGH_BITS) == 0;
    }

    /** Where digits end that may begin here, which is at the latest at a limit. */
    public static int end(byte[] b, int from, int limit) {
        int at = from;
        while (at + MOST <= b.length && at < limit) {
            int count = count(word(b, at));
            at += count;
            if (count < MOST) {
                return Math.min(at, limit);
            }
        }
        while (at < limit && b[at] >= '0' && b[at] <= '9') {
            at++;
        }
        return Math.min(at, limit);
    }

    /** The number that digits are, behind others; too many of them run over. */
    public static long read(long before, byte[] b, int from, int to) {
        long digits = before;
        int at = from;
        for (int count = Math.min(MOST, to - at); count > 0 && at + MOST <= b.length; count = Math.min(MOST, to - at)) {
            digits = followed(digits, word(b, at), count);
            at += count;
        }
        for (; at < to; at++) {
            digits = digits * 10 + b[at] - '0';
        }
        return digits;
    }

    /** A number with the first digits of a word behind it, of 1 to {@value #MOST}. */
    public static long followed(long before, long word, int digits) {
        return before * TENS[digits] + value(word, digits);
    }

    /** The bytes from one on, of which those that are digits have become their values. */
    public static long word(byte[] b, int at) {
        return (long) WORDS.get(b, at) ^ ZEROS;
    }

    /** How many digits a word begins with. */
    public static int count(long word) {
        return Long.numberOfTrailingZeros((word | (word + SIXES)) & HIGH_HALVES) >> 3;
    }

    /** The number that the first digits of a word are, of 1 to {@value #MOST}. */
    public static long value(long word, int digits) {
        // The first digit is in the lowest byte, and so the highest of what is added up in pairs, in pairs of pairs, and in halves.
        long aligned = word << (64 - (digits << 3));
        aligned = (aligned * 10 + (aligned >>> 8)) & 0x00FF00FF00FF00FFL;
        aligned = (aligned * 100 + (aligned >>> 16)) & 0x0000FFFF0000FFFFL;
        return (aligned * 10000 + (aligned >>> 32)) & 0xFFFFFFFFL;
    }
}
