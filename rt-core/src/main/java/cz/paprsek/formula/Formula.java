package cz.paprsek.formula;

import cz.paprsek.text.Numbers;
import cz.paprsek.text.Similar;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;

/**
 * A formula such as {@code 1/3}, {@code 2*(r + 1)}, {@code i % 2 == 0 ? 1 : sqrt(2)}. There are no loops, nothing that reads or writes, and no more of it than
 * {@value #LONGEST} characters, so that its value takes next to no time whoever has written it. Immutable.
 *
 * <p>From what binds least to what binds most: {@code a ? b : c}; {@code or}; {@code and}; {@code == !=}; {@code < <= > >=}; {@code + -}; {@code * / %};
 * {@code -a}, {@code not a}; {@code ^}, from the right. {@code && || ! × ÷ − · ≤ ≥ ≠ °} may stand in their places, a comma for a decimal point.
 */
public final class Formula {
    /** How many characters it may have. */
    public static final int LONGEST = 1000;

    private final String text;
    private final Term term;

    private Formula(String text, Term term) {
        this.text = text;
        this.term = term;
    }

    /**
     * The formula that a text is.
     *
     * @throws FormulaException with what was expected where, and what was found
     */
    public static Formula of(String text) {
        Objects.requireNonNull(text, "text");
        return new Formula(text, new Parser(text).whole());
    }

    /**
     * What a text without names comes to.
     *
     * @throws FormulaException as {@link #of} and {@link #value(Values)}
     */
    public static double value(String text) {
        return of(text).value(Values.NONE);
    }

    /** What it is made of. */
    public Term term() {
        return term;
    }

    /** The names in it, in their order. */
    public Set<String> names() {
        Set<String> names = new LinkedHashSet<>();
        collect(term, names);
        return names;
    }

    private static void collect(Term term, Set<String> into) {
        if (term instanceof Term.Name name) {
            into.add(name.name());
        } else if (term instanceof Term.Call call) {
            call.terms().forEach(one -> collect(one, into));
        }
    }

    /**
     * What it comes to.
     *
     * @throws FormulaException if a name is not known, or any part of it that is needed comes to no finite number
     */
    public double value(Values values) {
        return value(term, Objects.requireNonNull(values, "values"));
    }

    private static double value(Term term, Values values) {
        if (term instanceof Term.Constant constant) {
            return constant.value();
        }
        return term instanceof Term.Name name ? value(name, values) : value((Term.Call) term, values);
    }

    private static double value(Term.Name name, Values values) {
        try {
            return values.of(name.name()).orElseThrow(() -> unknown(name, values));
        } catch (FormulaException known) {
            throw known;
        } catch (IllegalArgumentException without) {
            throw new FormulaException(name.column(), String.valueOf(without.getMessage()));
        }
    }

    private static FormulaException unknown(Term.Name name, Values values) {
        List<String> known = new ArrayList<>(values.names());
        known.addAll(Function.words());
        known.add(Parser.PI);
        boolean isFunction = Function.words().contains(name.name());
        return new FormulaException(name.column(), isFunction ? "what " + name.name() + " is to be taken of must stand behind it in parentheses"
                : '"' + name.name() + "\" is not a number, and no parameter is called so" + Similar.suggestion(name.name(), known));
    }

    private static double value(Term.Call call, Values values) {
        List<Term> terms = call.terms();
        double a = value(terms.get(0), values);
        if (call.function() == Function.IF) {
            return value(terms.get(a != 0 ? 1 : 2), values);
        }
        double b = terms.size() > 1 ? value(terms.get(1), values) : 0;
        double c = terms.size() > 2 ? value(terms.get(2), values) : 0;
        double value = call.function().of(a, b, c);
        if (!Double.isFinite(value)) {
            throw new FormulaException(call.column(), '"' + said(call, a, b, c) + "\" has no finite value");
        }
        return value;
    }

    private static String said(Term.Call call, double a, double b, double c) {
        String word = call.function().word();
        List<String> all = List.of(Numbers.text(a), Numbers.text(b), Numbers.text(c)).subList(0, call.terms().size());
        return call.function().isCalled() ? word + "(" + String.join(", ", all) + ")" : all.size() == 1 ? word + all.get(0) : String.join(" " + word + " ", all);
    }

    /** The text that it was made of. */
    @Override
    public String toString() {
        return text;
    }
}
