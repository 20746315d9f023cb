package cz.paprsek.fx.model.property;

import cz.paprsek.attribute.Described;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/** Reads and replaces components of records by name. */
final class Records {
    /** Found once for each record: asking Java anew each time takes microseconds, and a sheet of ten thousand things asks often. */
    private static final ClassValue<List<RecordComponent>> COMPONENTS = new ClassValue<>() {
        @Override
        protected List<RecordComponent> computeValue(Class<?> type) {
            return List.of(Objects.requireNonNull(type.getRecordComponents(), () -> type + " is no record"));
        }
    };
    /** The attributes that say themselves what counts of them. */
    private static final ClassValue<List<Described>> IN_FORCE = new ClassValue<>() {
        @Override
        protected List<Described> computeValue(Class<?> type) {
            return Described.of(type).stream().filter(one -> !one.says().inForce().isEmpty()).toList();
        }
    };

    private Records() {}

    /** The components of a record, in order. */
    static List<RecordComponent> components(Class<?> type) {
        return COMPONENTS.get(type);
    }

    /** The component of the given name; empty if the record has none. */
    static Optional<RecordComponent> component(Class<?> type, String name) {
        for (RecordComponent component : components(type)) {
            if (component.getName().equals(name)) {
                return Optional.of(component);
            }
        }
        return Optional.empty();
    }

    /** The value of a component. */
    static Object get(Record record, RecordComponent component) {
        try {
            return Objects.requireNonNull(component.getAccessor().invoke(record), component.getName());
        } catch (IllegalAccessException | InvocationTargetException e) {
            throw new IllegalStateException("cannot read " + component, e);
        }
    }

    /** What stands in for a value that means none given; itself if nothing does, to say that nothing does. */
    static Object counting(Record record, RecordComponent component) {
        Object own = get(record, component);
        for (Described one : IN_FORCE.get(record.getClass())) {
            if (one.component().getName().equals(component.getName())) {
                return one.inForce(record).orElse(own);
            }
        }
        return own;
    }

    /**
     * The record with one component replaced.
     *
     * @throws IllegalArgumentException with the record's own sentence if it refuses the value
     */
    static Record with(Record record, String name, Object value) {
        List<RecordComponent> components = components(record.getClass());
        Class<?>[] types = components.stream().map(RecordComponent::getType).toArray(Class<?>[]::new);
        Object[] values = components.stream()
                .map(component -> component.getName().equals(name) ? value : get(record, component)).toArray();
        try {
            Constructor<? extends Record> constructor = record.getClass().getDeclaredConstructor(types);
            return constructor.newInstance(values);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof IllegalArgumentException refused) {
                throw refused;
            }
            throw new IllegalStateException("cannot make " + record.getClass(), e);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("cannot make " + record.getClass() + " of " + Arrays.toString(values), e);
        }
    }
}
