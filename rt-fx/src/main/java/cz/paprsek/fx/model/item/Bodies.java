package cz.paprsek.fx.model.item;

import cz.paprsek.fx.model.item.Item.BodyAt;
import cz.paprsek.math.Affine;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;

/** Finds and replaces objects and operands by their paths. What does not change stays the very same object. */
public final class Bodies {
    private Bodies() {}

    /** What stands at a path; empty if nothing does. */
    public static Optional<Body> find(Scene scene, BodyAt at) {
        int object = at.path().get(0);
        if (object < 0 || object >= scene.objects().size()) {
            return Optional.empty();
        }
        Body body = Body.of(scene.objects().get(object));
        for (int index : at.path().subList(1, at.path().size())) {
            List<Operand> operands = body.operands();
            if (index < 0 || index >= operands.size()) {
                return Optional.empty();
            }
            body = Body.of(operands.get(index));
        }
        return Optional.of(body);
    }

    /** The map from the space that a body's placement is in to the world: that of all operations around it. */
    public static Affine parentToWorld(Scene scene, BodyAt at) {
        Affine toWorld = Affine.IDENTITY;
        for (int length = 1; length < at.path().size(); length++) {
            Body around = find(scene, new BodyAt(at.path().subList(0, length))).orElseThrow();
            toWorld = toWorld.after(around.placement().toParent());
        }
        return toWorld;
    }

    /** The map from a body's own space to the world. */
    public static Affine toWorld(Scene scene, BodyAt at) {
        return parentToWorld(scene, at).after(find(scene, at).orElseThrow().placement().toParent());
    }

    /** The scene with one body changed. */
    public static Scene with(Scene scene, BodyAt at, UnaryOperator<Body> change) {
        return with(scene, List.of(at), (item, body) -> change.apply(body));
    }

    /** Changes a body, knowing where it is. */
    @FunctionalInterface
    public interface Change {
        Body apply(BodyAt at, Body body);
    }

    /**
     * The scene with several bodies changed; the same scene if nothing is different afterwards. Of two that are within each other, the
     * inner is changed first. Paths that lead nowhere are passed over.
     */
    public static Scene with(Scene scene, Collection<BodyAt> items, Change change) {
        Map<Integer, List<BodyAt>> byObject = new HashMap<>();
        items.forEach(item -> byObject.computeIfAbsent(item.path().get(0), i -> new ArrayList<>()).add(item));
        List<SceneObject> objects = new ArrayList<>(scene.objects());
        boolean changed = false;
        for (Map.Entry<Integer, List<BodyAt>> entry : byObject.entrySet()) {
            int index = entry.getKey();
            if (index < objects.size()) {
                Body old = Body.of(objects.get(index));
                Body fresh = changed(old, Item.body(index), entry.getValue(), change);
                if (!fresh.equals(old)) {
                    objects.set(index, fresh.toObject());
                    changed = true;
                }
            }
        }
        return changed ? scene.withObjects(objects) : scene;
    }

    private static Body changed(Body body, BodyAt at, List<BodyAt> items, Change change) {
        Body result = body;
        List<BodyAt> within = items.stream().filter(at::holds).toList();
        if (!within.isEmpty() && body.shape() instanceof Csg csg) {
            List<Operand> operands = new ArrayList<>(csg.operands());
            for (int i = 0; i < operands.size(); i++) {
                BodyAt child = at.child(i);
                List<BodyAt> inChild = within.stream().filter(item -> item.equals(child) || child.holds(item)).toList();
                if (!inChild.isEmpty()) {
                    Body old = Body.of(operands.get(i));
                    Body fresh = changed(old, child, inChild, change);
                    if (!fresh.equals(old)) {
                        operands.set(i, fresh.toOperand());
                    }
                }
            }
            result = body.withShape(new Csg(csg.operation(), operands));
        }
        return items.contains(at) ? change.apply(at, result) : result;
    }
}
