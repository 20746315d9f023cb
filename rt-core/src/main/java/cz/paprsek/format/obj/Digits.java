package cz.paprsek.format.obj;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/** Decimal digits, eight at a time: a word of eight bytes, of which the lowest comes first. */
final class Digits {
    /** How many are read at a time, and so how many bytes must be there from the first on. */
    static final int MOST = 8;
    private static final VarHandle WORDS = MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
    private static final long ZEROS = 0x3030303030303030L;
    private static final long SIXES = 0x0606060606060606L;
    private static final long HIGH_HALVES = 0xF0F0F0F0F0F0F0F0L;

    private Digits() {}

    /** The bytes from one on, of which those that are digits have become their values. */
    static long word(byte[] b, int at) {
        return (long) WORDS.get(b, at) ^ ZEROS;
    }

    /** How many digits a word begins with. */
    static int count(long word) {
        return Long.numberOfTrailingZeros((word | (word + SIXES)) & HIGH_HALVES) >> 3;
    }

    /** The number that the first digits of a word are, of 1 to {@value #MOST}. */
    static long value(long word, int digits) {
        // The first digit is in the lowest byte, and so the highest of what is added up in pairs, in pairs of pairs, and in halves.
        long aligned = word << (64 - (digits << 3));
        aligned = (aligned * 10 + (aligned >>> 8)) & 0x00FF00FF00FF00FFL;
        aligned = (aligned * 100 + (aligned >>> 16)) & 0x0000FFFF0000FFFFL;
        return (aligned * 10000 + (aligned >>> 32)) & 0xFFFFFFFFL;
    }
}
