package cz.paprsek.xml;

import java.lang.reflect.Field;
import java.util.Collection;

/** An element within another, as the annotations of a bean's field tell it. */
final class BeanElement {
    private final byte[] name;
    private final int number;
    private final Field field;
    private final Class<?> bound;
    private final boolean isMany;

    /**
     * @param number that of the field, from 0; several elements can go into one
     * @param bound what the element is bound to: a bean or a text
     */
    BeanElement(byte[] name, int number, Field field, Class<?> bound) {
        this.name = name;
        this.number = number;
        this.field = field;
        this.bound = bound;
        isMany = Collection.class.isAssignableFrom(field.getType());
    }

    byte[] name() {
        return name;
    }

    int number() {
        return number;
    }

    Class<?> bound() {
        return bound;
    }

    /** Whether there may be several. */
    boolean isMany() {
        return isMany;
    }

    boolean isText() {
        return bound == String.class;
    }

    /** Puts what was read into the bean. */
    @SuppressWarnings("unchecked") // The annotations say so.
    void put(Object bean, Object value) throws IllegalAccessException {
        if (isMany) {
            ((Collection<Object>) field.get(bean)).add(value);
        } else {
            field.set(bean, value);
        }
    }
}
