package cz.paprsek.query;

/**
 * A word of a filter.
 *
 * @param text as written; for text in quotes, what it means
 * @param position of its first character, from 1
 */
record Token(Kind kind, String text, int position) {
    enum Kind { WORD, NUMBER, TEXT, SYMBOL, END }

    /** Whether this is a word of the language or a sign; never a text in quotes. Letter case does not matter. */
    boolean is(String word) {
        return kind != Kind.TEXT && text.equalsIgnoreCase(word);
    }

    /** How to name it in a message. */
    String shown() {
        return switch (kind) {
            case END -> "the end";
            case TEXT -> "the text \"" + text + "\"";
            default -> "\"" + text + "\"";
        };
    }
}
