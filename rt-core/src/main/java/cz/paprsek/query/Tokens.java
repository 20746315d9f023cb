package cz.paprsek.query;

import java.util.List;

/** The words of a filter, read from left to right, and how deep in parentheses the reader is. */
final class Tokens {
    /** Deeper than anybody nests, and shallow enough for every stack. */
    private static final int DEEPEST = 100;

    private final List<Token> tokens;
    private int at;
    private int depth;

    Tokens(List<Token> tokens) {
        this.tokens = tokens;
    }

    Token peek() {
        return tokens.get(at);
    }

    /** The word after the next. */
    Token second() {
        return tokens.get(Math.min(at + 1, tokens.size() - 1));
    }

    Token next() {
        Token token = tokens.get(at);
        at = Math.min(at + 1, tokens.size() - 1);
        return token;
    }

    /** Goes past the next word if it is this one. */
    boolean skip(String word) {
        boolean found = peek().is(word);
        if (found) {
            next();
        }
        return found;
    }

    void expect(String word, String why) throws FilterException {
        if (!skip(word)) {
            throw unexpected("\"" + word + "\" " + why);
        }
    }

    void open() throws FilterException {
        if (++depth > DEEPEST) {
            throw new FilterException(peek().position(), "parentheses are nested deeper than " + DEEPEST);
        }
    }

    void close() {
        depth--;
    }

    FilterException unexpected(String expected) {
        return new FilterException(peek().position(), "expected " + expected + ", but found " + peek().shown());
    }
}
