package cz.paprsek.fx.model.property;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.property.Targets.BodiesAt;
import cz.paprsek.fx.model.property.Targets.CamerasAt;
import cz.paprsek.fx.model.property.Targets.LightsAt;
import cz.paprsek.fx.model.property.Targets.MaterialsOf;
import cz.paprsek.fx.model.property.Targets.NamedMaterials;
import cz.paprsek.fx.model.property.Targets.Whole;
import cz.paprsek.material.Material;
import cz.paprsek.material.Share;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.shape.Shape;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Finds what can be changed about what is selected, or about the scene if nothing is. */
public final class Sections {
    private Sections() {}

    /** The sections for a state of the editor. Equal as long as the same things of the same kinds are selected. */
    public static List<Section> of(EditorState state) {
        List<Section> sections = new ArrayList<>();
        List<BodyAt> bodies = Places.bodies(state.selection());
        List<LightAt> lights = Places.lights(state.selection());
        if (!bodies.isEmpty()) {
            addBodies(state.scene(), bodies, sections);
        }
        if (!lights.isEmpty()) {
            add("section.light", new LightsAt(lights), state.scene(), sections);
        }
        List<CameraAt> cameras = Places.cameras(state.selection());
        if (!cameras.isEmpty()) {
            add("section.camera", new CamerasAt(cameras), state.scene(), sections);
        }
        if (sections.isEmpty()) {
            add("section.scene", Whole.SCENE, state.scene(), sections);
            add("section.picture", Whole.SETTINGS, state.scene(), sections);
        }
        return List.copyOf(sections);
    }

    /** The section for a named material. */
    public static Section material(Scene scene, String name) {
        Target target = new NamedMaterials(Set.of(name));
        return new Section("section.material", made(target, target.read(scene)));
    }

    /** Not the number of a share that a pattern says. */
    private static List<Property> made(Target target, List<? extends Record> materials) {
        List<Property> properties = within(target, List.of(), materials);
        properties.removeIf(number -> number.path().size() == 1 && number.trait().kind() == Trait.Kind.SHARE
                && materials.stream().anyMatch(material -> !(Records.get(((Material) material).shares(),
                        Records.component(Material.Shares.class, number.name()).orElseThrow()) instanceof Share.Even)));
        return properties;
    }

    private static void addBodies(Scene scene, List<BodyAt> places, List<Section> sections) {
        Target target = new BodiesAt(places);
        List<? extends Record> bodies = target.read(scene);
        add("section.object", target, scene, sections);
        List<Shape> shapes = bodies.stream().map(body -> ((Body) body).shape()).toList();
        List<String> kinds = shapes.stream().map(Shape::kind).distinct().limit(2).toList();
        sections.add(new Section(kinds.size() == 1 ? "kind." + kinds.get(0) : "section.shape",
                within(target, List.of("shape"), shapes)));
        sections.add(new Section("section.placement",
                within(target, List.of("placement"), bodies.stream().map(body -> ((Body) body).placement()).toList())));
        List<Property> material = new ArrayList<>();
        Records.component(Body.class, "material").ifPresent(component -> property(target, List.of(), component).ifPresent(material::add));
        Target made = new MaterialsOf(places);
        material.addAll(made(made, made.read(scene)));
        sections.add(new Section("section.material", material));
        sections.removeIf(section -> section.properties().isEmpty());
    }

    /** Adds what is stated by the records themselves, but for names if they are several, and materials, which have a section of their own. */
    private static void add(String title, Target target, Scene scene, List<Section> sections) {
        List<? extends Record> records = target.read(scene);
        List<Property> properties = within(target, List.of(), records).stream()
                .filter(property -> property.trait().kind() != Trait.Kind.MATERIAL)
                .filter(property -> records.size() == 1 || !property.name().equals("name"))
                .toList();
        sections.add(new Section(title, properties));
    }

    /** The components that all records have, and of those with a choice of kinds also what they have within. */
    private static List<Property> within(Target target, List<String> path, Collection<?> records) {
        List<Property> found = new ArrayList<>();
        for (RecordComponent component : common(records)) {
            property(target, path, component).ifPresent(property -> {
                found.add(property);
                if (property.trait().kind() == Trait.Kind.ALTERNATIVE) {
                    found.addAll(within(target, property.path(), values(records, component)));
                }
            });
            // What belongs together, as where a pattern lies.
            if ((!path.isEmpty() || component.getType() == Material.Shares.class) && component.getType().isRecord() && Traits.of(component).isEmpty()) {
                found.addAll(within(target, longer(path, component), values(records, component)));
            }
        }
        return found;
    }

    private static Optional<Property> property(Target target, List<String> path, RecordComponent component) {
        return Traits.of(component).map(trait -> new Property(target, longer(path, component), component.getType(), trait));
    }

    private static List<String> longer(List<String> path, RecordComponent component) {
        List<String> longer = new ArrayList<>(path);
        longer.add(component.getName());
        return longer;
    }

    private static List<Object> values(Collection<?> records, RecordComponent component) {
        return records.stream().map(record -> value((Record) record, component.getName())).toList();
    }

    /** The components of the first record that those of all other kinds have too. */
    private static Collection<RecordComponent> common(Collection<?> records) {
        List<? extends Class<?>> kinds = records.stream().map(Object::getClass).distinct().toList();
        Map<String, RecordComponent> common = new LinkedHashMap<>();
        for (Class<?> kind : kinds) {
            if (kind == kinds.get(0)) {
                Records.components(kind).forEach(component -> common.put(component.getName(), component));
            } else {
                common.values().removeIf(component -> Records.component(kind, component.getName())
                        .filter(other -> other.getType() == component.getType()).isEmpty());
            }
        }
        return common.values();
    }

    private static Object value(Record record, String name) {
        return Records.get(record, Records.component(record.getClass(), name).orElseThrow());
    }
}
