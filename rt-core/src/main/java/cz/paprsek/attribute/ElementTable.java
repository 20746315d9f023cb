package cz.paprsek.attribute;

import java.util.Arrays;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/** The elements of scene files that records are. */
public final class ElementTable {
    private static final ClassValue<String> NAMES = new ClassValue<>() {
        @Override
        protected String computeValue(Class<?> record) {
            return says(record).map(Element::name).filter(name -> !name.isEmpty()).orElseGet(() -> hyphenated(record.getSimpleName()));
        }
    };

    private ElementTable() {}

    /** The records that are elements: of a sealed interface all that it permits, in its order; of a record itself. */
    public static Stream<Class<? extends Record>> of(Class<?> type) {
        if (type.isRecord()) {
            return type.isAnnotationPresent(Element.class) ? Stream.of(type.asSubclass(Record.class)) : Stream.empty();
        }
        return type.isSealed() ? Arrays.stream(type.getPermittedSubclasses()).flatMap(ElementTable::of) : Stream.empty();
    }

    /** The name of a record's element: {@code point-light}. */
    public static String name(Class<?> record) {
        return NAMES.get(Objects.requireNonNull(record, "record"));
    }

    /** What the element is, in a sentence. */
    public static String means(Class<?> record) {
        return says(record).map(Element::value).orElseThrow(() -> new IllegalArgumentException(record + " is no element"));
    }

    private static Optional<Element> says(Class<?> record) {
        return Optional.ofNullable(Objects.requireNonNull(record, "record").getAnnotation(Element.class));
    }

    /** {@code refractiveIndex} and {@code RefractiveIndex} as files have them: {@code refractive-index}. */
    public static String hyphenated(String name) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < name.length(); i++) {
            char letter = name.charAt(i);
            if (i > 0 && letter >= 'A' && letter <= 'Z') {
                text.append('-');
            }
            text.append(letter);
        }
        return text.toString().toLowerCase(Locale.ROOT);
    }
}
