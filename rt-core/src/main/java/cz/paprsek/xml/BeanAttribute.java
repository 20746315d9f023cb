package cz.paprsek.xml;

import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import java.lang.reflect.Field;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.StringTokenizer;
import org.jspecify.annotations.Nullable;

/** An attribute as the annotations of a bean's field tell it. */
final class BeanAttribute {
    private final byte[] name;
    private final Field field;
    private final boolean isRequired;
    private final Adapters.@Nullable Reading<?> adapter;
    private final double[] numbers = new double[3];

    BeanAttribute(byte[] name, Field field, boolean isRequired) {
        this.name = name;
        this.field = field;
        this.isRequired = isRequired;
        XmlJavaTypeAdapter adapted = field.getAnnotation(XmlJavaTypeAdapter.class);
        adapter = adapted == null ? null : adapter(adapted.value());
    }

    private static Adapters.Reading<?> adapter(Class<?> type) {
        try {
            return (Adapters.Reading<?>) type.getDeclaredConstructor().newInstance();
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("an adapter needs a constructor without arguments", e);
        }
    }

    byte[] name() {
        return name;
    }

    boolean isRequired() {
        return isRequired;
    }

    /**
     * Sets the field of a bean to the value of the attribute at hand.
     *
     * @throws IllegalArgumentException if it has the wrong form
     */
    void read(Object bean, Markup markup) throws IllegalAccessException {
        if (adapter instanceof Adapters.Color color && markup.isWord()) {
            field.set(bean, color.unmarshal(markup.value()));
        } else if (adapter != null) {
            field.set(bean, adapter.of(Arrays.copyOf(numbers, markup.numbers(numbers))));
        } else if (field.getType() == double.class) {
            if (markup.numbers(numbers) != 1) {
                throw new Unusual();
            }
            field.setDouble(bean, numbers[0]);
        } else if (field.getType() == int.class) {
            field.setInt(bean, wholeNumber(markup.value()));
        } else if (field.getType() == String.class) {
            field.set(bean, text(markup.value()));
        } else if (field.getType() == List.class) {
            field.set(bean, Collections.list(new StringTokenizer(markup.value())));
        } else {
            throw new IllegalStateException("no way to read an attribute into " + field);
        }
    }

    /** Not blanks around it, nor digits of other scripts. */
    private static int wholeNumber(String text) {
        if (!text.chars().allMatch(c -> c < 128)) {
            throw new Unusual();
        }
        return Integer.parseInt(text);
    }

    /** A text that is given is not empty. */
    private static String text(String value) {
        if (value.isEmpty()) {
            throw new Unusual();
        }
        return value;
    }
}
