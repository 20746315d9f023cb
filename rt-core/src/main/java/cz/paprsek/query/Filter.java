package cz.paprsek.query;

import java.util.function.Predicate;

/**
 * A condition on the rows of a table, made from a text such as
 * {@code radius > 2 and (name like "gl%" or not material in ("steel", "brass"))}.
 *
 * <p>Comparisons {@code = != < <= > >=} of columns, numbers and texts; {@code like} with {@code %} for any characters and {@code _} for one,
 * letter case ignored; {@code in (…)}; {@code and}, {@code or}, {@code not}, parentheses. Where a row leads to rows of other tables:
 * {@code exists(torus)}, {@code exists(torus where minor-radius > 1)} and {@code count(sphere) > 3}. A column with several values meets a
 * comparison if one of them does, and one without a value does not; {@code !=} is exactly {@code not … =}.
 *
 * @param <R> the row
 */
public final class Filter<R> implements Predicate<R> {
    /** Nobody writes a longer one. */
    static final int LONGEST = 10_000;

    private final String text;
    private final Predicate<R> condition;

    private Filter(String text, Predicate<R> condition) {
        this.text = text;
        this.condition = condition;
    }

    /**
     * Understands a filter of a table's rows; a blank one takes all.
     *
     * @throws FilterException if it is wrong
     */
    public static <R> Filter<R> parse(String text, Table<R> table) throws FilterException {
        if (text.length() > LONGEST) {
            throw new FilterException(LONGEST + 1, "a filter has at most " + LONGEST + " characters, but this has " + text.length());
        }
        Tokens tokens = new Tokens(Lexer.tokens(text));
        return new Filter<>(text, text.isBlank() ? row -> true : new FilterParser<>(tokens, table).whole());
    }

    @Override
    public boolean test(R row) {
        return condition.test(row);
    }

    /** The filter as it was written. */
    @Override
    public String toString() {
        return text;
    }
}
