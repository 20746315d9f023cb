package cz.paprsek.query;

import java.util.Arrays;
import java.util.Optional;

/** The signs that compare two values. */
enum Comparison {
    EQUAL("="), LESS("<"), LESS_OR_EQUAL("<="), GREATER(">"), GREATER_OR_EQUAL(">=");

    private final String sign;

    Comparison(String sign) {
        this.sign = sign;
    }

    static Optional<Comparison> of(Token token) {
        String written = token.is("==") ? "=" : token.text();
        return token.kind() != Token.Kind.SYMBOL ? Optional.empty()
                : Arrays.stream(values()).filter(comparison -> comparison.sign.equals(written)).findFirst();
    }

    /** Whether two values of one type compare like this; of what a pattern says, whether something there is does. */
    boolean holds(Value a, Value b) {
        return switch (this) {
            case EQUAL -> order(least(a), most(b)) <= 0 && order(most(a), least(b)) >= 0;
            case LESS -> order(least(a), most(b)) < 0;
            case LESS_OR_EQUAL -> order(least(a), most(b)) <= 0;
            case GREATER -> order(most(a), least(b)) > 0;
            case GREATER_OR_EQUAL -> order(most(a), least(b)) >= 0;
        };
    }

    private static Value least(Value value) {
        return value instanceof Value.Range range ? new Value.Scalar(range.least()) : value;
    }

    private static Value most(Value value) {
        return value instanceof Value.Range range ? new Value.Scalar(range.most()) : value;
    }

    /** Text by the numbers of its characters; numbers by size, −0 being 0. */
    private static int order(Value a, Value b) {
        if (a instanceof Value.Text x && b instanceof Value.Text y) {
            return x.text().compareTo(y.text());
        }
        if (a instanceof Value.Scalar x && b instanceof Value.Scalar y) {
            return order(x.value(), y.value());
        }
        // Three numbers are only ever asked whether they are equal.
        return a instanceof Value.Triple x && b instanceof Value.Triple y && order(x.part(0), y.part(0)) == 0
                && order(x.part(1), y.part(1)) == 0 && order(x.part(2), y.part(2)) == 0 ? 0 : 1;
    }

    private static int order(double a, double b) {
        return a < b ? -1 : a > b ? 1 : 0;
    }
}
