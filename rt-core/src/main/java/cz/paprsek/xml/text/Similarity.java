package cz.paprsek.xml.text;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Tells whether an element can be the changed form of another. */
final class Similarity {
    private static final int OF_NAME = 8;
    private static final int OF_KIND = 2;
    private static final int MOST_CHILDREN = 100;

    private Similarity() {}

    /** The more, the more alike; 0 if one has not become the other, but has gone, and the other has come. */
    static int of(Form old, Form now) {
        Form.Body before = old.body();
        Form.Body after = now.body();
        boolean isSameName = !after.attribute("name").isEmpty() && after.attribute("name").equals(before.attribute("name"));
        boolean isSameKind = before.name().equals(after.name());
        int children = common(before.children(), after.children());
        if (!isSameName && !isSameKind && children == 0) {
            return 0;
        }
        int attributes = (int) after.attributes().entrySet().stream().filter(before.attributes().entrySet()::contains).count();
        return 1 + (isSameName ? OF_NAME : 0) + (isSameKind ? OF_KIND : 0) + children + attributes;
    }

    private static int common(List<Form> before, List<Form> after) {
        if (before.isEmpty() || after.isEmpty()) {
            return 0;
        }
        Set<Form> known = new HashSet<>(before.subList(0, Math.min(before.size(), MOST_CHILDREN)));
        return (int) after.stream().limit(MOST_CHILDREN).filter(known::contains).count();
    }
}
