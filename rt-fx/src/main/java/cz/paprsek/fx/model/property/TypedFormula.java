package cz.paprsek.fx.model.property;

import cz.paprsek.formula.Formula;
import cz.paprsek.formula.FormulaException;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.util.function.DoubleFunction;

/**
 * What has been typed where a number stands. A sum of numbers is worked out at once. What begins with an equals sign, stands in braces or has names of
 * parameters is a formula, which is kept.
 */
public final class TypedFormula {
    /** What a formula begins with in a field. */
    public static final String SIGN = "=";

    private final String text;
    /** How many characters stand before the formula. */
    private final int before;
    private final boolean isKept;

    private TypedFormula(String text, int before, boolean isKept) {
        this.text = text;
        this.before = before;
        this.isKept = isKept;
    }

    /** @throws IllegalArgumentException that names the column if it is none */
    public static TypedFormula of(String typed) {
        int blanks = typed.length() - typed.stripLeading().length();
        String stripped = typed.strip();
        boolean isSigned = stripped.startsWith(SIGN) && !stripped.startsWith("==");
        boolean isBraced = stripped.startsWith("{") && stripped.endsWith("}");
        String text = isSigned ? stripped.substring(1) : isBraced ? stripped.substring(1, stripped.length() - 1) : stripped;
        int before = blanks + (isSigned || isBraced ? 1 : 0);
        Formula formula = told(before, () -> Formula.of(text));
        return new TypedFormula(text.strip(), before + text.length() - text.stripLeading().length(), isSigned || isBraced || !formula.names().isEmpty());
    }

    /** Without braces or sign. */
    public String text() {
        return text;
    }

    /** Whether it is to stay a formula. */
    public boolean isKept() {
        return isKept;
    }

    /** What it comes to if it is not kept. */
    public double value() {
        return told(before, () -> Formula.value(text));
    }

    /** The scene with it where a change puts a number. */
    public Scene kept(Scene scene, DoubleFunction<Scene> change) {
        return told(before, () -> SceneFiles.withFormula(scene, change, text));
    }

    @FunctionalInterface
    private interface Work<T> {
        T run();
    }

    /** Mistakes are told by where they are in what has been typed. */
    private static <T> T told(int before, Work<T> work) {
        try {
            return work.run();
        } catch (FormulaException wrong) {
            throw new IllegalArgumentException("column " + (before + wrong.column()) + ": " + wrong.getMessage(), wrong);
        }
    }
}
