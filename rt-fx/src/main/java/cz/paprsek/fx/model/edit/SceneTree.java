package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The objects and lights of a scene as a tree that can be rearranged, for one edit. Remembers where each node was, so that what is selected,
 * hidden or locked stays so. Operations left without operands vanish.
 */
final class SceneTree {
    /** An object or operand. */
    static final class Node {
        private @Nullable Node parent;
        private final List<Node> children = new ArrayList<>();
        private final @Nullable SceneObject source;
        Body body;

        private Node(Body body, @Nullable SceneObject source) {
            this.body = body;
            this.source = source;
            body.operands().forEach(operand -> insert(this, children, children.size(), new Node(Body.of(operand), null)));
        }

        /** A node that the scene does not have yet. */
        static Node fresh(Body body) {
            return new Node(body, null);
        }

        @Nullable Node parent() {
            return parent;
        }

        List<Node> children() {
            return List.copyOf(children);
        }

        boolean isOperation() {
            return body.shape() instanceof Csg;
        }

        private boolean isWithin(Node other) {
            return this == other || (parent != null && parent.isWithin(other));
        }

        private Body rebuilt() {
            if (!(body.shape() instanceof Csg csg)) {
                return body;
            }
            List<Operand> operands = children.stream().map(child -> child.rebuilt().toOperand()).toList();
            return operands.equals(csg.operands()) ? body : body.withShape(new Csg(csg.operation(), operands));
        }

        /** The very object it was read from, if it is still equal to it. */
        private SceneObject rebuiltObject() {
            SceneObject object = rebuilt().toObject();
            return source != null && object.equals(source) ? source : object;
        }
    }

    private final EditorState before;
    private final List<Node> objects = new ArrayList<>();
    private final List<Light> lights;
    private final List<Integer> lightOrigins = new ArrayList<>();
    private final Map<BodyAt, Node> nodes = new HashMap<>();

    SceneTree(EditorState before) {
        this.before = before;
        this.lights = new ArrayList<>(before.scene().lights());
        for (int i = 0; i < lights.size(); i++) {
            lightOrigins.add(i);
        }
        for (SceneObject object : before.scene().objects()) {
            Node node = new Node(Body.of(object), object);
            register(ScenePath.body(objects.size()), node);
            objects.add(node);
        }
    }

    private void register(BodyAt at, Node node) {
        nodes.put(at, node);
        for (int i = 0; i < node.children.size(); i++) {
            register(at.child(i), node.children.get(i));
        }
    }

    /** The node that stood at a place at the start. */
    Node node(BodyAt at) {
        Node node = nodes.get(at);
        if (node == null) {
            throw new IllegalArgumentException("there is nothing at " + at.numbers());
        }
        return node;
    }

    /** Says that what stood at a place at the start is this node from now on, with all within. */
    void follow(BodyAt at, Node node) {
        register(at, node);
    }

    /** The nodes that stood at places at the start, without those that are within others of them. */
    List<Node> nodes(Collection<? extends ScenePath> items) {
        return Places.outermost(items).stream().map(this::node).toList();
    }

    int objectCount() {
        return objects.size();
    }

    /** Where a node is among its siblings. */
    int index(Node node) {
        List<Node> siblings = siblings(node.parent);
        for (int i = 0; i < siblings.size(); i++) {
            if (siblings.get(i) == node) {
                return i;
            }
        }
        throw new IllegalStateException("a node is not among its siblings");
    }

    /** Where among a node's children, or the scene's objects for no node, an index leads to when others are gone. */
    int indexWithout(Collection<Node> gone, @Nullable Node parent, int index) {
        Set<Node> all = new HashSet<>(gone);
        return (int) siblings(parent).subList(0, index).stream().filter(node -> !all.contains(node)).count();
    }

    /** The names that a node's children, or the scene's objects for no node, have. */
    Names names(@Nullable Node parent) {
        return namesWithout(Set.of(), parent);
    }

    /** Likewise, when some are gone. */
    Names namesWithout(Set<Node> gone, @Nullable Node parent) {
        Set<String> names = new HashSet<>();
        siblings(parent).stream().filter(node -> !gone.contains(node)).forEach(node -> names.add(node.body.name()));
        return new Names(names);
    }

