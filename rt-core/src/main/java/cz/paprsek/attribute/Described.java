package cz.paprsek.attribute;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.Stream;

/**
 * An attribute of a record.
 *
 * @param name as in a file
 * @param within the component whose value is the record that has the attribute; none if it is the record itself
 * @param components the one that has the value, or the two that have its two numbers
 * @param says all that is said of it
 */
public record Described(String name, List<RecordComponent> within, List<RecordComponent> components, Attribute says) {
    private static final ClassValue<List<Described>> OWN = new ClassValue<>() {
        @Override
        protected List<Described> computeValue(Class<?> type) {
            List<Described> all = new ArrayList<>();
            for (RecordComponent component : componentsOf(type)) {
                Attribute says = component.getAnnotation(Attribute.class);
                Described before = all.isEmpty() ? null : all.get(all.size() - 1);
                if (says == null || says.isElement()) {
                    continue;
                }
                if (before != null && before.name.equals(says.name())) {
                    all.set(all.size() - 1, new Described(before.name, List.of(), List.of(before.component(), component), before.says));
                } else {
                    all.add(new Described(says.name().isEmpty() ? name(component) : says.name(), List.of(), List.of(component), says));
                }
            }
            return List.copyOf(all);
        }
    };
    private static final ClassValue<List<Described>> INLINE = new ClassValue<>() {
        @Override
        protected List<Described> computeValue(Class<?> type) {
            if (!type.isRecord()) {
                return List.of();
            }
            return Arrays.stream(componentsOf(type)).flatMap(component -> Stream.concat(
                    of(type).stream().filter(one -> one.component().getName().equals(component.getName())),
                    kindsWithin(component).flatMap(kind -> of(kind).stream())
                            .map(one -> new Described(one.name, List.of(component), one.components, one.says)))).toList();
        }
    };

    public Described {
        within = List.copyOf(within);
        components = List.copyOf(components);
        // Who may call is not looked up for each value then.
        components.forEach(component -> component.getAccessor().trySetAccessible());
    }

    /** Those of a record, in the order of its components, which is that of files. */
    public static List<Described> of(Class<?> type) {
        return OWN.get(type);
    }

    /** What stands in elements of its own, each with one value, in those of a record. */
    public static List<Described> elements(Class<?> type) {
        return Arrays.stream(componentsOf(type)).flatMap(component -> Optional.ofNullable(component.getAnnotation(Attribute.class)).filter(Attribute::isElement)
                .map(says -> new Described(name(component), List.of(), List.of(component), says)).stream()).toList();
    }

    /**
     * As {@link #of}, and in their places those of records that are components but no elements. Of these there may be several kinds, of which a
     * record has one: a camera has a direction or a target, without a word which, and the lens that the word of its own attribute says.
     */
    public static List<Described> inline(Class<?> type) {
        return INLINE.get(type);
    }

    private static RecordComponent[] componentsOf(Class<?> type) {
        return Objects.requireNonNull(type.getRecordComponents(), type + " is no record");
    }

    /** The kinds whose attributes stand beside those of the record: not if the component is an attribute, other than one that says which kind it is. */
    private static Stream<Class<?>> kindsWithin(RecordComponent component) {
        Attribute says = component.getAnnotation(Attribute.class);
        // What is an element has its attributes there.
        return component.getType().isAnnotationPresent(Element.class) ? Stream.empty() : says == null || (says.value() == Kind.WORD && component.getType().isSealed()) ? kinds(component.getType()) : Stream.empty();
    }

    private static Stream<Class<?>> kinds(Class<?> type) {
        if (type.isRecord()) {
            return type.isAnnotationPresent(Element.class) ? Stream.empty() : Stream.of(type);
        }
        return type.isSealed() ? Arrays.stream(type.getPermittedSubclasses()).flatMap(Described::kinds) : Stream.empty();
    }

    /** The name of a component as files and tables have it: {@code refractive-index}. */
    public static String name(RecordComponent component) {
        return ElementTable.hyphenated(component.getName());
    }

