package cz.paprsek.xml;

import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlElements;
import jakarta.xml.bind.annotation.XmlType;
import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.ParameterizedType;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * What the annotations of a bean say of its element: the attributes and the elements inside, in the order of the fields, those of base classes
 * first.
 */
final class BeanType {
    /** How JAXB spells that a name is that of the field. */
    private static final String OF_THE_FIELD = "##default";

    /** All there are, by class: types may hold each other. */
    private final Map<Class<?>, BeanType> all;
    private final Constructor<?> constructor;
    private final List<BeanAttribute> attributes = new ArrayList<>();
    private final List<BeanElement> elements = new ArrayList<>();
    private final long required;
    private final boolean isInAnyOrder;
    private int latest;

    private BeanType(Class<?> bean, Map<Class<?>, BeanType> all) throws NoSuchMethodException {
        this.all = all;
        all.put(bean, this);
        constructor = bean.getDeclaredConstructor();
        XmlType type = bean.getAnnotation(XmlType.class);
        isInAnyOrder = type != null && type.propOrder().length == 0;
        addFields(bean);
        long needed = 0;
        for (int i = 0; i < attributes.size(); i++) {
            needed |= attributes.get(i).isRequired() ? 1L << i : 0;
        }
        required = needed;
    }

    static BeanType of(Class<?> bean) {
        return of(bean, new HashMap<>());
    }

    private static BeanType of(Class<?> bean, Map<Class<?>, BeanType> all) {
        BeanType known = all.get(bean);
        try {
            return known != null ? known : new BeanType(bean, all);
        } catch (NoSuchMethodException e) {
            throw new IllegalStateException("a bean needs a constructor without arguments", e);
        }
    }

    /** The type of an element that may stand inside, or further inside. */
    BeanType of(BeanElement element) {
        return of(element.bound(), all);
    }

    private void addFields(Class<?> bean) {
        if (bean.getSuperclass() != Object.class) {
            addFields(bean.getSuperclass());
        }
        for (Field field : bean.getDeclaredFields()) {
            XmlAttribute attribute = field.getAnnotation(XmlAttribute.class);
            XmlElement element = field.getAnnotation(XmlElement.class);
            XmlElements several = field.getAnnotation(XmlElements.class);
            int number = elements.isEmpty() ? 0 : elements.get(elements.size() - 1).number() + 1;
            if (attribute != null) {
                attributes.add(new BeanAttribute(name(attribute.name(), field), field, attribute.required()));
            } else if (element != null) {
                addElement(element, field, number);
            } else if (several != null) {
                for (XmlElement one : several.value()) {
                    addElement(one, field, number);
                }
            }
        }
    }

    private void addElement(XmlElement element, Field field, int number) {
        Class<?> bound = element.type() != XmlElement.DEFAULT.class ? element.type()
                : field.getGenericType() instanceof ParameterizedType list ? (Class<?>) list.getActualTypeArguments()[0] : field.getType();
        elements.add(new BeanElement(name(element.name(), field), number, field, bound));
    }

    private static byte[] name(String given, Field field) {
        return (given.equals(OF_THE_FIELD) ? field.getName() : given).getBytes(StandardCharsets.US_ASCII);
    }

    Object create() throws ReflectiveOperationException {
        return constructor.newInstance();
    }

    /** By number, from 0; at most 64. */
    List<BeanAttribute> attributes() {
        return attributes;
    }

    /** A bit for each attribute that must be there. */
    long required() {
        return required;
    }

    /** Whether elements inside may come in any order, not only in that of the fields. */
    boolean isInAnyOrder() {
        return isInAnyOrder;
    }

    /** The element inside whose tag is at hand. */
    BeanElement element(Markup markup) {
        // Mostly there are many of a kind in a row.
        for (int i = 0; i < elements.size(); i++) {
            int candidate = (latest + i) % elements.size();
            if (markup.isNamed(elements.get(candidate).name())) {
                latest = candidate;
                return elements.get(candidate);
            }
        }
        throw new Unusual();
    }
}
