package cz.paprsek.formula;

import java.util.List;
import java.util.Objects;

/** What a formula is made of; all three are found in it at a column, from 1. */
public sealed interface Term permits Term.Constant, Term.Name, Term.Call {
    int column();

    /** A number. */
    record Constant(double value, int column) implements Term {}

    /** Something that whoever asks for the value must know. */
    record Name(String name, int column) implements Term {
        public Name {
            Objects.requireNonNull(name, "name");
        }
    }

    /**
     * A function or an operation of other terms.
     *
     * @param terms as many as the function takes
     */
    record Call(Function function, List<Term> terms, int column) implements Term {
        public Call {
            Objects.requireNonNull(function, "function");
            terms = List.copyOf(terms);
        }
    }
}
