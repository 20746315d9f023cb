package cz.paprsek.render.explain.text;

import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.text.Numbers;
import cz.paprsek.words.Words;
import java.math.BigDecimal;
import java.math.MathContext;

/** Numbers as a teacher writes them on the board: four digits, three in vectors and colours, a true minus, powers of ten for the very large and small. */
final class Figures {
    private static final MathContext DIGITS = new MathContext(4);
    private static final MathContext COMPONENT = new MathContext(3);
    private static final String SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

    private Figures() {}

    static String of(double value) {
        return of(value, DIGITS);
    }

    static String of(Vec3 v) {
        return triple(v.x(), v.y(), v.z());
    }

    static String of(LinearRgb light) {
        return triple(light.red(), light.green(), light.blue());
    }

    /** How light is shown: exposed and toned if it is, and in sRGB. */
    static String shown(LinearRgb light, double exposure, Tone tone, Words words) {
        boolean isDeveloped = exposure != 0 || tone != Tone.NONE;
        return (isDeveloped ? words.of("developed", Numbers.text(exposure), words.of("kind." + tone), of(light)) : "")
                + words.of("srgb", srgb(light.shown().red()) + " " + srgb(light.shown().green()) + " " + srgb(light.shown().blue()));
    }

    private static String srgb(double channel) {
        return Numbers.text(Math.rint(channel));
    }

    /** One number if it is the same in all channels. */
    static String share(LinearRgb share) {
        return share.isGrey() ? of(share.red()) : of(share);
    }

    static String pair(double a, double b) {
        return "(" + of(a, COMPONENT) + ", " + of(b, COMPONENT) + ")";
    }

    static String degrees(double angle) {
        return of(angle) + "°";
    }

    /** A number in a place where a minus would be misread. */
    static String factor(double value) {
        return value < 0 ? "(" + of(value) + ")" : of(value);
    }

    /** A power, the exponent raised if it is a whole number. */
    static String power(double base, double exponent) {
        return factor(base) + (exponent == Math.rint(exponent) ? superscript((int) exponent) : "^" + of(exponent));
    }

    private static String of(double value, MathContext digits) {
        if (!Double.isFinite(value)) {
            return Double.isNaN(value) ? "undefined" : value > 0 ? "∞" : "−∞";
        }
        BigDecimal rounded = new BigDecimal(value).round(digits);
        if (rounded.signum() == 0) {
            return "0";
        }
        int exponent = rounded.precision() - rounded.scale() - 1;
        boolean isExtreme = exponent < -4 || exponent > 6;
        BigDecimal plain = isExtreme ? rounded.scaleByPowerOfTen(-exponent) : rounded;
        String text = plain.stripTrailingZeros().toPlainString().replace('-', '−');
        return isExtreme ? text + "·10" + superscript(exponent) : text;
    }

    private static String triple(double a, double b, double c) {
        return "(" + of(a, COMPONENT) + ", " + of(b, COMPONENT) + ", " + of(c, COMPONENT) + ")";
    }

    private static String superscript(int number) {
        StringBuilder raised = new StringBuilder();
        for (char c : Integer.toString(number).toCharArray()) {
            raised.append(c == '-' ? '⁻' : SUPERSCRIPTS.charAt(c - '0'));
        }
        return raised.toString();
    }
}
