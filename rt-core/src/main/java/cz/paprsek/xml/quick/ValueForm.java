package cz.paprsek.xml.quick;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Described;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.xml.format.ColorWords;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.StringTokenizer;

/** A form that the values of attributes have. */
abstract class ValueForm {
    static final ValueForm NUMBER = new OfNumbers() {
        @Override
        Object of(double[] n, int count) {
            Unusual.unless(count == 1);
            return n[0];
        }
    };
    static final ValueForm OPTIONAL_NUMBER = new OfNumbers() {
        @Override
        Object of(double[] n, int count) {
            Unusual.unless(count == 1);
            return OptionalDouble.of(n[0]);
        }
    };
    static final ValueForm VECTOR = new OfNumbers() {
        @Override
        Object of(double[] n, int count) {
            Unusual.unless(count == 3);
            return new Vec3(n[0], n[1], n[2]);
        }
    };
    /** One for all axes, or three. */
    static final ValueForm SCALE = new OfNumbers() {
        @Override
        Object of(double[] n, int count) {
            Unusual.unless(count == 1 || count == 3);
            return count == 1 ? new Vec3(n[0], n[0], n[0]) : new Vec3(n[0], n[1], n[2]);
        }
    };
    static final ValueForm COLOR = new OfNumbers() {
        @Override
        Object of(double[] n, int count) {
            Unusual.unless(count == 3);
            return new Rgb(n[0], n[1], n[2]);
        }

        @Override
        Object read(Markup markup, double[] room) {
            return markup.isWord() ? ColorWords.of(markup.value().strip()) : super.read(markup, room);
        }
    };
    /** Two numbers, in an array. */
    static final ValueForm PAIR = new OfNumbers() {
        @Override
        Object of(double[] n, int count) {
            Unusual.unless(count == 2);
            return new double[] {n[0], n[1]};
        }
    };
    /** One whole number or two, in an array; 0 for the second if it is not there. */
    static final ValueForm FROM_TO = new OfText() {
        @Override
        Object of(String text) {
            int dots = text.indexOf("..");
            return dots < 0 ? new double[] {whole(text), 0} : new double[] {whole(text.substring(0, dots)), whole(text.substring(dots + 2))};
        }

        private int whole(String text) {
            Unusual.unless(text.chars().allMatch(c -> c >= '0' && c <= '9'));
            int number = Integer.parseInt(text);
            Unusual.unless(number > 0);
            return number;
        }
    };
    /** Not blanks around it, nor digits of other scripts. */
    static final ValueForm WHOLE = new OfText() {
        @Override
        Object of(String text) {
            Unusual.unless(text.chars().allMatch(c -> c < 128));
            return Integer.parseInt(text);
        }
    };
    /** Not empty if it is given. */
    static final ValueForm TEXT = new OfText() {
        @Override
        Object of(String text) {
            Unusual.unless(!text.isEmpty());
            return text;
        }
    };
    /** Any number of them, in a list. */
    static final ValueForm WORDS = new OfText() {
        @Override
        Object of(String text) {
            return Collections.list(new StringTokenizer(text));
        }
    };
    static final ValueForm FLAG = new OfText() {
        @Override
        Object of(String text) {
            Unusual.unless(text.equals("true") || text.equals("false"));
            return text.equals("true");
        }
    };

    /**
     * The value of the attribute at hand.
     *
     * @param room for three numbers
     * @throws IllegalArgumentException if it has another form
     */
    abstract Object read(Markup markup, double[] room);

    /** The value of a text that a program has. */
    abstract Object of(String text);

    private abstract static class OfNumbers extends ValueForm {
        /** @throws IllegalArgumentException if there are too few or too many, or the value does not take them */
        abstract Object of(double[] numbers, int count);

        @Override
        Object read(Markup markup, double[] room) {
            return of(room, markup.numbers(room));
        }

        @Override
        Object of(String text) {
            double[] numbers = Arrays.stream(text.split(" ")).mapToDouble(Double::parseDouble).toArray();
            return of(numbers, numbers.length);
        }
    }

    private abstract static class OfText extends ValueForm {
        @Override
        Object read(Markup markup, double[] room) {
            return of(markup.value());
        }
    }

    /** One of the constants of an enumeration, or of the kinds of a record. */
    private static final class OfWord extends OfText {
        private final Map<String, Object> constants;

        OfWord(Class<?> type) {
            constants = Described.words(type);
        }

        @Override
        Object of(String text) {
            Unusual.unless(constants.containsKey(text));
            return constants.getOrDefault(text, text);
        }
    }

    /** The form of an attribute. */
    static ValueForm of(Described one) {
        return switch (one.says().value().form()) {
            case NUMBER -> one.type() == OptionalDouble.class ? OPTIONAL_NUMBER : NUMBER;
            case WHOLE -> WHOLE;
            case FROM_TO -> FROM_TO;
            case VECTOR -> VECTOR;
            case PAIR -> PAIR;
            case SCALE -> SCALE;
            case COLOR -> COLOR;
            case TEXT -> TEXT;
            case WORDS -> WORDS;
            case FLAG -> FLAG;
            case WORD -> new OfWord(one.type());
        };
    }

    /** What an attribute has that is not given. */
    static Object standard(Described one) {
        String otherwise = one.says().otherwise();
        return !otherwise.equals(Attribute.NOTHING) ? of(one).of(otherwise)
                : one.type() == OptionalDouble.class ? OptionalDouble.empty() : one.type() == List.class ? List.of() : Slot.NONE;
    }
}
