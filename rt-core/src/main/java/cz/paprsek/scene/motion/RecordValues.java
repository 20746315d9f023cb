package cz.paprsek.scene.motion;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.text.Numbers;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;

/** Records with other numbers at some of their attributes. */
public final class RecordValues {
    private RecordValues() {}

    /**
     * The record with all of these at once.
     *
     * @throws IllegalArgumentException with the record's own sentence if it refuses
     */
    public static Record with(Record record, Map<Described, double[]> values) {
        RecordComponent[] components = record.getClass().getRecordComponents();
        List<String> names = Arrays.stream(components).map(RecordComponent::getName).toList();
        Object[] arguments = Arrays.stream(components).map(component -> get(component, record)).toArray();
        values.forEach((one, numbers) -> {
            if (one.within().isEmpty()) {
                for (int i = 0; i < one.components().size(); i++) {
                    int at = names.indexOf(one.components().get(i).getName());
                    arguments[at] = value(components[at].getType(), one.components().size() == 1 ? numbers : new double[] {numbers[i]});
                }
            } else {
                int at = names.indexOf(one.within().get(0).getName());
                arguments[at] = with((Record) arguments[at], Map.of(new Described(one.name(), List.of(), one.components(), one.says()), numbers));
            }
        });
        try {
            return record.getClass().getConstructor(Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new)).newInstance(arguments);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof IllegalArgumentException refused) {
                throw refused;
            }
            throw new IllegalStateException("a record failed: " + e.getCause(), e);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("a record is not to be made as its components say", e);
        }
    }

    /** A value as it is in a key; empty for none, and for one without end. */
    public static Optional<String> text(Object value) {
        double[] numbers = value instanceof Vec3 v ? new double[] {v.x(), v.y(), v.z()} : value instanceof Rgb c ? new double[] {c.red(), c.green(), c.blue()}
                : value instanceof OptionalDouble one ? one.stream().toArray() : value instanceof double[] pair ? pair : new double[] {((Number) value).doubleValue()};
        return numbers.length == 0 || !Arrays.stream(numbers).allMatch(Double::isFinite) ? Optional.empty()
                : Optional.of(Arrays.stream(numbers).mapToObj(Numbers::text).collect(Collectors.joining(" ")));
    }

    private static Object get(RecordComponent component, Record record) {
        try {
            return component.getAccessor().invoke(record);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("a record does not give out what it has: " + component, e);
        }
    }

    private static Object value(Class<?> type, double[] numbers) {
        if (type == Vec3.class) {
            return numbers.length == 1 ? new Vec3(numbers[0], numbers[0], numbers[0]) : new Vec3(numbers[0], numbers[1], numbers[2]);
        }
        if (type == Rgb.class) {
            return new Rgb(numbers[0], numbers[1], numbers[2]);
        }
        if (type == OptionalDouble.class) {
            return OptionalDouble.of(numbers[0]);
        }
        // Not a choice between the two: that would be a double either way.
        if (type == int.class) {
            return (int) Math.rint(numbers[0]);
        }
        return numbers[0];
    }
}
