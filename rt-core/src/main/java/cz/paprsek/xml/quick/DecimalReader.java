package cz.paprsek.xml.quick;

import java.math.BigInteger;
import java.nio.charset.StandardCharsets;

/**
 * Reads decimal numbers, each to the double nearest to it, as {@link Double#parseDouble} does: that takes half of the time of reading a large
 * file, and longest for just the numbers that programs write, of 16 and 17 digits.
 *
 * @source Lemire, Number Parsing at a Gigabyte per Second, Software: Practice and Experience 51(8), 2021
 */
final class DecimalReader {
    /** Of more digits, a long does not hold each. */
    private static final int MOST_DIGITS = 18;
    /** Powers of ten beyond these are rare; so are the numbers that need them. */
    private static final int MOST_POWER = 60;
    private static final double[] EXACT_POWERS = {
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

    /** The first 128 bits of 5^(i − {@link #MOST_POWER}), worked out when first needed: until then 0. */
    private final long[] high = new long[2 * MOST_POWER + 1];
    private final long[] low = new long[2 * MOST_POWER + 1];

    /**
     * The number that stands in ASCII from one place up to another; infinite if it is too large.
     *
     * @throws NumberFormatException unless it is a decimal number, as XML Schema has it, and nothing else
     */
    double read(byte[] text, int from, int to) {
        int at = from;
        boolean isNegative = text[at] == '-';
        if (isNegative || text[at] == '+') {
            at++;
        }
        long digits = 0;
        int count = 0;
        int scale = 0;
        int start = at;
        boolean hasPoint = false;
        for (; at < to; at++) {
            int digit = text[at] - '0';
            if (digit >= 0 && digit <= 9) {
                digits = digits * 10 + digit;
                count += digits == 0 ? 0 : 1;
                scale -= hasPoint ? 1 : 0;
            } else if (text[at] == '.' && !hasPoint) {
                hasPoint = true;
            } else {
                break;
            }
        }
        if (at - start == (hasPoint ? 1 : 0)) {
            throw new NumberFormatException();
        }
        if (at < to) {
            scale += exponent(text, at, to);
        }
        double value = count > MOST_DIGITS ? Double.NaN : digits == 0 ? 0 : scaled(digits, scale);
        if (Double.isNaN(value)) {
            return Double.parseDouble(new String(text, from, to - from, StandardCharsets.ISO_8859_1));
        }
        return isNegative ? -value : value;
    }

    private static int exponent(byte[] text, int from, int to) {
        int at = from + 1;
        boolean isNegative = at < to && text[at] == '-';
        if (isNegative || (at < to && text[at] == '+')) {
            at++;
        }
        int exponent = 0;
        if ((text[from] != 'e' && text[from] != 'E') || at == to) {
            throw new NumberFormatException();
        }
        for (; at < to; at++) {
            if (text[at] < '0' || text[at] > '9') {
                throw new NumberFormatException();
            }
            exponent = Math.min(exponent * 10 + text[at] - '0', 100_000);
        }
        return isNegative ? -exponent : exponent;
    }

    /** The double nearest to digits · 10^scale; NaN if it takes more to tell. */
    private double scaled(long digits, int scale) {
        if (digits >>> 53 == 0 && Math.abs(scale) < EXACT_POWERS.length) {
            // Both are exact, so that the one operation rounds correctly.
            return scale < 0 ? digits / EXACT_POWERS[-scale] : digits * EXACT_POWERS[scale];
        }
        return Math.abs(scale) > MOST_POWER ? Double.NaN : rounded(digits, scale);
    }

    /** Multiplies by the first 64 bits of a power of five, and by the next 64 if the product could round either way. */
    private double rounded(long digits, int scale) {
        int i = scale + MOST_POWER;
        if (high[i] == 0) {
            prepare(i);
        }
        int zeros = Long.numberOfLeadingZeros(digits);
        long w = digits << zeros;
        long top = multiplyHigh(w, high[i]);
        long rest = w * high[i];
        if ((top & 0x1ff) == 0x1ff) {
            long more = multiplyHigh(w, low[i]);
            rest += more;
            top += Long.compareUnsigned(rest, more) < 0 ? 1 : 0;
        }
        int upper = (int) (top >>> 63);
        long mantissa = top >>> (upper + 9);
        int exponent = ((217_706 * scale) >> 16) + 63 + upper - zeros + 1023;
        // All bits beyond the mantissa 0, or all 1: possibly a tie.
        if (rest == -1 || (Long.compareUnsigned(rest, 1) <= 0 && (mantissa & 3) == 1 && mantissa << (upper + 9) == top)
                || exponent <= 0 || exponent >= 2046) {
            return Double.NaN;
        }
        // Rounding up to the next power of two carries into the exponent, as it should.
        long rounded = (mantissa + (mantissa & 1)) >>> 1;
        return Double.longBitsToDouble(((long) exponent << 52) + rounded - (1L << 52));
    }

    /** Powers are rounded down to 128 bits, reciprocals up where the product with a whole number can be whole. */
    private void prepare(int i) {
        int power = i - MOST_POWER;
        BigInteger five = BigInteger.valueOf(5).pow(Math.abs(power));
        int length = five.bitLength();
        BigInteger bits = power >= 0 ? five.shiftLeft(128)
                : BigInteger.ONE.shiftLeft(length + (power >= -27 ? 127 : length + 128)).divide(five).add(BigInteger.ONE);
        bits = bits.shiftRight(bits.bitLength() - 128);
        low[i] = bits.longValue();
        high[i] = bits.shiftRight(64).longValue();
    }

    /** The upper 64 bits of the product of two unsigned numbers, which Java has from version 18 on. */
    private static long multiplyHigh(long a, long b) {
        return Math.multiplyHigh(a, b) + ((a >> 63) & b) + ((b >> 63) & a);
    }
}
