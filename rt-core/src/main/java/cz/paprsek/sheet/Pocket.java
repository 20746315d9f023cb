package cz.paprsek.sheet;

import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.text.Numbers;
import java.math.BigDecimal;

/** Numbers as they stand on paper: of four decimals, and what is reckoned goes on with these, as with a pocket calculator. */
final class Pocket {
    private static final double STEPS = 1e4;

    private Pocket() {}

    static double of(double value) {
        // Without a zero that is negative.
        return Math.rint(value * STEPS) / STEPS + 0.0;
    }

    static Vec3 of(Vec3 v) {
        return new Vec3(of(v.x()), of(v.y()), of(v.z()));
    }

    static LinearRgb of(LinearRgb light) {
        return new LinearRgb(of(light.red()), of(light.green()), of(light.blue()));
    }

    static String text(double value) {
        // Never as a power of ten: 0.0006.
        return new BigDecimal(Numbers.text(of(value))).toPlainString().replace('-', '−');
    }

    static String text(Vec3 v) {
        return "(" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + ")";
    }

    static String text(LinearRgb light) {
        return "(" + text(light.red()) + ", " + text(light.green()) + ", " + text(light.blue()) + ")";
    }

    /** In whole steps, as pictures have it. */
    static String shown(LinearRgb light) {
        return Math.round(light.shown().red()) + " " + Math.round(light.shown().green()) + " " + Math.round(light.shown().blue());
    }
}
