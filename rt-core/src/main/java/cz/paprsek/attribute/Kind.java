package cz.paprsek.attribute;

/** The kinds of values that attributes have: how each is written, what it must be, and its bounds. A new one is a line here. */
public enum Kind {
    NUMBER(Form.NUMBER, "number", "a finite number", Range.ANY),
    POSITIVE(Form.NUMBER, "positive", "a finite number above 0", Range.above(0)),
    NOT_NEGATIVE(Form.NUMBER, "notNegative", "a finite number, 0 or above", Range.from(0)),
    /** Of a light. */
    INTENSITY(Form.NUMBER, "notNegative", "a finite number, 0 or above", Range.from(0).to(1e12)),
    SHARE(Form.NUMBER, "share", "a number from 0 to 1", Range.from(0).to(1)),
    EXPONENT(Form.NUMBER, "exponent", "a number from 0 to 1000000", Range.from(0).to(1_000_000)),
    /** Of a superellipsoid. */
    ROUNDNESS(Form.NUMBER, "roundness", "a number above 0, 2 at most", Range.above(0).to(2)),
    REFRACTIVE_INDEX(Form.NUMBER, "refractiveIndex", "a number above 0 and at most 100", Range.above(0).to(100)),
    /** Degrees. */
    FOVY(Form.NUMBER, "fovy", "a number of degrees above 0 and below 180", Range.above(0).below(180)),
    /** Degrees. */
    FISHEYE(Form.NUMBER, "fisheye", "a number of degrees above 0, 360 at most", Range.above(0).to(360)),
    /** Degrees from the middle of a cone. */
    CONE_ANGLE(Form.NUMBER, "coneAngle", "a number of degrees from 0 to 90", Range.from(0).to(90)),
    /** Degrees from one side of a disc to the other. */
    DISC_ANGLE(Form.NUMBER, "discAngle", "a number of degrees from 0 to 180", Range.from(0).to(180)),
    /** Degrees, to one side or the other. */
    TWIST(Form.NUMBER, "twist", "a number of degrees from -36000 to 36000", Range.from(-36_000).to(36_000)),
    /** Degrees around an axis. */
    TURN(Form.NUMBER, "turn", "a number of degrees above 0, 360 at most", Range.above(0).to(360)),
    /** Three numbers. */
    VECTOR(Form.VECTOR, "vector", "three finite numbers, x y z", Range.ANY),
    POSITIVE_VECTOR(Form.VECTOR, "positiveVector", "three finite numbers above 0", Range.above(0)),
    /** Three angles in degrees. */
    ROTATION(Form.VECTOR, "vector", "three finite numbers, x y z", Range.ANY),
    /** Two numbers, which two components of the same name have. */
    PAIR(Form.PAIR, "pair", "two finite numbers, x y", Range.ANY),
    POSITIVE_PAIR(Form.PAIR, "positivePair", "two finite numbers above 0", Range.above(0)),
    /** Three factors, or one for all. */
    SCALE(Form.SCALE, "scale", "one finite number or three, none of them 0", Range.ANY),
    /** Three sizes, or one for all. */
    POSITIVE_SCALE(Form.SCALE, "positiveScale", "one finite number above 0 or three", Range.above(0)),
    COLOR(Form.COLOR, "color", "three numbers from 0 to 255, red green blue, a name such as red, or #rrggbb", Range.from(0).to(255)),
    /** Whole numbers. */
    SQUARES(Form.WHOLE, "squares", "a whole number from 1 to 1000000", Range.from(1).to(1_000_000)),
    SIDES(Form.WHOLE, "sides", "a whole number from 3 to 1000", Range.from(3).to(1000)),
    SIDES_OR_NONE(Form.WHOLE, "sidesOrNone", "a whole number from 3 to 1000, or 0 for round", Range.from(0).to(1000)),
    OCTAVES(Form.WHOLE, "octaves", "a whole number from 1 to 12", Range.from(1).to(12)),
    SEED(Form.WHOLE, "seed", "a whole number from 0 to 1000000", Range.from(0).to(1_000_000)),
    PIXELS(Form.WHOLE, "pixels", "a whole number from 1 to 32768", Range.from(1).to(32_768)),
    DEPTH(Form.WHOLE, "depth", "a whole number from 1 to 250", Range.from(1).to(250)),
    /** One whole number, or two with two dots between, which two components of the same name have: the second 0 if there is one. */
    SAMPLES(Form.FROM_TO, "samples", "a whole number from 1 to 16, of paths to 1000000, or two such as 2..8", Range.from(1).to(1_000_000)),
    MOST_SAMPLES(Form.FROM_TO, "samples", "a whole number from 1 to 16, of paths to 1000000, or two such as 2..8", Range.from(0).to(1_000_000)),
    /** Doublings of light. */
    STOPS(Form.NUMBER, "stops", "a number of stops from -100 to 100", Range.from(-100).to(100)),
    /** Pictures a second. */
    FRAME_RATE(Form.NUMBER, "frameRate", "a number above 0 and at most 1000", Range.above(0).to(1000)),
    CONFIDENCE(Form.NUMBER, "confidence", "a number above 0 and below 1", Range.above(0).below(1)),
    LIGHT_SAMPLES(Form.WHOLE, "lightSamples", "a whole number from 1 to 4096", Range.from(1).to(4096)),
    /** Of a file, relative to the folder of the scene. */
    FILE(Form.TEXT, "file", "the name of a file beside the scene's, of 1 to 1000 characters", Range.from(1).to(1000)),
    NAME(Form.TEXT, "name", "a text of 1 to 200 characters", Range.from(1).to(200)),
    /** Commands of SVG. */
    PATH(Form.TEXT, "path", "path data of SVG, at most 100000 characters", Range.from(0).to(100_000)),
    /** Corners in the plane. */
    POINTS(Form.TEXT, "points", "numbers, x and y of each corner, at most 100000 characters", Range.from(0).to(100_000)),
    /** What is to be written. */
    LETTERS(Form.TEXT, "letters", "a text of 1 to 1000 characters", Range.from(1).to(1000)),
    /** One that is shipped, or of a file, relative to the folder of the scene. */
    FONT(Form.TEXT, "font", "sans, sans-bold, serif or the name of a TrueType file beside the scene's, of 1 to 1000 characters", Range.from(1).to(1000)),
    /** Of a key. */
    VALUES(Form.TEXT, "values", "one to three finite numbers, or a colour", Range.from(1).to(200)),
    /** A formula. */
    EXPRESSION(Form.TEXT, "expression", "a formula of x, y and z, of 1 to 1000 characters", Range.from(1).to(1000)),
    FREE_TEXT(Form.TEXT, "text", "a text of at most 100000 characters", Range.from(0).to(100_000)),
    /** A list of them. */
    WORDS(Form.WORDS, "tags", "words separated by blanks", Range.ANY),
    FLAG(Form.FLAG, "flag", "true or false", Range.ANY),
    /** One of the constants of an enumeration, or of the kinds of record that a sealed interface permits, in small letters and with hyphens. */
    WORD(Form.WORD, "", "", Range.ANY);

    /** How values are written. */
    public enum Form { NUMBER, WHOLE, FROM_TO, VECTOR, PAIR, SCALE, COLOR, TEXT, WORDS, FLAG, WORD }

    private final Form form;
    private final String type;
    private final String words;
    private final double least;
    private final boolean takesLeast;
    private final double most;
    private final boolean takesMost;

    Kind(Form form, String type, String words, Range range) {
        this.form = form;
        this.type = type;
        this.words = words;
        least = range.least();
        takesLeast = range.takesLeast();
        most = range.most();
        takesMost = range.takesMost();
    }

    public Form form() {
        return form;
    }

    /** The name of the simple type in the schema, which kinds may share; that of a {@link #WORD} is its enumeration's. */
    public String type() {
        return type;
    }

    /** What a value must be: completes the sentence "must be …". */
    public String words() {
        return words;
    }

    /** The bounds of each of its numbers, or of the length of a text. */
    public Range range() {
        return new Range(least, takesLeast, most, takesMost);
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
