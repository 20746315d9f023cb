package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.model.edit.Arranging.Axis;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What is typed while something is moved, turned or scaled: an axis and a number, such as "x 2".
 *
 * @param axis empty as long as none has been named
 * @param text the number so far
 */
record TypedAmount(Optional<Axis> axis, String text) {
    static final TypedAmount NONE = new TypedAmount(Optional.empty(), "");
    private static final int LONGEST = 12;

    boolean isNone() {
        return axis.isEmpty() && text.isEmpty();
    }

    TypedAmount along(Axis value) {
        return new TypedAmount(Optional.of(value), text);
    }

    /** With another character, if it goes on with a number; a minus may be typed at any time. */
    TypedAmount with(char typed) {
        if (typed == '-' || typed == '−') {
            return new TypedAmount(axis, text.startsWith("-") ? text.substring(1) : "-" + text);
        }
        char next = typed == ',' ? '.' : typed;
        boolean fits = (next >= '0' && next <= '9') || (next == '.' && text.indexOf('.') < 0);
        return fits && text.length() < LONGEST ? new TypedAmount(axis, text + next) : this;
    }

    /** Without the last character; without the axis if there is none. */
    TypedAmount shorter() {
        return text.isEmpty() ? NONE : new TypedAmount(axis, text.substring(0, text.length() - 1));
    }

    OptionalDouble value() {
        try {
            return OptionalDouble.of(Double.parseDouble(text));
        } catch (NumberFormatException notYet) {
            return OptionalDouble.empty();
        }
    }
}
