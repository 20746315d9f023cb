package cz.paprsek.xml.quick;

import cz.paprsek.attribute.Described;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;

/** What stands at the components of a record: which attributes it is made of, and how. */
final class RecordForm<R extends Record> {
    private static final int NO_ATTRIBUTE = -1;
    private static final int WHOLE = -1;

    private final Constructor<R> constructor;
    private final List<Slot> slots;
    /** For each component, which attribute has its value. */
    private final int[] places;
    /** For each component, which of the two numbers of its attribute it has; −1 if it has the whole value. */
    private final int[] numbers;
    private final Class<?>[] types;

    RecordForm(Class<R> type) {
        RecordComponent[] components = type.getRecordComponents();
        List<Described> described = Described.of(type);
        slots = described.stream().map(Slot::of).toList();
        places = new int[components.length];
        numbers = new int[components.length];
        Arrays.fill(places, NO_ATTRIBUTE);
        for (int i = 0; i < components.length; i++) {
            for (int j = 0; j < described.size(); j++) {
                List<String> names = described.get(j).components().stream().map(RecordComponent::getName).toList();
                int number = names.indexOf(components[i].getName());
                if (number >= 0) {
                    places[i] = j;
                    numbers[i] = names.size() > 1 ? number : WHOLE;
                }
            }
        }
        types = Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new);
        try {
            constructor = type.getConstructor(types);
            // It is public; whether it may be called is then not asked each time.
            constructor.setAccessible(true);
        } catch (NoSuchMethodException e) {
            throw new IllegalStateException("every record has this constructor", e);
        }
    }

    /** In the order of the components. */
    List<Slot> slots() {
        return slots;
    }

    /**
     * Makes the record.
     *
     * @param values of the attributes, among those of others
     * @param from where they begin
     * @param others the values of components that are no attributes, in their order
     * @throws Unusual if the record refuses
     */
    R make(Object[] values, int from, Object... others) {
        Object[] arguments = new Object[places.length];
        int other = 0;
        for (int i = 0; i < arguments.length; i++) {
            arguments[i] = places[i] == NO_ATTRIBUTE ? others[other++]
                    : numbers[i] == WHOLE ? values[from + places[i]] : number(((double[]) values[from + places[i]])[numbers[i]], types[i]);
        }
        try {
            return constructor.newInstance(arguments);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof IllegalArgumentException) {
                throw new Unusual();
            }
            throw new IllegalStateException("a record failed: " + e.getCause(), e);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("a record is not to be made as its components say", e);
        }
    }

    private static Object number(double value, Class<?> type) {
        // Not a choice between the two: that would be a double either way.
        if (type == int.class) {
            return (int) value;
        }
        return value;
    }

    /** Whether no value is given. */
    boolean isUntouched(Object[] values, int from) {
        for (int i = 0; i < slots.size(); i++) {
            if (!isUntouched(values, from, i)) {
                return false;
            }
        }
        return true;
    }

    /** Whether the value of one of the attributes is not given. */
    boolean isUntouched(Object[] values, int from, int slot) {
        return values[from + slot] == slots.get(slot).otherwise();
    }

    /** Whether all values are what they are if they are not given. */
    boolean isStandard(Object[] values, int from) {
        for (int i = 0; i < slots.size(); i++) {
            if (!slots.get(i).otherwise().equals(values[from + i])) {
                return false;
            }
        }
        return true;
    }
}
