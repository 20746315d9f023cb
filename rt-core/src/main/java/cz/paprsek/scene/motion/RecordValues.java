package cz.paprsek.scene.motion;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

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
