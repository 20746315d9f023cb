package cz.paprsek.xml.recipe;

import cz.paprsek.formula.Formula;
import cz.paprsek.formula.FormulaException;
import cz.paprsek.formula.Term;
import cz.paprsek.formula.Values;
import cz.paprsek.text.Numbers;
import cz.paprsek.xml.recipe.Node.Attr;
import cz.paprsek.xml.recipe.Template.Misplaced;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

/** What names in formulas stand for: numbers of copies, innermost first, then parameters, then the time. */
final class Names implements Values {
    private static final Set<String> TIME = Set.of("t", "frame");

    private final Map<String, Param> params = new LinkedHashMap<>();
    private final Deque<Bound> bound = new ArrayDeque<>();
    private final Wrong wrong;
    private final Moment moment;

    private record Bound(String name, double value) {}

    Names(Wrong wrong, Moment moment) {
        this.wrong = wrong;
        this.moment = moment;
    }

    /** Hears of parameters that have no value. */
    @FunctionalInterface
    interface Wrong {
        void about(Param param, Misplaced why);
    }

    /** What has been told already need not be told where it is used. */
    static final class ToldAlready extends RuntimeException {
        private static final long serialVersionUID = 1;

        ToldAlready() {
            super("told already", null, false, false);
        }
    }

    private enum State { NEW, BEING_WORKED_OUT, KNOWN, WRONG }

    /** A parameter: a number, or a text, such as a colour's name, that may stand in place of a value. */
    static final class Param {
        private final Node node;
        private State state = State.NEW;
        private OptionalDouble number = OptionalDouble.empty();
        private String text = "";

        Param(Node node) {
            this.node = node;
        }

        Node node() {
            return node;
        }

        OptionalDouble number() {
            return number;
        }

        String text() {
            return text;
        }
    }

    Map<String, Param> params() {
        return params;
    }

    void bind(String name, double value) {
        bound.push(new Bound(name, value));
    }

    void unbind() {
        bound.pop();
    }

    static boolean isTaken(String name) {
        return TIME.contains(name);
    }

    /**
     * The value of a parameter, worked out when it is first asked for.
     *
     * @throws ToldAlready if it has none
     */
    Param known(String name) {
        Param param = Objects.requireNonNull(params.get(name), name);
        if (param.state == State.WRONG) {
            throw new ToldAlready();
        }
        if (param.state == State.BEING_WORKED_OUT) {
            throw new IllegalArgumentException("the parameter \"" + name + "\" needs itself");
        }
        if (param.state == State.NEW) {
            param.state = State.BEING_WORKED_OUT;
            try {
                workOut(param);
                param.state = State.KNOWN;
            } catch (Misplaced why) {
                param.state = State.WRONG;
                wrong.about(param, why);
                throw new ToldAlready();
            } catch (ToldAlready another) {
                param.state = State.WRONG;
                throw another;
            }
        }
        return param;
    }

    private void workOut(Param param) {
        Optional<Attr> value = param.node.attribute("value");
        String text = value.map(one -> one.template().isPresent() ? one.template().get().value(this) : one.text().strip()).orElse("");
        param.text = text;
        try {
            // Without braces, a sum of numbers is one, all else a text.
            param.number = OptionalDouble.of(Formula.value(text));
            param.text = Numbers.text(param.number.getAsDouble() + 0.0);
        } catch (FormulaException noNumber) {
            param.number = OptionalDouble.empty();
        }
    }

    /** The text of a parameter that is no number; empty if there is no such parameter. */
    Optional<String> word(String name) {
        if (isBound(name) || !params.containsKey(name)) {
            return Optional.empty();
        }
        Param param = known(name);
        return param.number.isPresent() || isFormula(param.text) ? Optional.empty() : Optional.of(param.text);
    }

    private boolean isBound(String name) {
        return bound.stream().anyMatch(one -> one.name.equals(name));
    }

    @Override
    public OptionalDouble of(String name) {
        for (Bound one : bound) {
            if (one.name.equals(name)) {
                return OptionalDouble.of(one.value);
            }
        }
        if (params.containsKey(name)) {
            Param param = known(name);
            if (param.number.isEmpty()) {
                throw new IllegalArgumentException("the parameter \"" + name + "\" is \"" + param.text + "\", which is no number"
                        + (isFormula(param.text) ? "; as a formula it stands in braces, {" + param.text + "}" : ""));
            }
            return param.number;
        }
        return switch (name) {
            case "t" -> OptionalDouble.of(moment.t());
            case "frame" -> OptionalDouble.of(moment.frame());
            default -> OptionalDouble.empty();
        };
    }

    /** Not a word alone, which may be that of a colour. */
    private static boolean isFormula(String text) {
        try {
            Formula formula = Formula.of(text);
            return !formula.names().isEmpty() && !(formula.term() instanceof Term.Name);
        } catch (FormulaException none) {
            return false;
        }
    }

    @Override
    public Collection<String> names() {
        Set<String> all = new LinkedHashSet<>(params.keySet());
        bound.forEach(one -> all.add(one.name));
        return all;
    }
}
