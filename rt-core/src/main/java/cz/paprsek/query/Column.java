package cz.paprsek.query;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A column of a table: a name, a type, and how a row's values are read. A row may have any number of values in a column; a scene has as many
 * tags as it likes.
 *
 * @param <R> the row
 */
public final class Column<R> {
    private final String name;
    private final Type type;
    private final Values<R> values;

    /** How the values of a row are read. */
    @FunctionalInterface
    interface Values<R> {
        /** Whether one of the row's values passes the test; no more values are read than it takes to know. */
        boolean any(R row, Predicate<Value> test);
    }

    Column(String name, Type type, Values<R> values) {
        this.name = name;
        this.type = type;
        this.values = values;
    }

    /** The same values under another name. */
    Column<R> named(String other) {
        return new Column<>(other, type, values);
    }

    public static <R> Column<R> number(String name, ToDoubleFunction<R> value) {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(value, "value");
        return new Column<>(name, Type.NUMBER, (row, test) -> test.test(new Value.Scalar(value.applyAsDouble(row))));
    }

    /** For rows that may have none. */
    public static <R> Column<R> numbers(String name, Function<R, OptionalDouble> value) {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(value, "value");
        return new Column<>(name, Type.NUMBER, (row, test) -> {
            OptionalDouble number = value.apply(row);
            return number.isPresent() && test.test(new Value.Scalar(number.getAsDouble()));
        });
    }

    public static <R> Column<R> text(String name, Function<R, String> value) {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(value, "value");
        return new Column<>(name, Type.TEXT, (row, test) -> test.test(new Value.Text(value.apply(row))));
    }

    public static <R> Column<R> texts(String name, Function<R, List<String>> value) {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(value, "value");
        return new Column<>(name, Type.TEXT, (row, test) -> value.apply(row).stream().anyMatch(text -> test.test(new Value.Text(text))));
    }

    public static <R> Column<R> vector(String name, Function<R, Vec3> value) {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(value, "value");
        return new Column<>(name, Type.VECTOR, (row, test) -> test.test(new Value.Triple(value.apply(row))));
    }

    /** For rows that may have none. */
    public static <R> Column<R> vectors(String name, Function<R, Optional<Vec3>> value) {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(value, "value");
        return new Column<>(name, Type.VECTOR, (row, test) -> value.apply(row).filter(vector -> test.test(new Value.Triple(vector))).isPresent());
    }

    public static <R> Column<R> color(String name, Function<R, Optional<Rgb>> value) {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(value, "value");
        return new Column<>(name, Type.COLOR, (row, test) -> value.apply(row)
                .filter(color -> test.test(new Value.Triple(new Vec3(color.red(), color.green(), color.blue())))).isPresent());
    }

    public String name() {
        return name;
    }

    public Type type() {
        return type;
    }

    /** What a table shows of a row: the value, nothing if there is none, several with blanks between. */
    public Value cell(R row) {
        List<Value> all = new ArrayList<>(1);
        values.any(row, value -> {
            all.add(value);
            return false;
        });
        return all.isEmpty() ? Value.Nothing.NOTHING
                : all.size() == 1 ? all.get(0)
                : new Value.Text(all.stream().map(Value::text).collect(Collectors.joining(" ")));
    }

    /** Whether one of the row's values passes the test. */
    boolean any(R row, Predicate<Value> test) {
        return values.any(row, test);
    }

    /** This column for rows that are something else, each of which leads to any number of rows of this table. */
    public <P> Column<P> through(Function<P, Stream<R>> rows) {
        Objects.requireNonNull(rows, "rows");
        return new Column<>(name, type, (row, test) -> rows.apply(row).anyMatch(far -> values.any(far, test)));
    }

    /** One of the three numbers of every value, as a column of its own: {@code position.x}. */
    Optional<Column<R>> part(String part) {
        int place = type.parts().indexOf(part);
        return place < 0 ? Optional.empty() : Optional.of(new Column<>(name + "." + part, Type.NUMBER,
                (row, test) -> values.any(row, value -> test.test(new Value.Scalar(((Value.Triple) value).part(place))))));
    }

    /** What the values of a column are. */
    public enum Type {
        NUMBER("a number"),
        TEXT("text"),
        /** Three numbers, x y z. */
        VECTOR("three numbers"),
        /** Three numbers 0–255, red green blue. */
        COLOR("a color");

        private final String words;

        Type(String words) {
            this.words = words;
        }

        /** The type in words, for a sentence: {@code a number}. */
        public String words() {
            return words;
        }

        /** The names of the numbers that such a value has in it; none if it is no more than one. */
        public List<String> parts() {
            return switch (this) {
                case NUMBER, TEXT -> List.of();
                case VECTOR -> List.of("x", "y", "z");
                case COLOR -> List.of("red", "green", "blue");
            };
        }
    }
}
