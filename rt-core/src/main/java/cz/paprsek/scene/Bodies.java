package cz.paprsek.scene;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Text;
import cz.paprsek.shape.height.HeightField;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.BiFunction;

/** What is changed of, and asked of, all objects and operands of a scene. */
final class Bodies {
    private Bodies() {}

    static Scene of(Scene scene, Collection<BodyAt> places, BiFunction<BodyAt, Body, Body> change) {
        Map<Integer, List<BodyAt>> byObject = new HashMap<>();
        Map<Integer, SceneObject> changes = new HashMap<>();
        boolean areObjects = places.stream().allMatch(at -> at.depth() == 0);
        places.forEach(at -> {
            if (areObjects && at.isIn(scene)) {
                Body old = at.in(scene);
                Body fresh = change.apply(at, old);
                if (!fresh.equals(old)) {
                    changes.put(at.index(), fresh.toObject());
                }
            } else if (!areObjects) {
                byObject.computeIfAbsent(at.numbers().get(0), object -> new ArrayList<>()).add(at);
            }
        });
        for (Map.Entry<Integer, List<BodyAt>> entry : byObject.entrySet()) {
            BodyAt at = ScenePath.body(entry.getKey());
            if (at.isIn(scene)) {
                Body old = at.in(scene);
                Body fresh = changed(old, at, entry.getValue(), change);
                if (!fresh.equals(old)) {
                    changes.put(at.index(), fresh.toObject());
                }
            }
        }
        return changes.isEmpty() ? scene : scene.withObjects(changes);
    }

    /** The scene without what is hidden in it; itself if nothing is. */
    static Scene shown(Scene scene) {
        List<SceneObject> objects = new ArrayList<>();
        for (SceneObject object : scene.objects()) {
            shown(Body.of(object)).map(Body::toObject).ifPresent(left -> objects.add(left.equals(object) ? object : left));
        }
        // What is hidden moves unseen; and what has no name is animated by its number, which would be that of another one.
        return objects.equals(scene.objects()) ? scene : scene.withAnimations(List.of()).withObjects(objects);
    }

    private static Optional<Body> shown(Body body) {
        if (body.hidden() || !(body.shape() instanceof Csg csg)) {
            return body.hidden() ? Optional.empty() : Optional.of(body);
        }
        if (csg.operation() == Csg.Operation.DIFFERENCE && shown(Body.of(csg.operands().get(0))).isEmpty()) {
            return Optional.empty();
        }
        List<Operand> left = csg.operands().stream().flatMap(operand -> shown(Body.of(operand)).map(Body::toOperand).stream()).toList();
        return left.equals(csg.operands()) ? Optional.of(body) : left.isEmpty() ? Optional.empty() : Optional.of(body.withShape(new Csg(csg.operation(), left)));
    }

    private static Body changed(Body body, BodyAt at, List<BodyAt> places, BiFunction<BodyAt, Body, Body> change) {
        Body result = body;
        List<BodyAt> within = places.stream().filter(at::holds).toList();
        if (!within.isEmpty() && body.shape() instanceof Csg csg) {
            List<Operand> operands = new ArrayList<>(csg.operands());
            for (int i = 0; i < operands.size(); i++) {
                BodyAt child = at.child(i);
                List<BodyAt> inChild = within.stream().filter(place -> place.equals(child) || child.holds(place)).toList();
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
        return places.contains(at) ? change.apply(at, result) : result;
    }

    /** Which files a scene needs besides its own. */
    static SortedSet<String> files(Scene scene) {
        SortedSet<String> names = new TreeSet<>();
        if (scene.sky() instanceof Scene.Sky.Picture picture) {
            names.add(picture.file());
        }
        scene.materials().values().forEach(material -> names.addAll(material.files()));
        MaterialSource before = Inherited.INHERITED;
        for (SceneObject object : scene.objects()) {
            // Neighbours are often of one material, which is asked once.
            addFiles(object.material() == before ? Inherited.INHERITED : object.material(), object.shape(), names);
            before = object.material();
        }
        return Collections.unmodifiableSortedSet(names);
    }

    private static void addFiles(MaterialSource material, Shape shape, SortedSet<String> names) {
        if (material instanceof Material own) {
            names.addAll(own.files());
        }
        if (shape instanceof Mesh mesh && !mesh.file().isEmpty()) {
            names.add(mesh.file());
        }
        if (shape instanceof HeightField field && !field.file().isEmpty()) {
            names.add(field.file());
        }
        if (shape instanceof Text text) {
            names.addAll(text.file().stream().toList());
        }
        if (shape instanceof Csg csg) {
            csg.operands().forEach(operand -> addFiles(operand.material(), operand.solid(), names));
        }
    }
}
