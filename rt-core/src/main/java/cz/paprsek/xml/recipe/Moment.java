package cz.paprsek.xml.recipe;

/**
 * The time that formulas know.
 *
 * @param t seconds
 * @param frame the number of the picture, from 1
 */
public record Moment(double t, double frame) {
    /** Of a picture at rest. */
    public static final Moment REST = new Moment(0, 1);
}