    /** The values of a record's components, by their names as files have them. */
    public static Map<String, Object> values(Record record) {
        Map<String, Object> values = new LinkedHashMap<>();
        for (RecordComponent component : componentsOf(record.getClass())) {
            values.put(name(component), get(component, record));
        }
        return values;
    }

    /** A constant of an enumeration, or the kind of a record, as files have it. */
    public static String word(Object value) {
        return value instanceof Enum<?> constant ? constant.name().toLowerCase(Locale.ROOT).replace('_', '-')
                : ElementTable.hyphenated(value.getClass().getSimpleName());
    }

    /** All words that an attribute may have, with what each stands for: a constant of an enumeration, or the class of a record. */
    public static Map<String, Object> words(Class<?> type) {
        Map<String, Object> words = new LinkedHashMap<>();
        if (type.isEnum()) {
            Arrays.stream(type.getEnumConstants()).forEach(constant -> words.put(word(constant), constant));
        } else {
            kinds(type).forEach(kind -> words.put(ElementTable.hyphenated(kind.getSimpleName()), kind));
        }
        return words;
    }

    /** Its numbers apart, each by the name of its own component; itself if it is one. */
    public List<Described> apart() {
        return components.size() == 1 ? List.of(this) : components.stream()
                .map(one -> new Described(name(one), within, List.of(one), Objects.requireNonNullElse(one.getAnnotation(Attribute.class), says))).toList();
    }

    /** The component that has the value, or its first number. */
    public RecordComponent component() {
        return components.get(0);
    }

    /** What all values are: a number, a vector, a colour, a text, an enumeration …; numbers in an array if there are two components. */
    public Class<?> type() {
        return components.size() == 1 ? component().getType() : double[].class;
    }

    /** Whether a record has it: not if it is of another kind of what is within. */
    public boolean isOf(Object record) {
        return within.isEmpty() || get(within.get(0), record).getClass() == component().getDeclaringRecord();
    }

    /** The value that a record has. */
    public Object value(Object record) {
        Object owner = within.isEmpty() ? record : get(within.get(0), record);
        return components.size() == 1 ? get(component(), owner)
                : components.stream().mapToDouble(component -> ((Number) get(component, owner)).doubleValue()).toArray();
    }

    /**
     * What counts for a record, for people and programs who want to know how it is and not how it was written; empty if nothing does, or if the
     * record is of another kind.
     */
    public Optional<Object> inForce(Object record) {
        if (!isOf(record)) {
            return Optional.empty();
        }
        Object value = says.inForce().isEmpty() ? value(record) : get(method(record), record);
        return value instanceof Boolean counts && type() != boolean.class ? (counts ? Optional.of(value(record)) : Optional.empty())
                : value instanceof OptionalDouble number ? (number.isPresent() ? Optional.of(number.getAsDouble()) : Optional.empty())
                : value instanceof OptionalInt number ? (number.isPresent() ? Optional.of(number.getAsInt()) : Optional.empty())
                : value instanceof Double number && number.isInfinite() ? Optional.empty() : Optional.of(value);
    }

    private Method method(Object record) {
        try {
            return record.getClass().getMethod(says.inForce());
        } catch (NoSuchMethodException e) {
            throw new IllegalStateException(record.getClass() + " does not say what counts of " + name, e);
        }
    }

    private static Object get(RecordComponent component, Object record) {
        return get(component.getAccessor(), record);
    }

    private static Object get(Method getter, Object record) {
        try {
            return Objects.requireNonNull(getter.invoke(record), getter.getName());
        } catch (IllegalAccessException | InvocationTargetException e) {
            throw new IllegalStateException("a record does not give out what it has: " + getter, e);
        }
    }

    public boolean isNumber() {
        return type() == double.class || type() == int.class;
    }

    public boolean isRequired() {
        return says.otherwise().isEmpty();
    }

    /** Whether it may be missing and then has no value. */
    public boolean isOptional() {
        return says.otherwise().equals(Attribute.NOTHING);
    }
}
