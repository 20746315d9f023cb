package cz.paprsek.xml.bind;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.xml.mistake.Grammar;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlElementRef;
import jakarta.xml.bind.annotation.XmlElements;
import jakarta.xml.bind.annotation.XmlRootElement;
import java.lang.reflect.Field;
import java.lang.reflect.ParameterizedType;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** Beans and schema say the same. */
class BeansTest {
    /** The attributes that beans bind are those the schema allows, for every element, nested ones included. */
    @Test
    void beansAndSchemaAgree() {
        Grammar grammar = Grammar.ofScenes();
        compare(grammar, "Scene", SceneBean.class, new HashSet<>());
    }

    /** Every bean of a shape may be bound where shapes are: what the schema keeps out is what must not be. */
    private static boolean isIn(Grammar grammar, String type, Class<?> shape) {
        return type.equals("Scene") || grammar.children(type).containsKey(name(shape));
    }

    private static String name(Class<?> bean) {
        return bean.getAnnotation(XmlRootElement.class).name();
    }

    private static void compare(Grammar grammar, String type, Class<?> bean, Set<String> done) {
        if (!done.add(type + bean.getName())) {
            return;
        }
        Set<String> attributes = new TreeSet<>();
        Map<String, Class<?>> children = new TreeMap<>();
        for (Class<?> c = bean; c != Object.class; c = c.getSuperclass()) {
            for (Field field : c.getDeclaredFields()) {
                XmlAttribute attribute = field.getAnnotation(XmlAttribute.class);
                if (attribute != null) {
                    attributes.add(attribute.name().equals("##default") ? field.getName() : attribute.name());
                }
                XmlElement element = field.getAnnotation(XmlElement.class);
                if (element != null) {
                    Class<?> held = field.getGenericType() instanceof ParameterizedType list
                            ? (Class<?>) list.getActualTypeArguments()[0] : field.getType();
                    children.put(element.name().equals("##default") ? field.getName() : element.name(), held);
                }
                if (field.isAnnotationPresent(XmlElements.class)) {
                    Arrays.stream(field.getAnnotation(XmlElements.class).value()).forEach(each -> children.put(each.name(), each.type()));
                }
                if (field.isAnnotationPresent(XmlElementRef.class)) {
                    ShapeBeans.all().filter(shape -> isIn(grammar, type, shape)).forEach(shape -> children.put(name(shape), shape));
                }
            }
        }
        Set<String> allowed = new TreeSet<>(grammar.attributes(type).keySet());
        // One bean serves named and unnamed materials.
        if (type.equals("Material")) {
            allowed.add("name");
        }
        assertThat(attributes).as("attributes of %s", type).isEqualTo(allowed);
        assertThat(children.keySet()).as("elements in %s", type).isEqualTo(new TreeSet<>(grammar.children(type).keySet()));
        grammar.children(type).forEach((name, childType) -> {
            Class<?> child = children.getOrDefault(name, String.class);
            if (child != String.class) {
                compare(grammar, childType, child, done);
            }
        });
    }
}
