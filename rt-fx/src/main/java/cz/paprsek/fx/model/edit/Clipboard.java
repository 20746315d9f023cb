package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Places as text: a scene file of just these, so that they can be pasted into another window, a mail or a file. */
public final class Clipboard {
    private Clipboard() {}

    /**
     * Objects, operands, lights and cameras as a scene file, with the named materials they refer to. Operands become objects of their own. Cameras get
     * a name if they have none: one without is that of a file which needs one.
     *
     * @throws IllegalArgumentException if nothing of the kind is selected, or an operand is sheared
     */
    public static String copy(EditorState state, Collection<? extends ScenePath> items) {
        List<BodyAt> places = Places.outermost(items);
        List<LightAt> lightPlaces = Places.lights(items);
        List<CameraAt> cameraPlaces = Places.cameras(items);
        if (places.isEmpty() && lightPlaces.isEmpty() && cameraPlaces.isEmpty()) {
            throw new IllegalArgumentException("select what is to be copied");
        }
        Scene scene = state.scene();
        Names names = new Names(new HashSet<>());
        List<SceneObject> objects = new ArrayList<>();
        for (BodyAt at : places) {
            Body body = at.in(scene);
            if (at.depth() > 0) {
                body = body.placed(Placements.of(at.toWorld(scene)).orElseThrow(() -> new IllegalArgumentException(
                        "an operand sheared by the operations around it cannot be copied on its own"))).madeOf(at.source(scene));
            }
            objects.add(body.named(names.take(body.name())).toObject());
        }
        List<Light> lights = lightPlaces.stream().map(at -> scene.lights().get(at.index())).toList();
        Map<String, Material> materials = new LinkedHashMap<>(scene.materials());
        Set<String> used = new LinkedHashSet<>();
        objects.forEach(object -> Materials.collectNames(Body.of(object), used));
        materials.keySet().retainAll(used);
        Scene copied = Scene.EMPTY.withMaterials(materials).withLights(lights).withObjects(objects);
        List<Camera> cameras = cameraPlaces.stream().map(at -> Cameras.named(scene.cameras().get(at.index()))).toList();
        return SceneFiles.format(cameras.isEmpty() ? copied : copied.withCameras(cameras));
    }

    /**
     * As {@link #insert}, from a scene file; and its cameras that have names.
     *
     * @throws SceneFileException if the text is not a scene
     */
    public static EditorState paste(EditorState state, String xml) throws SceneFileException {
        Scene pasted = SceneFiles.parse(xml);
        List<Camera> cameras = pasted.cameras().stream().filter(camera -> !camera.name().isEmpty()).toList();
        return cameras.isEmpty() ? insert(state, pasted)
                : Cameras.withOthers(isEmpty(pasted) ? state.withSelection(Set.of()) : insert(state, pasted), cameras);
    }

    /**
     * Adds the objects and lights of a scene and selects them. Materials come along; one whose name is taken by another material is given a
     * free name.
     *
     * @throws IllegalArgumentException if there is nothing in it
     */
    public static EditorState insert(EditorState state, Scene pasted) {
        if (isEmpty(pasted)) {
            throw new IllegalArgumentException("there is nothing in the clipboard that a scene could take in");
        }
        Map<String, Material> materials = new LinkedHashMap<>(state.scene().materials());
        Map<String, String> renamed = new LinkedHashMap<>();
        pasted.materials().forEach((name, material) -> {
            String fresh = material.equals(materials.get(name)) ? name : Names.free(name, materials.keySet());
            renamed.put(name, fresh);
            materials.put(fresh, material);
        });
        EditorState withMaterials = state.withScene(state.scene().withMaterials(materials));
        if (pasted.objects().isEmpty() && pasted.lights().isEmpty()) {
            return withMaterials;
        }
        return Structure.add(withMaterials,
                pasted.objects().stream().map(object -> Materials.mapped(Body.of(object), source -> renamed(source, renamed)).toObject()).toList(),
                pasted.lights());
    }

    private static boolean isEmpty(Scene pasted) {
        return pasted.objects().isEmpty() && pasted.lights().isEmpty() && pasted.materials().isEmpty();
    }

    private static MaterialSource renamed(MaterialSource source, Map<String, String> names) {
        return source instanceof MaterialName reference
                ? new MaterialName(names.getOrDefault(reference.name(), reference.name())) : source;
    }
}
