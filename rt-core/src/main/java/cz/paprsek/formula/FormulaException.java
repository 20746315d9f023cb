package cz.paprsek.formula;

/** A formula that is none, or that comes to no number. */
public final class FormulaException extends IllegalArgumentException {
    private static final long serialVersionUID = 1;

    private final int column;

    /**
     * What is wrong, and where.
     *
     * @param column where in the formula, from 1
     */
    FormulaException(int column, String message) {
        super(message);
        this.column = column;
    }

    /** Where in the formula, from 1. */
    public int column() {
        return column;
    }
}
