package cz.paprsek.pov;

import static cz.paprsek.text.Numbers.text;

import cz.paprsek.formula.Formula;
import cz.paprsek.formula.Function;
import cz.paprsek.formula.Term;
import cz.paprsek.shape.Isosurface;
import cz.paprsek.shape.field.Field;
import java.util.Collections;
import java.util.List;

/** Formulas in POV-Ray's words: as functions of isosurfaces, with the steepest slope that POV-Ray must be told. */
final class PovFormulas {
    private static final int PARTS = 12;
    /** Powers are written out, and powers of powers would be without end. */
    private static final int LONGEST = 10_000;
    /** As near as POV-Ray looks for the surface, as a share of the box. */
    private static final double ACCURACY = 1e-9;

    private PovFormulas() {}

    static String isosurface(Isosurface body) {
        double slope = steepest(new Field("isosurface expression", body.expression()), body);
        if (!(slope < 1e9)) {
            throw new IllegalArgumentException("a scene for POV-Ray cannot hold the isosurface \"" + body.expression() + "\": POV-Ray must know how steep it is at most, and it jumps or rises without end");
        }
        double size = Math.min(body.max().x() - body.min().x(), Math.min(body.max().y() - body.min().y(), body.max().z() - body.min().z()));
        return "isosurface { function { " + of(Formula.of(body.expression()).term()) + " } contained_by { box { " + PovText.vector(body.min()) + ", " + PovText.vector(body.max())
                + " } } accuracy " + text(ACCURACY * size) + " max_gradient " + text(slope) + " all_intersections";
    }

    /** The length of the gradient, at most, by its bounds in parts of the box. */
    private static double steepest(Field field, Isosurface body) {
        double[] room = field.newRoom();
        double most = 0;
        for (int i = 0; i < PARTS * PARTS * PARTS; i++) {
            double x = body.max().x() - body.min().x();
            double y = body.max().y() - body.min().y();
            double z = body.max().z() - body.min().z();
            int column = i % PARTS;
            int row = i / PARTS % PARTS;
            int layer = i / PARTS / PARTS;
            double[] box = {
                body.min().x() + x * column / PARTS, body.min().y() + y * row / PARTS, body.min().z() + z * layer / PARTS,
                body.min().x() + x * (column + 1) / PARTS, body.min().y() + y * (row + 1) / PARTS, body.min().z() + z * (layer + 1) / PARTS};
            double square = 0;
            for (int axis = 0; axis < 3; axis++) {
                int at = field.within(box, axis, room);
                double slope = Math.max(-room[at + 2], room[at + 3]);
                square += slope * slope;
            }
            most = Math.max(most, Math.sqrt(square));
        }
        return most;
    }

    private static String of(Term term) {
        if (term instanceof Term.Constant constant) {
            return constant.value() < 0 ? "(" + text(constant.value()) + ")" : text(constant.value());
        } else if (term instanceof Term.Name name) {
            return name.name();
        }
        Term.Call call = (Term.Call) term;
        List<String> of = call.terms().stream().map(PovFormulas::of).toList();
        String all = of(call, of);
        if (all.length() > LONGEST) {
            throw new IllegalArgumentException("a scene for POV-Ray cannot hold a formula that is longer than " + LONGEST + " characters in its words");
        }
        return all;
    }

    private static String of(Term.Call call, List<String> of) {
        Function function = call.function();
        return switch (function) {
            case NEGATE -> "(-" + of.get(0) + ")";
            case PLUS, MINUS, TIMES, DIVIDE -> "(" + of.get(0) + " " + function.word() + " " + of.get(1) + ")";
            case POWER -> power(of.get(0), call.terms().get(1), of.get(1));
            case SIN, COS, TAN -> function.word() + "(radians(" + of.get(0) + "))";
            case ASIN, ACOS, ATAN -> "degrees(" + function.word() + "(" + of.get(0) + "))";
            case ATAN2 -> "degrees(atan2(" + of.get(0) + ", " + of.get(1) + "))";
            case SQRT, EXP, ABS -> function.word() + "(" + of.get(0) + ")";
            case LN -> "ln(" + of.get(0) + ")";
            case LOG10 -> "log(" + of.get(0) + ")";
            case MIN, MAX -> function.word() + "(" + of.get(0) + ", " + of.get(1) + ")";
            case HYPOT -> "sqrt(" + of.get(0) + "*" + of.get(0) + " + " + of.get(1) + "*" + of.get(1) + ")";
            case CLAMP -> "max(" + of.get(1) + ", min(" + of.get(2) + ", " + of.get(0) + "))";
            case MIX -> "(" + of.get(0) + " + (" + of.get(1) + " - " + of.get(0) + ")*" + of.get(2) + ")";
            default -> throw new IllegalArgumentException("a scene for POV-Ray cannot hold a formula with \"" + function.word() + "\"");
        };
    }

    /** Its own power knows no negative numbers below. */
    private static String power(String base, Term exponent, String otherwise) {
        if (exponent instanceof Term.Constant constant && constant.value() == Math.rint(constant.value()) && constant.value() >= 1 && constant.value() <= 12) {
            return "(" + String.join("*", Collections.nCopies((int) constant.value(), base)) + ")";
        }
        return "pow(" + base + ", " + otherwise + ")";
    }
}
