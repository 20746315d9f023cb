package cz.paprsek.fx.model.edit;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Require;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.MaterialAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;

/** Names materials, and finds and changes what is made of them. */
public final class Materials {
    private Materials() {}

    /** How many objects and operands refer to a named material. */
    public static int uses(Scene scene, String name) {
        return scene.objects().stream().mapToInt(object -> uses(Body.of(object), new MaterialName(name))).sum();
    }

    /** Gives bodies materials of their own, which look like those they had. */
    public static Scene own(Scene scene, Collection<BodyAt> places) {
        return scene.with(places, (at, body) -> body.madeOf(at.material(scene)));
    }

    /**
     * Names the material that bodies have of their own: that of the first, which all others that have an equal one refer to from now on.
     *
     * @param name what it is called; with a number if that is taken
     */
    public static Scene name(Scene scene, Collection<BodyAt> places, String name) {
        Material own = places.stream().map(at -> at.in(scene).material())
                .filter(Material.class::isInstance).map(Material.class::cast).findFirst()
                .orElseThrow(() -> new IllegalArgumentException("select an object with a material of its own to name"));
        MaterialName reference = new MaterialName(Names.free(name, scene.materials().keySet()));
        return scene.plus(reference.name(), own).with(places, (at, body) ->
                body.material().equals(own) ? body.madeOf(reference) : body);
    }

    /** Makes bodies of a named material, which the scene gets if it has none like it and does not know it anyway; under a free name if another one has that. */
    public static Scene give(Scene scene, Collection<BodyAt> places, String name, Material material) {
        if (!scene.materials().containsKey(name) && material.equals(Material.ready().get(name))) {
            return scene.with(places, (at, body) -> body.madeOf(new MaterialName(name)));
        }
        String free = material.equals(scene.materials().get(name)) ? name : Names.free(name, scene.materials().keySet());
        MaterialName reference = new MaterialName(free);
        return scene.plus(free, material).with(places, (at, body) -> body.madeOf(reference));
    }

    /** Adds a material with a free name. */
    public static Scene add(Scene scene, String name, Material material) {
        return scene.plus(Names.free(name, scene.materials().keySet()), material);
    }

    /** Gives a named material another name, wherever it is referred to. */
    public static Scene rename(Scene scene, String old, String fresh) {
        if (old.equals(fresh)) {
            return scene;
        }
        Require.that(!scene.materials().containsKey(fresh),
                "there is already a material named \"" + fresh + "\"; give one of them another name");
        Map<String, Material> materials = new LinkedHashMap<>();
        scene.materials().forEach((name, material) -> materials.put(name.equals(old) ? fresh : name, material));
        MaterialName reference = new MaterialName(fresh);
        return scene.changed(still -> mapped(still.plus(fresh, Material.DEFAULT), source -> isCalled(source, old) ? reference : source).withMaterials(materials),
                place -> Optional.of(place.equals(new MaterialAt(old)) ? new MaterialAt(fresh) : place));
    }

    /** Forgets a named material; what referred to it gets one of its own that looks the same, and is not animated. */
    public static Scene delete(Scene scene, String name) {
        Map<String, Material> materials = new LinkedHashMap<>(scene.materials());
        Material material = materials.remove(name);
        return material == null ? scene
                : scene.changed(still -> mapped(still, source -> isCalled(source, name) ? material : source).withMaterials(materials), Optional::of);
    }

    /** The body with what it and all within it is made of changed. */
    static Body mapped(Body body, UnaryOperator<MaterialSource> change) {
        Body result = body.madeOf(change.apply(body.material()));
        if (!(body.shape() instanceof Csg csg)) {
            return result;
        }
        List<Operand> operands = csg.operands().stream().map(operand -> mapped(Body.of(operand), change).toOperand()).toList();
        return operands.equals(csg.operands()) ? result : result.withShape(new Csg(csg.operation(), operands));
    }

    /** Adds the names of all materials that a body and all within it refer to. */
    static void collectNames(Body body, Set<String> names) {
        if (body.material() instanceof MaterialName reference) {
            names.add(reference.name());
        }
        body.operands().forEach(operand -> collectNames(Body.of(operand), names));
    }

    /** The names of the materials that bodies refer to themselves. */
    public static Set<String> names(Scene scene, Collection<BodyAt> places) {
        Set<String> names = new LinkedHashSet<>();
        places.forEach(at -> at.find(scene).ifPresent(body -> {
            if (body.material() instanceof MaterialName reference) {
                names.add(reference.name());
            }
        }));
        return names;
    }

    private static Scene mapped(Scene scene, UnaryOperator<MaterialSource> change) {
        List<SceneObject> objects = new ArrayList<>();
        for (SceneObject object : scene.objects()) {
            SceneObject fresh = mapped(Body.of(object), change).toObject();
            objects.add(fresh.equals(object) ? object : fresh);
        }
        return scene.withObjects(objects);
    }

    private static boolean isCalled(MaterialSource source, String name) {
        return source instanceof MaterialName reference && reference.name().equals(name);
    }

    private static int uses(Body body, MaterialName name) {
        int own = body.material().equals(name) ? 1 : 0;
        return own + body.operands().stream().mapToInt(operand -> uses(Body.of(operand), name)).sum();
    }
}
