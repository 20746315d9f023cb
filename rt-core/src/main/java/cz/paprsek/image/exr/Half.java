package cz.paprsek.image.exr;

/**
 * Numbers of 16 bits: a sign, five bits of exponent, ten of mantissa.
 *
 * @source IEEE 754-2019, binary16
 */
public final class Half {
    private static final int MAGIC = 113 << 23;
    private static final int INFINITE = 0x7C00;

    private Half() {}

    /** The nearest half, of two as near the even one; infinite beyond 65 520. */
    public static short of(float value) {
        int bits = Float.floatToRawIntBits(value);
        int sign = bits >>> 16 & 0x8000;
        int magnitude = bits & 0x7FFF_FFFF;
        if (magnitude > 0x7F80_0000) {
            return (short) (sign | INFINITE | 0x200);
        }
        if (magnitude >= 0x4780_0000) {
            return (short) (sign | INFINITE);
        }
        if (magnitude < MAGIC) {
            // Less than the smallest that has all ten bits: adding a half lets the hardware shift and round.
            float shifted = Float.intBitsToFloat(magnitude) + 0.5f;
            return (short) (sign | (Float.floatToRawIntBits(shifted) - Float.floatToRawIntBits(0.5f)));
        }
        int odd = magnitude >>> 13 & 1;
        return (short) (sign | ((magnitude - (112 << 23) + 0xFFF + odd) >>> 13));
    }

    /** The number that a half stands for, exactly. */
    public static float toFloat(short half) {
        int sign = (half & 0x8000) << 16;
        int exponent = half >>> 10 & 0x1F;
        int mantissa = half & 0x3FF;
        if (exponent == 0) {
            float tiny = mantissa * 0x1p-24f;
            return sign == 0 ? tiny : -tiny;
        }
        int shifted = exponent == 0x1F ? 0x7F80_0000 : (exponent + 112) << 23;
        return Float.intBitsToFloat(sign | shifted | mantissa << 13);
    }
}
