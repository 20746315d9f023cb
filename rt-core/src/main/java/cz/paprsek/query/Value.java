package cz.paprsek.query;

import cz.paprsek.material.Share.ByPattern;
import cz.paprsek.math.Vec3;
import cz.paprsek.text.Numbers;
import java.util.Objects;

/** What stands in a cell of a table. */
public sealed interface Value {
    /** The value as it would stand in a scene file; empty for nothing. */
    String text();

    /** A number. */
    record Scalar(double value) implements Value {
        @Override
        public String text() {
            return Numbers.text(value);
        }
    }

    /**
     * A share that a pattern says point by point, and so all from the smallest to the greatest. It compares with a number as one of these does.
     *
     * @param pattern its kind, as a scene file has it
     */
    record Range(double least, double most, String pattern) implements Value {
        private static final double DIGITS = 1e4;

        public Range {
            Objects.requireNonNull(pattern, "pattern");
        }

        /** That of such a share. */
        public static Range of(ByPattern share) {
            double most = share.most(1);
            return new Range(Math.min(share.least(), most), most, share.pattern().kind());
        }

        /** {@code 0..0.8 by checker} */
        @Override
        public String text() {
            Range shown = shown();
            return Numbers.text(shown.least) + ".." + Numbers.text(shown.most) + " by " + pattern;
        }

        /** The same to as many digits as are shown of shares, wherever they are: four after the point. */
        public Range shown() {
            return new Range(rounded(least), rounded(most), pattern);
        }

        private static double rounded(double share) {
            return Math.rint(share * DIGITS) / DIGITS;
        }
    }

    /** A text of any length, also none. */
    record Text(String text) implements Value {
        public Text {
            Objects.requireNonNull(text, "text");
        }
    }

    /** Three numbers: a vector, or a colour. */
    record Triple(Vec3 numbers) implements Value {
        public Triple {
            Objects.requireNonNull(numbers, "numbers");
        }

        @Override
        public String text() {
            return Numbers.text(numbers);
        }

        /** One of the three, by its place from 0. */
        double part(int place) {
            return place == 0 ? numbers.x() : place == 1 ? numbers.y() : numbers.z();
        }
    }

    /** There is no value. */
    enum Nothing implements Value {
        NOTHING;

        @Override
        public String text() {
            return "";
        }
    }

    /** The order of a sorted column: nothing first, numbers by size, what a pattern says by its greatest, text without regard to case. */
    static int compare(Value a, Value b) {
        Objects.requireNonNull(a, "a");
        Objects.requireNonNull(b, "b");
        if (rank(a) == 1 && rank(b) == 1) {
            return Double.compare(most(a), most(b));
        }
        if (a instanceof Triple x && b instanceof Triple y) {
            int first = Double.compare(x.part(0), y.part(0));
            int second = first != 0 ? first : Double.compare(x.part(1), y.part(1));
            return second != 0 ? second : Double.compare(x.part(2), y.part(2));
        }
        int types = Integer.compare(rank(a), rank(b));
        int letters = types != 0 ? types : String.CASE_INSENSITIVE_ORDER.compare(a.text(), b.text());
        return letters != 0 ? letters : a.text().compareTo(b.text());
    }

    private static double most(Value value) {
        return value instanceof Range range ? range.most : ((Scalar) value).value;
    }

    private static int rank(Value value) {
        return value instanceof Nothing ? 0 : value instanceof Scalar || value instanceof Range ? 1 : value instanceof Triple ? 2 : 3;
    }
}
