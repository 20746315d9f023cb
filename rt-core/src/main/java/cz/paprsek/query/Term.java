package cz.paprsek.query;

import cz.paprsek.math.Vec3;
import java.util.function.Predicate;

/**
 * One side of a comparison: a column, a number, a text or a count.
 *
 * @param token where it stands
 * @param name how to call it in a message
 * @param isFixed whether it is the same for every row
 */
record Term<R>(Token token, String name, Column.Type type, boolean isFixed, Column.Values<R> values) {

    static <R> Term<R> fixed(Token token, Column.Type type, Value value) {
        return new Term<>(token, token.shown(), type, true, (row, test) -> test.test(value));
    }

    static <R> Term<R> of(Token token, Column<R> column) {
        return new Term<>(token, column.name(), column.type(), false, column::any);
    }

    boolean any(R row, Predicate<Value> test) {
        return values.any(row, test);
    }

    /** This term as something that can be compared with the other: text of three numbers is taken for a vector or colour. */
    Term<R> toMatch(Term<R> other, Comparison comparison) throws FilterException {
        boolean areParts = !other.type.parts().isEmpty();
        if (areParts && comparison != Comparison.EQUAL) {
            throw new FilterException(other.token.position(), other.name + " is " + other.type.words() + ", which are neither more nor less; compare "
                    + String.join(", ", other.type.parts().stream().map(part -> other.name + "." + part).toList()));
        }
        if (type == other.type) {
            return this;
        }
        if (areParts && isFixed && type == Column.Type.TEXT) {
            return fixed(token, other.type, new Value.Triple(triple(other)));
        }
        throw new FilterException(token.position(), mismatch(other));
    }

    private String mismatch(Term<R> other) {
        String advice = other.type == Column.Type.NUMBER && isFixed ? "; write a number without quotes"
                : other.type == Column.Type.TEXT && isFixed ? "; put text in quotes"
                : !other.type.parts().isEmpty() ? "; write three numbers in quotes, or compare " + other.name + "." + other.type.parts().get(0) : "";
        return other.name + " is " + other.type.words() + " and cannot be compared with " + name + ", which is " + type.words() + advice;
    }

    private Vec3 triple(Term<R> other) throws FilterException {
        String[] words = token.text().trim().split("[\\s,]+", -1);
        if (words.length != 3) {
            String example = other.type == Column.Type.COLOR ? "255 128 0" : "0 1 0";
            throw new FilterException(token.position(),
                    other.name + " is " + other.type.words() + ", so expected three numbers such as \"" + example + "\", but found " + token.shown());
        }
        double[] numbers = new double[3];
        for (int i = 0; i < 3; i++) {
            numbers[i] = Lexer.number(new Token(Token.Kind.NUMBER, words[i], token.position()));
        }
        return new Vec3(numbers[0], numbers[1], numbers[2]);
    }
}
