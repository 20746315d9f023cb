package cz.paprsek.xml.recipe;

import cz.paprsek.scene.Animation;
import cz.paprsek.xml.text.Form;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * An element as it is written, with its formulas. By identity.
 *
 * @param attributes in their order
 * @param content the text of an element without others inside, as it stands there
 * @param origin the file that it is in
 * @param at where in that it begins, in bytes
 */
record Node(String name, List<Attr> attributes, List<Node> children, String content, Origin origin, int at) {
    static final String REPEAT = "repeat";
    static final String INSTANCE = "instance";
    static final String PARAM = "param";
    static final String DEFINE = "define";
    static final String INCLUDE = "include";
    static final String ANIMATE = "animate";
    /** The elements that are gone when all is written out. */
    static final Set<String> NAMES = Set.of(REPEAT, INSTANCE, PARAM, DEFINE, INCLUDE);
    /** Whose operands are bodies. */
    private static final Set<String> OPERATIONS = Set.of("union", "difference", "intersection");

    /**
     * An attribute.
     *
     * @param raw the value as it stands between the quotes
     * @param template the value with its formulas; empty if it has none, or is a text that may hold anything
     * @param nameAt where its name begins, in bytes
     * @param valueAt where its value begins, in bytes
     */
    record Attr(String name, String raw, Optional<Template> template, int nameAt, int valueAt) {
        String text() {
            return Raw.text(raw);
        }
    }

    Node {
        attributes = List.copyOf(attributes);
        children = List.copyOf(children);
    }

    Optional<Attr> attribute(String wanted) {
        for (Attr one : attributes) {
            if (one.name().equals(wanted)) {
                return Optional.of(one);
            }
        }
        return Optional.empty();
    }

    /** Whether there is nothing in it, at any depth, that must be written out. */
    boolean isPlain() {
        return !NAMES.contains(name) && !isOfParameter() && attributes.stream().allMatch(one -> one.template().isEmpty()) && children.stream().allMatch(Node::isPlain);
    }

    /** Whether it animates a parameter. */
    boolean isOfParameter() {
        return name.equals(ANIMATE) && attribute("target").filter(one -> one.text().startsWith(Animation.PARAMETER)).isPresent();
    }

    boolean isOperation() {
        return OPERATIONS.contains(name);
    }

    boolean isBody() {
        return Form.group(name).equals("body") && !name.equals(PARAM) && !name.equals(DEFINE) && !name.equals(INCLUDE);
    }

    @Override
    public boolean equals(Object other) {
        return this == other;
    }

    @Override
    public int hashCode() {
        return System.identityHashCode(this);
    }
}
