package cz.paprsek.xml.write;

import cz.paprsek.attribute.ElementTable;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.format.SceneFormat;
import cz.paprsek.xml.text.Form;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;

/** Scenes as the elements that {@link SceneWriter} makes of them, each written only when it is looked into. */
public final class SceneForms {
    private SceneForms() {}

    /** A file with one scene. */
    public static Form file(Scene scene) {
        return scene(scene, true);
    }

    public static Form database(List<Form> scenes) {
        Map<String, String> attributes = new LinkedHashMap<>(Map.of("xmlns", SceneFormat.NAMESPACE));
        return Form.of("database", scenes, () -> new Form.Body("database", attributes, scenes, ""));
    }

    /** A scene in a database. */
    public static Form scene(Scene scene) {
        return scene(scene, false);
    }

    private static Form scene(Scene scene, boolean isRoot) {
        // Scenes are equal whatever the order of their materials.
        return Form.of("scene", List.of(scene, List.copyOf(scene.materials().keySet())), () -> body(scene, isRoot));
    }

    private static Form.Body body(Scene scene, boolean isRoot) {
        if (!scene.recipe().isNone()) {
            Form.Body written = Form.parse(scene.recipe().text()).body();
            Map<String, String> attributes = new LinkedHashMap<>(written.attributes());
            if (!isRoot) {
                attributes.remove("xmlns");
            }
            return new Form.Body("scene", attributes, written.children(), written.content());
        }
        Form.Body head = Form.parse(SceneWriter.head(scene, isRoot)).body();
        List<Form> children = new ArrayList<>(head.children());
        scene.lights().forEach(light -> children.add(form(ElementTable.name(light.getClass()), light, () -> SceneWriter.text(light))));
        scene.materials().entrySet().forEach(named -> children.add(form("material", named, () -> SceneWriter.text(named.getKey(), named.getValue()))));
        scene.objects().forEach(object -> children.add(form(object.shape().kind(), object, () -> SceneWriter.text(object))));
        scene.animations().forEach(animation -> children.add(form(ElementTable.name(Animation.class), animation, () -> SceneWriter.text(animation))));
        return new Form.Body("scene", head.attributes(), children, "");
    }

    private static Form form(String element, Object value, Supplier<String> text) {
        return Form.of(element, value, () -> Form.parse(text.get()).body());
    }
}
