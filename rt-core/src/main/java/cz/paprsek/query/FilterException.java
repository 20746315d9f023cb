package cz.paprsek.query;

/** A filter cannot be understood. The message says where, what was expected and what was found, in one line. */
public final class FilterException extends Exception {
    private static final long serialVersionUID = 1;

    private final int position;

    FilterException(int position, String sentence) {
        super("character " + position + ": " + sentence);
        this.position = position;
    }

    /** The first character at fault, from 1; one more than the filter has if something is missing at its end. */
    public int position() {
        return position;
    }
}
