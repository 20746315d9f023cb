package cz.paprsek.xml;

import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles.Contents;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Reads good files quickly: binds them to the beans by the same annotations as JAXB, takes nothing that the schema would refuse, and makes scenes
 * of the beans by the same code. At the first thing that is wrong or not known here, it gives up; the file is then read thoroughly.
 */
final class QuickReader {
    private static final byte[] NAMESPACE_ATTRIBUTE = ascii("xmlns");
    private static final byte[] SCENE = ascii("scene");
    private static final byte[] DATABASE = ascii("database");

    private final Markup markup;
    private final NoProblems none = new NoProblems();
    private final List<Scene> scenes = new ArrayList<>();

    private QuickReader(Markup markup) {
        this.markup = markup;
    }

    /** What is in a file; empty if it must be read thoroughly. */
    static Optional<Contents> read(InputStream input) throws IOException {
        try {
            return Optional.of(new QuickReader(new Markup(input)).contents());
        } catch (IllegalArgumentException unusual) {
            return Optional.empty();
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("the annotated beans are at odds with their reader", e);
        }
    }

    private Contents contents() throws IOException, ReflectiveOperationException {
        BeanType databases = BeanType.of(DatabaseBean.class);
        usual(markup.nextTag());
        boolean isDatabase = markup.isNamed(DATABASE);
        usual(isDatabase || markup.isNamed(SCENE));
        BeanType type = isDatabase ? databases : BeanType.of(SceneBean.class);
        Object root = type.create();
        attributes(root, type, true);
        content(root, type, isDatabase ? DATABASE : SCENE, 1);
        if (root instanceof SceneBean scene) {
            keep(scene);
        }
        markup.end();
        return new Contents(scenes, isDatabase);
    }

    private void attributes(Object bean, BeanType type, boolean isRoot) throws IllegalAccessException {
        long had = 0;
        boolean hasNamespace = !isRoot;
        while (markup.nextAttribute()) {
            int number = number(type);
            if (number < 0) {
                usual(!hasNamespace && markup.isNamed(NAMESPACE_ATTRIBUTE) && markup.value().equals(SceneFiles.NAMESPACE));
                hasNamespace = true;
            } else {
                usual((had & (1L << number)) == 0);
                had |= 1L << number;
                type.attributes().get(number).read(bean, markup);
            }
        }
        usual(hasNamespace && (type.required() & ~had) == 0);
    }

    private int number(BeanType type) {
        List<BeanAttribute> attributes = type.attributes();
        for (int i = 0; i < attributes.size(); i++) {
            if (markup.isNamed(attributes.get(i).name())) {
                return i;
            }
        }
        return -1;
    }

    /** Reads what is inside an element, up to its end. */
    private void content(Object bean, BeanType type, byte[] element, int depth) throws IOException, ReflectiveOperationException {
        if (markup.isEmptyElement()) {
            return;
        }
        usual(depth < SceneFiles.DEEPEST);
        long had = 0;
        int latest = 0;
        while (markup.nextTag()) {
            BeanElement child = type.element(markup);
            usual(child.isMany() || (had & (1L << child.number())) == 0);
            usual(type.isInAnyOrder() || child.number() >= latest);
            had |= 1L << child.number();
            latest = child.number();
            Object value = child.isText() ? text(child.name()) : bean(type.of(child), child.name(), depth + 1);
            if (!keep(bean, value)) {
                child.put(bean, value);
            }
        }
        markup.endTag(element);
    }

    private Object bean(BeanType type, byte[] element, int depth) throws IOException, ReflectiveOperationException {
        Object bean = type.create();
        attributes(bean, type, false);
        content(bean, type, element, depth);
        return bean;
    }

    private String text(byte[] element) throws IOException {
        usual(!markup.nextAttribute());
        if (markup.isEmptyElement()) {
            return "";
        }
        String text = markup.content();
        usual(text.length() <= SceneWriter.LONGEST_DESCRIPTION && !markup.nextTag());
        markup.endTag(element);
        return text;
    }

    /** Makes records of the beans that files have in large numbers at once, so that a million beans need not be kept; false for others. */
    private boolean keep(Object within, Object bean) {
        if (within instanceof SceneBean scene && bean instanceof ShapeBean shape) {
            return scene.made.add(none.make(shape, () -> shape.toObject(none)));
        }
        if (within instanceof DatabaseBean database && bean instanceof SceneBean scene) {
            database.checkName(scene, none);
            return keep(scene);
        }
        return false;
    }

    private boolean keep(SceneBean bean) {
        Scene scene = bean.toScene(none);
        usual(scene != null);
        return scenes.add(scene);
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    private static void usual(boolean condition) {
        if (!condition) {
            throw new Unusual();
        }
    }
}
