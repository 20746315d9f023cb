package cz.paprsek.fx.view.find;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;

/** All that a scene is made of: chosen, a thing is selected, and a material given to what is selected. */
public final class SceneThings {
    /** Among more bodies nobody looks by name. */
    private static final int MOST = 5000;

    private SceneThings() {}

    public static List<Findable> of(Edits edits) {
        EditorModel model = edits.model();
        Texts texts = edits.texts();
        Scene scene = model.scene();
        List<Findable> found = new ArrayList<>();
        for (int i = 0; i < scene.cameras().size(); i++) {
            found.add(thing(model, texts, ScenePath.camera(i), texts.of("kind.camera")));
        }
        for (int i = 0; i < scene.lights().size(); i++) {
            found.add(thing(model, texts, ScenePath.light(i), texts.kind(scene.lights().get(i))));
        }
        List<BodyAt> bodies = ScenePath.bodies(scene).limit(MOST).filter(at -> !model.copies().isCopy(at)).toList();
        for (BodyAt at : bodies) {
            String kind = texts.kind(at.in(scene).shape());
            found.add(thing(model, texts, at, at.depth() == 0 ? kind : kind + " · " + PathNames.of(scene, at.parent(), texts)));
        }
        TreeMap<String, Material> materials = new TreeMap<>(Material.ready());
        materials.putAll(scene.materials());
        materials.forEach((name, material) -> found.add(new Findable(name, texts.of("find.material"), "", true, () -> edits.giveToSelected(name, material))));
        return found;
    }

    private static Findable thing(EditorModel model, Texts texts, ScenePath place, String where) {
        return new Findable(PathNames.of(model.scene(), place, texts), where, "", true, () -> model.select(place));
    }
}
