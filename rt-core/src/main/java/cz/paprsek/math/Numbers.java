package cz.paprsek.math;

import java.math.BigDecimal;
import java.math.MathContext;

/** Numbers as text: the shortest form that reads back as exactly the same number. */
public final class Numbers {
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

    /** Before JDK 19, {@link Double#toString(double)} sometimes gives a digit more than needed; such texts are long, and tried again. */
    private static String shortest(double value) {
        String text = Double.toString(value);
        if (text.length() < 17 || !Double.isFinite(value)) {
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
}
