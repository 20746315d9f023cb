package cz.paprsek.attribute;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.stream.Stream;

/**
 * An attribute of a record.
 *
 * @param name as in a file
 * @param component what has the value
 * @param says all that is said of it
 */
public record Described(String name, RecordComponent component, Attribute says) {
    private static final ClassValue<List<Described>> ALL = new ClassValue<>() {
        @Override
        protected List<Described> computeValue(Class<?> type) {
            return Arrays.stream(Objects.requireNonNull(type.getRecordComponents(), type + " is no record")).flatMap(component ->
                    Stream.ofNullable(component.getAnnotation(Attribute.class)).map(says -> new Described(name(component), component, says))).toList();
        }
    };

    /** Those of a record, in the order of its components, which is that of files. */
    public static List<Described> of(Class<?> type) {
        return ALL.get(type);
    }

    /** The name of a component as files and tables have it: {@code refractive-index}. */
    public static String name(RecordComponent component) {
        return component.getName().replaceAll("([A-Z])", "-$1").toLowerCase(Locale.ROOT);
    }

    /** The value that a record has: a number, a vector, a colour or a text. */
    public Object value(Object record) {
        try {
            return Objects.requireNonNull(component.getAccessor().invoke(record), name);
        } catch (IllegalAccessException | InvocationTargetException e) {
            throw new IllegalStateException("a record does not give out what it has: " + component, e);
        }
    }

    /** Of a component that holds one number: that number. */
    public double number(Object record) {
        return ((Number) value(record)).doubleValue();
    }

    public boolean isNumber() {
        return component.getType() == double.class || component.getType() == int.class;
    }

    public boolean isRequired() {
        return says.otherwise().isEmpty();
    }
}
