package cz.paprsek.fx.model.property;

import java.util.List;

/**
 * How a value is shown and changed, beyond what its type tells.
 *
 * @param kind what shows it
 * @param unit what it counts
 * @param least the least value that dragging and stepping lead to; what is typed is judged by the record alone
 * @param most the greatest such value
 * @param step by how much a step changes it; 0 for a step that fits the value's size
 * @param presets values with a name
 */
public record Trait(Kind kind, Unit unit, double least, double most, double step, List<Preset> presets) {

    /** What shows a value. */
    public enum Kind {
        /** A number. */
        NUMBER,
        /** A whole number. */
        WHOLE,
        /** A number from 0 to 1. */
        SHARE,
        /** Three numbers. */
        VECTOR,
        /** Three factors, which can be changed together. */
        FACTORS,
        /** A colour. */
        COLOR,
        /** True or false. */
        FLAG,
        /** A line of text. */
        TEXT,
        /** One of the fonts that are shipped, or of a file. */
        FONT,
        /** Words separated by blanks. */
        WORDS,
        /** The name of a picture's file, relative to the scene's folder. */
        FILE,
        /** Colours at places from 0 to 1. */
        STOPS,
        /** One of the constants of an enumeration. */
        CONSTANT,
        /** One of the kinds of record that a sealed interface permits. */
        ALTERNATIVE,
        /** Where a material comes from. */
        MATERIAL
    }

    /** What a number counts. */
    public enum Unit { NONE, DEGREES, PIXELS }

    /**
     * A value with a name.
     *
     * @param name the key of its text
     * @param value the value
     */
    public record Preset(String name, double value) {}

    public Trait {
        presets = List.copyOf(presets);
    }

    static Trait of(Kind kind) {
        return new Trait(kind, Unit.NONE, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, 0, List.of());
    }

    static Trait share() {
        return of(Kind.SHARE).range(0, 1).stepping(0.05);
    }

    Trait range(double from, double to) {
        return new Trait(kind, unit, from, to, step, presets);
    }

    Trait in(Unit value) {
        return new Trait(kind, value, least, most, step, presets);
    }

    Trait stepping(double by) {
        return new Trait(kind, unit, least, most, by, presets);
    }

    Trait with(Preset... values) {
        return new Trait(kind, unit, least, most, step, List.of(values));
    }

    /** The value nearest to the given one that dragging and stepping lead to. */
    public double clamp(double value) {
        return Math.max(least, Math.min(most, value));
    }
}
