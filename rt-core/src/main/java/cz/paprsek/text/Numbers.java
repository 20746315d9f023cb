package cz.paprsek.text;

import cz.paprsek.math.Vec3;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.OptionalDouble;

/** Numbers as text, in the shortest form that reads back as exactly the same number, and such texts as numbers. */
public final class Numbers {
    private static final double[] POWERS = {
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

    private Numbers() {}

    /** The shortest decimal that parses to the same double: {@code 2}, {@code 0.1}, {@code 1e-7}; the same on every JDK. */
    public static String text(double value) {
        if (value == Math.rint(value) && Math.abs(value) < 1e7) {
            return Long.toString((long) value);
        }
        String text = shortest(value);
        int exponent = text.indexOf('E');
        String digits = exponent < 0 ? text : text.substring(0, exponent);
        return (digits.endsWith(".0") ? digits.substring(0, digits.length() - 2) : digits)
                + (exponent < 0 ? "" : "e" + text.substring(exponent + 1));
    }

    /** Three numbers separated by blanks. */
    public static String text(Vec3 v) {
        return text(v.x()) + " " + text(v.y()) + " " + text(v.z());
    }

    /** The finite decimal number that a text is, as people write one; empty for others, also for {@code 1d}, {@code 0x1p3} and {@code NaN}, which Java takes. */
    public static OptionalDouble parsed(String text) {
        if (text.chars().allMatch(c -> (c >= '0' && c <= '9') || "+-.eE".indexOf(c) >= 0)) {
            try {
                double value = Double.parseDouble(text);
                return Double.isFinite(value) ? OptionalDouble.of(value) : OptionalDouble.empty();
            } catch (NumberFormatException none) {
                return OptionalDouble.empty();
            }
        }
        return OptionalDouble.empty();
    }

    /** Before JDK 19, {@link Double#toString(double)} sometimes gives a digit more than needed; such texts are long, and tried again. */
    private static String shortest(double value) {
        String text = Double.toString(value);
        if (text.length() < 17 || !Double.isFinite(value) || !isPerhapsTooLong(text, Math.abs(value))) {
            return text;
        }
        for (int digits = 15; digits < 17; digits++) {
            double rounded = new BigDecimal(value).round(new MathContext(digits)).doubleValue();
            String shorter = new BigDecimal(value).round(new MathContext(digits)).stripTrailingZeros().toString().replace("E+", "E");
            if (rounded == value && shorter.length() < text.length()) {
                return shorter;
            }
        }
        return text;
    }

    /** Spares nearly all numbers the long way: whether one of the two texts with a digit less means the same, or it is not easy to tell. */
    private static boolean isPerhapsTooLong(String text, double value) {
        long digits = 0;
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            digits = c >= '0' && c <= '9' ? digits * 10 + c - '0' : digits;
        }
        int decimals = text.length() - text.indexOf('.') - 2;
        long shorter = digits / 10;
        // Whole numbers up to 2^53 and powers up to 10^22 are exact, so that their quotient is the nearest to the text's meaning.
        if (text.indexOf('E') >= 0 || shorter >= 1L << 53 || decimals >= POWERS.length) {
            return true;
        }
        double power = POWERS[decimals];
        return shorter / power == value || (shorter + 1) / power == value;
    }
}
