package cz.paprsek.attribute;

/**
 * Between which bounds numbers are.
 *
 * @param takesLeast whether the least is one of them
 * @param takesMost whether the greatest is one of them
 */
public record Range(double least, boolean takesLeast, double most, boolean takesMost) {
    static final Range ANY = new Range(Double.NEGATIVE_INFINITY, false, Double.POSITIVE_INFINITY, false);

    static Range above(double least) {
        return new Range(least, false, Double.POSITIVE_INFINITY, false);
    }

    static Range from(double least) {
        return new Range(least, true, Double.POSITIVE_INFINITY, false);
    }

    Range to(double value) {
        return new Range(least, takesLeast, value, true);
    }

    Range below(double value) {
        return new Range(least, takesLeast, value, false);
    }
}