    /** Takes nodes away, however many, in a single walk through their siblings. */
    void removeAll(Collection<Node> gone) {
        Set<Node> all = new HashSet<>(gone);
        families(gone).forEach(siblings -> siblings.removeIf(all::contains));
        gone.forEach(node -> node.parent = null);
    }

    /** Puts others in the place of each of some nodes, likewise; it may be one of them itself. */
    void replaceAll(Map<Node, List<Node>> fresh) {
        families(fresh.keySet()).forEach(siblings -> {
            List<Node> old = List.copyOf(siblings);
            siblings.clear();
            old.forEach(node -> siblings.addAll(fresh.getOrDefault(node, List.of(node))));
        });
        fresh.forEach((node, others) -> others.forEach(one -> one.parent = node.parent));
    }

    /** Each list that one of some nodes is in, once. */
    private Collection<List<Node>> families(Collection<Node> nodes) {
        Map<Optional<Node>, List<Node>> all = new HashMap<>();
        nodes.forEach(node -> all.computeIfAbsent(Optional.ofNullable(node.parent), parent -> siblings(node.parent)));
        return all.values();
    }

    /**
     * Puts a node that is nowhere among the children of an operation, or, for none, the objects of the scene.
     *
     * @throws IllegalArgumentException if the parent cannot have it
     */
    void insert(@Nullable Node parent, int index, Node node) {
        if (parent != null && (!parent.isOperation() || parent.isWithin(node))) {
            throw new IllegalArgumentException("only an operation can take others in, and not itself");
        }
        insert(parent, siblings(parent), index, node);
    }

    private static void insert(@Nullable Node parent, List<Node> siblings, int index, Node node) {
        node.parent = parent;
        siblings.add(index, node);
    }

    /** How many lights there are now. */
    int lightCount() {
        return lights.size();
    }

    /** The light that was at an index at the start. */
    Light light(LightAt at) {
        return lights.get(lightOrigins.indexOf(at.index()));
    }

    Set<String> lightNames() {
        Set<String> names = new LinkedHashSet<>();
        lights.forEach(light -> names.add(light.name()));
        return names;
    }

    void removeLight(LightAt at) {
        int index = lightOrigins.indexOf(at.index());
        lights.remove(index);
        lightOrigins.remove(index);
    }

    /** Adds a light that came from an index at the start, or −1 if it is new. */
    void insertLight(int index, Light light, int origin) {
        lights.add(index, light);
        lightOrigins.add(index, origin);
    }

    /** The state that results, with the same selection. */
    EditorState result() {
        prune(objects);
        Map<Node, BodyAt> places = places();
        Scene after = before.scene().changed(scene -> scene.withLights(lights).withObjects(objects.stream().map(Node::rebuiltObject).toList()), item -> place(item, places));
        return before.moved(after, item -> place(item, places));
    }

    /** The state that results, with these nodes and lights selected instead. */
    EditorState resultSelecting(Collection<Node> selected, Collection<Integer> selectedLights) {
        EditorState result = result();
        Map<Node, BodyAt> places = places();
        Set<ScenePath> items = new LinkedHashSet<>();
        selected.forEach(node -> Optional.ofNullable(places.get(node)).ifPresent(items::add));
        selectedLights.forEach(index -> items.add(ScenePath.light(index)));
        return result.withSelection(items);
    }

    private Optional<ScenePath> place(ScenePath item, Map<Node, BodyAt> places) {
        if (item instanceof LightAt light) {
            int now = lightOrigins.indexOf(light.index());
            return now < 0 ? Optional.empty() : Optional.of(ScenePath.light(now));
        }
        return item instanceof BodyAt body ? Optional.ofNullable(places.get(node(body))) : Optional.of(item);
    }

    private Map<Node, BodyAt> places() {
        Map<Node, BodyAt> places = new HashMap<>();
        for (int i = 0; i < objects.size(); i++) {
            place(objects.get(i), ScenePath.body(i), places);
        }
        return places;
    }

    private static void place(Node node, BodyAt at, Map<Node, BodyAt> places) {
        places.put(node, at);
        for (int i = 0; i < node.children.size(); i++) {
            place(node.children.get(i), at.child(i), places);
        }
    }

    private static void prune(List<Node> siblings) {
        siblings.forEach(node -> prune(node.children));
        siblings.removeIf(node -> node.isOperation() && node.children.isEmpty());
    }

    private List<Node> siblings(@Nullable Node parent) {
        return parent == null ? objects : parent.children;
    }
}
