package cz.paprsek.format.model;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/** Decimal digits, eight at a time: a word of eight bytes, of which the lowest comes first. */
public final class Digits {
    /** How many are read at a time, and so how many bytes must be there from the first on. */
    public static final int MOST = 8;
    private static final VarHandle WORDS = MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
    private static final long ZEROS = 0x3030303030303030L;
    private static final long SIXES = 0x0606060606060606L;
    private static final long FOURTEENS = 0x0E0E0E0E0E0E0E0EL;
    private static final long HIGH_BITS = 0x8080808080808080L;
    private static final long HIGH_HALVES = 0xF0F0F0F0F0F0F0F0L;

    private static final long EXACT = 1L << 53;
    private static final double[] POWERS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    private static final long[] TENS = {1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000};

    private Digits() {}

    /**
     * Whether {@link #scaled} rounds once only: eighteen digits fit into a long; up to 2⁵³ they, and powers of ten up to 22, are exact.
     *
     * @param count how many digits have been read
     */
    public static boolean areExact(int count, long digits, int power) {
        return count <= 18 && digits <= EXACT && power <= 22 && power >= -22;
    }

    /** Digits times a power of ten, from −22 to 22. */
    public static double scaled(long digits, int power) {
        return power < 0 ? digits / POWERS[-power] : digits * POWERS[power];
    }

    /** Whether eight bytes are none of those below 14, among which all line ends are. */
    public static boolean areWithinLine(byte[] b, int at) {
        long word = (long) WORDS.get(b, at);
        return ((word - FOURTEENS) & ~word & HIGH_BITS) == 0;
    }

    /** Where digits end that may begin here, which is at the latest at a limit. */
    public static int end(byte[] b, int from, int limit) {
        int at = from;
        if (from + MOST <= b.length) {
            at += count(word(b, from));
            if (at < from + MOST) {
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
        if (to - from <= MOST && from + MOST <= b.length) {
            return to == from ? before : followed(before, word(b, from), to - from);
        }
        long digits = before;
        for (int at = from; at < to; at++) {
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
