package cz.paprsek.format.openscad;

import java.util.List;

/** What an argument says. */
sealed interface Value {
    /** A number, which may be endless or none. */
    record Num(double number) implements Value {}

    record Text(String text) implements Value {}

    record Flag(boolean isTrue) implements Value {}

    /** Numbers or other lists. */
    record Vec(List<Value> values) implements Value {}

    /** Nothing: {@code undef}. */
    record Undefined() implements Value {}
}
