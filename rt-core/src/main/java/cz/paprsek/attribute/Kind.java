package cz.paprsek.attribute;

/** The kinds of values that attributes have: how each is written, what it must be, and its bounds. */
public enum Kind {
    POSITIVE("positive", 0, Double.POSITIVE_INFINITY),
    NOT_NEGATIVE("notNegative", 0, Double.POSITIVE_INFINITY),
    /** Of a light. */
    INTENSITY("notNegative", 0, 1e12),
    SHARE("share", 0, 1),
    EXPONENT("exponent", 0, 1_000_000),
    REFRACTIVE_INDEX("refractiveIndex", 0, 100),
    /** Degrees. */
    FOVY("fovy", 0, 180),
    /** Three numbers. */
    VECTOR("vector", Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY),
    POSITIVE_VECTOR("positiveVector", 0, Double.POSITIVE_INFINITY),
    /** Three angles in degrees. */
    ROTATION("vector", Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY),
    /** Three factors, or one for all. */
    SCALE("scale", Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY),
    COLOR("color", 0, 255),
    /** Whole numbers. */
    SQUARES("squares", 1, 1_000_000),
    PIXELS("pixels", 1, 32_768),
    DEPTH("depth", 1, 250),
    SAMPLES("samples", 1, 16);

    private final String type;
    private final double least;
    private final double most;

    Kind(String type, double least, double most) {
        this.type = type;
        this.least = least;
        this.most = most;
    }

    /** The name of the simple type in the schema, which says what a value must be. */
    public String type() {
        return type;
    }

    /** What a number must not be below. */
    public double least() {
        return least;
    }

    /** What a number must not be above. */
    public double most() {
        return most;
    }
}
