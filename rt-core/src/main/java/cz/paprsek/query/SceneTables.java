package cz.paprsek.query;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Material;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.text.Similar;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** The tables that scenes are seen as: scenes, cameras, lights, materials, all objects, and the objects of each kind. */
public final class SceneTables {
    private static final List<Relation<Scene, ?>> PARTS = parts();

    /** The scenes themselves. A filter of scenes may ask for whatever is in them. */
    public static final Table<Scene> SCENE = scene();

    private SceneTables() {}

    /** The scenes, as rows that belong to themselves. */
    public static Relation<Scene, Scene> scenes() {
        return new Relation<>(SCENE, Stream::of, false);
    }

    /** All tables, with the way from a scene to their rows; that of scenes first. */
    public static List<Relation<Scene, ?>> all() {
        List<Relation<Scene, ?>> all = new ArrayList<>();
        all.add(scenes());
        all.addAll(PARTS);
        return all;
    }

    /**
     * The table of that name.
     *
     * @throws IllegalArgumentException if there is none, with a list of those there are
     */
    public static Relation<Scene, ?> named(String name) {
        List<String> known = all().stream().map(relation -> relation.table().name()).toList();
        return all().stream().filter(relation -> relation.table().name().equals(name)).findFirst().orElseThrow(() -> new IllegalArgumentException(
                "there is no table \"" + name + "\"" + Similar.choice(name, known)));
    }

    private static Table<Scene> scene() {
        List<Column<Scene>> columns = new ArrayList<>(List.of(
                Column.text("name", Scene::name),
                Column.texts("tag", Scene::tags),
                Column.number("lights", scene -> scene.lights().size()),
                Column.number("materials", scene -> scene.materials().size()),
                Column.number("objects", scene -> scene.objects().size()),
                Column.number("operands", scene -> ScenePath.bodies(scene).filter(at -> at.depth() > 0).count())));
        columns.addAll(MaterialColumns.attributes(RenderSettings.class, Scene::settings));
        Described.elements(Scene.class).forEach(one -> columns.add(MaterialColumns.column(one, one::inForce)));
        columns.add(Column.text("sky", scene -> scene.sky().equals(Scene.Sky.NONE) ? "" : Described.word(scene.sky())));
        return new Table<>("scene", columns, PARTS);
    }

    private static List<Relation<Scene, ?>> parts() {
        List<Relation<Scene, ?>> parts = new ArrayList<>(List.of(
                new Relation<>(camera(), scene -> scene.cameras().stream().map(camera -> new InScene<>(scene, camera)), false),
                new Relation<>(LightTable.of(), scene -> scene.lights().stream().map(light -> new InScene<>(scene, light)), false),
                new Relation<>(material(), scene -> scene.materials().entrySet().stream().map(entry -> new InScene<>(scene, entry)), false),
                new Relation<>(KindTables.all(), KindTables::rows, false)));
        parts.addAll(KindTables.kinds());
        return List.copyOf(parts);
    }

    private static Table<InScene<Camera>> camera() {
        Map<String, Column<InScene<Camera>>> columns = new LinkedHashMap<>();
        columns.put("scene", Column.text("scene", row -> row.scene().name()));
        columns.putAll(MaterialColumns.inline(Camera.class, InScene::part));
        columns.put("direction", Column.vector("direction", row -> row.part().forward()));
        return new Table<>("camera", new ArrayList<>(columns.values()), List.of());
    }

    private static Table<InScene<Map.Entry<String, Material>>> material() {
        List<Column<InScene<Map.Entry<String, Material>>>> columns = new ArrayList<>(List.of(
                Column.text("scene", row -> row.scene().name()),
                Column.text("name", row -> row.part().getKey())));
        columns.addAll(MaterialColumns.of(row -> row.part().getValue()));
        return new Table<>("material", columns, List.of());
    }
}
