package cz.paprsek.xml.recipe;

import cz.paprsek.xml.recipe.Node.Attr;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Elements of a file with others in the place of some. */
final class Rewritten {
    /** What the use of a definition says of where it is, in the place of the body. */
    static final Set<String> OF_USE = Set.of("name", "position", "rotation", "scale", "pivot", "hidden");

    private Rewritten() {}

    /** With others in the places of some at any depth; none for those that go. */
    static Node of(Node node, IdentityHashMap<Node, List<Node>> others) {
        List<Node> children = new ArrayList<>();
        for (Node child : node.children()) {
            List<Node> known = others.get(child);
            children.addAll(known != null ? known : List.of(of(child, others)));
        }
        return new Node(node.name(), node.attributes(), children, node.content(), node.origin(), node.at());
    }

    /** With another value of an attribute; without it for none. */
    static Node with(Node node, String name, String value) {
        List<Attr> attributes = new ArrayList<>();
        boolean isThere = false;
        for (Attr one : node.attributes()) {
            boolean isIt = one.name().equals(name);
            isThere |= isIt;
            if (!isIt) {
                attributes.add(one);
            } else if (!value.isEmpty()) {
                attributes.add(attribute(name, value));
            }
        }
        if (!isThere && !value.isEmpty()) {
            attributes.add(attribute(name, value));
        }
        return new Node(node.name(), attributes, node.children(), node.content(), node.origin(), node.at());
    }

    /** An element around some that stand beside each other, in the place of the first of them. */
    static Node around(Node scene, List<Node> bodies, String element, Map<String, String> attributes) {
        IdentityHashMap<Node, List<Node>> others = new IdentityHashMap<>();
        bodies.forEach(one -> others.put(one, List.of()));
        List<Attr> all = attributes.entrySet().stream().filter(one -> !one.getValue().isEmpty()).map(one -> attribute(one.getKey(), one.getValue())).toList();
        Node first = bodies.get(0);
        others.put(first, List.of(new Node(element, all, bodies, "", first.origin(), first.at())));
        return of(scene, others);
    }

    /**
     * A definition of a body, and its use where the body stands.
     *
     * @param used which of the body's attributes become those of its use
     */
    static Node defined(Node scene, Node body, String name, Set<String> used) {
        List<Attr> uses = new ArrayList<>(List.of(attribute("of", name)));
        List<Attr> own = new ArrayList<>();
        body.attributes().forEach(one -> (used.contains(one.name()) ? uses : own).add(one));
        Node inside = new Node(body.name(), own, body.children(), body.content(), body.origin(), body.at());
        Node definition = new Node(Node.DEFINE, List.of(attribute("name", name)), List.of(inside), "", body.origin(), body.at());
        Node use = new Node(Node.INSTANCE, uses, List.of(), "", body.origin(), body.at());
        Node around = scene.children().stream().filter(child -> holds(child, body)).findFirst().orElseThrow();
        IdentityHashMap<Node, List<Node>> others = new IdentityHashMap<>();
        others.put(body, List.of(use));
        Node changed = around.equals(body) ? use : of(around, others);
        others.clear();
        others.put(around, List.of(definition, changed));
        return of(scene, others);
    }

    /** Whether one is the other, or around it. */
    static boolean holds(Node node, Node other) {
        return node.equals(other) || node.children().stream().anyMatch(child -> holds(child, other));
    }

    /** Whether all stand in the same element. */
    static boolean areSiblings(Node node, List<Node> bodies) {
        return node.children().stream().filter(bodies::contains).count() == bodies.size() || node.children().stream().anyMatch(child -> areSiblings(child, bodies));
    }

    private static Attr attribute(String name, String value) {
        return new Attr(name, Raw.of(value), Optional.empty(), -1, -1);
    }
}
