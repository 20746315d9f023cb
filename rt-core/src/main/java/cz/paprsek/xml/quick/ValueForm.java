package cz.paprsek.xml.quick;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.xml.format.ColorWords;
import java.util.Collections;
import java.util.StringTokenizer;

/** The forms that the values of attributes have. */
enum ValueForm {
    NUMBER {
        @Override
        Object of(double[] n, int count) {
            Unusual.unless(count == 1);
            return n[0];
        }
    },
    WHOLE {
        @Override
        Object of(double[] n, int count) {
            return (int) n[0];
        }

        /** Not blanks around it, nor digits of other scripts. */
        @Override
        Object read(Markup markup, double[] room) {
            String text = markup.value();
            Unusual.unless(text.chars().allMatch(c -> c < 128));
            return Integer.parseInt(text);
        }
    },
    VECTOR {
        @Override
        Object of(double[] n, int count) {
            Unusual.unless(count == 3);
            return new Vec3(n[0], n[1], n[2]);
        }
    },
    /** One for all axes, or three. */
    SCALE {
        @Override
        Object of(double[] n, int count) {
            return count == 1 ? new Vec3(n[0], n[0], n[0]) : VECTOR.of(n, count);
        }
    },
    COLOR {
        @Override
        Object of(double[] n, int count) {
            Unusual.unless(count == 3);
            return new Rgb(n[0], n[1], n[2]);
        }

        @Override
        Object read(Markup markup, double[] room) {
            return markup.isWord() ? ColorWords.of(markup.value().strip()) : super.read(markup, room);
        }
    },
    /** Two numbers, in an array. */
    PAIR {
        @Override
        Object of(double[] n, int count) {
            Unusual.unless(count == 2);
            return new double[] {n[0], n[1]};
        }
    },
    /** Not empty if it is given. */
    TEXT {
        @Override
        Object of(double[] n, int count) {
            throw new IllegalStateException("a text is not made of numbers");
        }

        @Override
        Object read(Markup markup, double[] room) {
            String text = markup.value();
            Unusual.unless(!text.isEmpty());
            return text;
        }
    },
    /** Any number of them, in a list. */
    WORDS {
        @Override
        Object of(double[] n, int count) {
            throw new IllegalStateException("words are not made of numbers");
        }

        @Override
        Object read(Markup markup, double[] room) {
            return Collections.list(new StringTokenizer(markup.value()));
        }
    };

    /** @throws IllegalArgumentException if there are too few or too many, or the value does not take them */
    abstract Object of(double[] numbers, int count);

    /**
     * The value of the attribute at hand.
     *
     * @param room for three numbers
     * @throws IllegalArgumentException if it has another form
     */
    Object read(Markup markup, double[] room) {
        return of(room, markup.numbers(room));
    }

    /** The form of a record's component. */
    static ValueForm of(Described one) {
        Class<?> type = one.component().getType();
        if (type == double.class) {
            return NUMBER;
        } else if (type == int.class) {
            return WHOLE;
        } else if (type == Vec3.class) {
            return one.says().value() == Kind.SCALE ? SCALE : VECTOR;
        } else if (type == Rgb.class) {
            return COLOR;
        }
        throw new IllegalStateException("no way to read an attribute into " + one.component());
    }
}
