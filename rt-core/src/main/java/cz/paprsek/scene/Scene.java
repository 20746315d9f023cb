package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * A whole scene: the one immutable truth that files are read into, the editor edits and the renderer renders.
 * Right-handed world, y up.
 *
 * @param name free text; empty for none
 * @param description free text; empty for none
 * @param tags words to find the scene by
 * @param settings how it wishes to be rendered
 * @param background what a ray sees that hits nothing
 * @param ambient light that reaches every point alike
 * @param camera the eye
 * @param lights any number, also none
 * @param materials the named materials, in the order of the file
 * @param objects any number, also none
 */
@Element("A scene. Its elements may come in any order; exactly one camera, at most one render, background, ambient and description.")
public record Scene(
        @Attribute(value = Kind.NAME, means = "What the scene is called; no control characters, as in all names", otherwise = Attribute.NOTHING) String name,
        String description,
        @Attribute(value = Kind.WORDS, means = "Words to find it by", otherwise = Attribute.NOTHING) List<String> tags,
        RenderSettings settings,
        Rgb background,
        Rgb ambient,
        Camera camera,
        List<Light> lights,
        Map<String, Material> materials,
        List<SceneObject> objects) {

    /** No object, no light, black all around. */
    public static final Scene EMPTY = new Scene("", "", List.of(), RenderSettings.DEFAULT, Rgb.BLACK, Rgb.BLACK,
            Camera.DEFAULT, List.of(), Map.of(), List.of());

    /** @throws IllegalArgumentException with the first sentence of {@link SceneRules} that is broken */
    public Scene {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(description, "description");
        Objects.requireNonNull(settings, "settings");
        Objects.requireNonNull(background, "background");
        Objects.requireNonNull(ambient, "ambient");
        Objects.requireNonNull(camera, "camera");
        tags = List.copyOf(tags);
        lights = List.copyOf(lights);
        materials = Collections.unmodifiableMap(new LinkedHashMap<>(materials));
        objects = List.copyOf(objects);
        SceneRules.check(lights, materials, objects, (culprit, sentence) -> {
            throw new IllegalArgumentException(sentence);
        });
    }

    public Scene withName(String value) {
        return new Scene(value, description, tags, settings, background, ambient, camera, lights, materials, objects);
    }

    public Scene withDescription(String value) {
        return new Scene(name, value, tags, settings, background, ambient, camera, lights, materials, objects);
    }

    public Scene withTags(List<String> value) {
        return new Scene(name, description, value, settings, background, ambient, camera, lights, materials, objects);
    }

    public Scene withSettings(RenderSettings value) {
        return new Scene(name, description, tags, value, background, ambient, camera, lights, materials, objects);
    }

    public Scene withBackground(Rgb value) {
        return new Scene(name, description, tags, settings, value, ambient, camera, lights, materials, objects);
    }

    public Scene withAmbient(Rgb value) {
        return new Scene(name, description, tags, settings, background, value, camera, lights, materials, objects);
    }

    public Scene withCamera(Camera value) {
        return new Scene(name, description, tags, settings, background, ambient, value, lights, materials, objects);
    }

    public Scene withLights(List<Light> value) {
        return new Scene(name, description, tags, settings, background, ambient, camera, value, materials, objects);
    }

    public Scene withMaterials(Map<String, Material> value) {
        return new Scene(name, description, tags, settings, background, ambient, camera, lights, value, objects);
    }

    public Scene withObjects(List<SceneObject> value) {
        return new Scene(name, description, tags, settings, background, ambient, camera, lights, materials, value);
    }

    /** With one more light. */
    public Scene plus(Light light) {
        Objects.requireNonNull(light, "light");
        return withLights(appended(lights, light));
    }

    /** With these objects added; for many, pass them in one call. */
    public Scene plus(SceneObject... more) {
        List<SceneObject> all = new ArrayList<>(objects);
        Collections.addAll(all, more);
        return withObjects(all);
    }

    /** With a named material added, or replaced. */
    public Scene plus(String materialName, Material material) {
        Objects.requireNonNull(materialName, "materialName");
        Objects.requireNonNull(material, "material");
        Map<String, Material> all = new LinkedHashMap<>(materials);
        all.put(materialName, material);
        return withMaterials(all);
    }

    private static <T> List<T> appended(List<T> list, T item) {
        List<T> all = new ArrayList<>(list);
        all.add(item);
        return all;
    }
}
