package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.edit.SceneTree.Node;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Placement;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Changes of what belongs to what: each takes a state and gives another, to be passed to {@link EditorModel#editState}. All throw
 * {@link IllegalArgumentException} with a sentence for the user if they cannot be.
 */
public final class Structure {
    private Structure() {}

    /** Adds an object, with a free name, and selects it. */
    public static EditorState add(EditorState state, SceneObject object) {
        return add(state, List.of(object), List.of());
    }

    /** Adds a light, with a free name, and selects it. */
    public static EditorState add(EditorState state, Light light) {
        return add(state, List.of(), List.of(light));
    }

    /** Adds objects and lights, with free names, and selects them. */
    public static EditorState add(EditorState state, List<SceneObject> objects, List<Light> lights) {
        SceneTree tree = new SceneTree(state);
        Names names = tree.names(null);
        List<Node> nodes = new ArrayList<>();
        for (SceneObject object : objects) {
            Node node = Node.fresh(named(Body.of(object), names));
            tree.insert(null, tree.objectCount(), node);
            nodes.add(node);
        }
        List<Integer> places = new ArrayList<>();
        for (Light light : lights) {
            places.add(tree.lightCount());
            tree.insertLight(tree.lightCount(), light.named(Names.free(light.name(), tree.lightNames())), -1);
        }
        return tree.resultSelecting(nodes, places);
    }

    /** Deletes objects, operands, lights and cameras. An operation that loses its last operand goes too; one camera stays. */
    public static EditorState delete(EditorState state, Collection<? extends ScenePath> items) {
        SceneTree tree = new SceneTree(state);
        tree.removeAll(tree.nodes(items));
        Places.lights(items).forEach(tree::removeLight);
        return Cameras.remove(tree.result(), Places.cameras(items));
    }

    /** Copies objects, operands, lights and cameras, each right after its original or last, moved by an offset in world space; selects the copies. */
    public static EditorState duplicate(EditorState state, Collection<? extends ScenePath> items, Vec3 offset) {
        SceneTree tree = new SceneTree(state);
        List<Node> copies = new ArrayList<>();
        Map<Node, List<Node>> pairs = new HashMap<>();
        Map<Optional<Node>, Names> names = new HashMap<>();
        for (Node original : tree.nodes(items)) {
            Names taken = names.computeIfAbsent(Optional.ofNullable(original.parent()), parent -> tree.names(original.parent()));
            Node copy = Node.fresh(named(original.body, taken));
            copies.add(copy);
            pairs.put(original, List.of(original, copy));
        }
        tree.replaceAll(pairs);
        List<Integer> lights = new ArrayList<>();
        for (LightAt at : Places.lights(items)) {
            Light light = tree.light(at);
            lights.add(tree.lightCount());
            tree.insertLight(tree.lightCount(), light.named(Names.free(light.name(), tree.lightNames())), -1);
        }
        EditorState copied = Cameras.withCopies(tree.resultSelecting(copies, lights), Places.cameras(items));
        return copied.withScene(Moves.translated(copied.scene(), copied.selection(), offset));
    }

    /**
     * Takes objects and operands to other places, keeping where they are in the world.
     *
     * @param parent the operation that takes them in; empty for the scene
     * @param index before which of the parent's children as they are now, 0 to their number
     */
    public static EditorState move(EditorState state, Collection<? extends ScenePath> items, Optional<BodyAt> parent, int index) {
        Affine toTarget = parent.map(at -> at.toWorld(state.scene())).orElse(Affine.IDENTITY);
        SceneTree tree = new SceneTree(carried(state, Places.outermost(items), toTarget));
        Node target = parent.map(tree::node).orElse(null);
        List<Node> moving = new ArrayList<>();
        for (BodyAt at : Places.outermost(items)) {
            Node node = tree.node(at);
            node.body = transferred(node.body, at.parentToWorld(state.scene()), toTarget);
            moving.add(node);
        }
        int place = tree.indexWithout(moving, target, index);
        tree.removeAll(moving);
        Names names = tree.names(target);
        for (Node node : moving) {
            node.body = named(node.body, names);
            tree.insert(target, place++, node);
        }
        return tree.result();
    }

    /** Takes a light to another place in the order; the index counts the lights as they are now. */
    public static EditorState moveLight(EditorState state, LightAt at, int index) {
        SceneTree tree = new SceneTree(state);
        Light light = tree.light(at);
        tree.removeLight(at);
        tree.insertLight(index > at.index() ? index - 1 : index, light, at.index());
        return tree.result();
    }

    /**
     * Makes one solid of several, in the order given: a difference takes all others from the first. It stands where the first stood, and
     * each keeps its place in the world.
     */
    public static EditorState combine(EditorState state, Collection<? extends ScenePath> items, Csg.Operation operation, String name) {
        List<BodyAt> places = Places.outermost(items);
        if (places.size() < 2) {
            throw new IllegalArgumentException("select at least two solids to combine");
        }
        Affine toParent = places.get(0).parentToWorld(state.scene());
        SceneTree tree = new SceneTree(carried(state, places, toParent));
        Node first = tree.node(places.get(0));
        Node parent = first.parent();
        List<Body> operands = new ArrayList<>();
        Names names = new Names(new HashSet<>());
        for (BodyAt at : places) {
            operands.add(named(transferred(tree.node(at).body, at.parentToWorld(state.scene()), toParent), names));
        }
        Csg csg = new Csg(operation, operands.stream().map(Body::toOperand).toList());
        return replaced(tree, places, parent, new Body(name, csg, Placement.NONE, Inherited.INHERITED));
    }

    /** With an operation of what stood at places, in their order, instead. */
    private static EditorState replaced(SceneTree tree, List<BodyAt> places, @Nullable Node parent, Body body) {
        List<Node> gone = places.stream().map(tree::node).toList();
        int index = tree.indexWithout(gone, parent, tree.index(gone.get(0)));
        tree.removeAll(gone);
        Node fresh = Node.fresh(named(body, tree.names(parent)));
        tree.insert(parent, index, fresh);
        List<Node> operands = fresh.children();
        for (int i = 0; i < places.size(); i++) {
            tree.follow(places.get(i), operands.get(i));
        }
        return tree.resultSelecting(List.of(fresh), List.of());
    }

    /** Puts the operands of operations in the place of these, where they are in the world and of what they are made of; selects them. */
    public static EditorState dissolve(EditorState state, Collection<? extends ScenePath> items) {
        EditorState freeing = state;
        for (BodyAt at : Places.outermost(items)) {
            if (at.in(state.scene()).shape() instanceof Csg csg) {
                CarriedKeys.checkAtRest(state.scene(), at);
                for (int i = 0; i < csg.operands().size(); i++) {
                    freeing = freeing.withScene(CarriedKeys.into(freeing.scene(), at.child(i), at.in(state.scene()).placement().toParent()));
                }
            }
        }
        SceneTree tree = new SceneTree(freeing);
        Map<Node, List<Node>> freed = new LinkedHashMap<>();
        tree.nodes(items).stream().filter(Node::isOperation).forEach(operation -> freed.put(operation, operation.children()));
        if (freed.isEmpty()) {
            throw new IllegalArgumentException("select a union, difference or intersection to dissolve");
        }
        Map<Optional<Node>, Names> names = new HashMap<>();
        freed.forEach((operation, operands) -> {
            Names taken = names.computeIfAbsent(Optional.ofNullable(operation.parent()), parent -> tree.namesWithout(freed.keySet(), operation.parent()));
            operands.forEach(operand -> operand.body = named(freed(operand.body, operation.body), taken));
        });
        tree.replaceAll(freed);
        return tree.resultSelecting(freed.values().stream().flatMap(List::stream).toList(), List.of());
    }

    /** An operand where it is in the world, and of what it is made of, without its operation. */
    private static Body freed(Body operand, Body operation) {
        Body body = transferred(operand, operation.placement().toParent(), Affine.IDENTITY);
        return body.material() == Inherited.INHERITED ? body.madeOf(operation.material()) : body;
    }

    /** Gives an object, operand, light or camera another name; empty for none. */
    public static EditorState rename(EditorState state, ScenePath item, String name) {
        return state.withScene(state.scene().changed(scene -> renamed(scene, item, name), Optional::of));
    }

    private static Scene renamed(Scene scene, ScenePath item, String name) {
        if (item instanceof LightAt at) {
            List<Light> lights = new ArrayList<>(scene.lights());
            lights.set(at.index(), lights.get(at.index()).named(name));
            return scene.withLights(lights);
        }
        if (item instanceof CameraAt at) {
            return Cameras.changed(scene, at.index(), camera -> camera.named(name));
        }
        return item instanceof BodyAt at ? scene.with(at, body -> body.named(name)) : scene;
    }

    /** Hides items from the editor's views, or shows them again. */
    public static EditorState hide(EditorState state, Collection<? extends ScenePath> items, boolean hidden) {
        return state.withHidden(changed(state.hidden(), items, hidden));
    }

    /** Keeps items from being picked and moved, or allows it again. */
    public static EditorState lock(EditorState state, Collection<? extends ScenePath> items, boolean locked) {
        return state.withLocked(changed(state.locked(), items, locked));
    }

    private static Set<ScenePath> changed(Set<ScenePath> set, Collection<? extends ScenePath> items, boolean present) {
        Set<ScenePath> result = new LinkedHashSet<>(set);
        if (present) {
            result.addAll(items);
        } else {
            result.removeAll(items);
        }
        return result;
    }

    private static Body named(Body body, Names taken) {
        return body.named(taken.take(body.name()));
    }

    /** With keys of what is taken into another space. */
    private static EditorState carried(EditorState state, List<BodyAt> places, Affine toSpace) {
        Scene scene = state.scene();
        for (BodyAt at : places) {
            Affine fromSpace = at.parentToWorld(state.scene());
            scene = fromSpace.equals(toSpace) ? scene : CarriedKeys.into(scene, at, toSpace.inverse().after(fromSpace));
        }
        return state.withScene(scene);
    }

    /** The body placed in another space so that it stays where it is. */
    private static Body transferred(Body body, Affine fromSpace, Affine toSpace) {
        if (fromSpace.equals(toSpace)) {
            return body;
        }
        Affine map = toSpace.inverse().after(fromSpace).after(body.placement().toParent());
        return body.placed(Placements.of(map).orElseThrow(() -> new IllegalArgumentException(
                "this would shear the object, because an operation around it is stretched along an axis and turned")));
    }
}
