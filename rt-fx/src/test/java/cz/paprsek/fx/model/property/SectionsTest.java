package cz.paprsek.fx.model.property;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.attribute.ElementTable;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.Adding;
import cz.paprsek.fx.model.edit.Examples;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.height.HeightField;
import cz.paprsek.shape.mesh.Triangles;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

class SectionsTest {
    static final List<Locale> LANGUAGES = Texts.LANGUAGES;

    private final Scene scene = Scene.EMPTY
            .plus("steel", Material.color(180, 190, 200))
            .plus(Light.at(1, 2, 3)).plus(Light.at(4, 5, 6))
            .plus(SceneObject.of(new Sphere(0.5)).named("ball").madeOf("steel"),
                    SceneObject.of(new Cone(2, 3)).madeOf(Material.color(255, 0, 0)),
                    SceneObject.of(new Sphere(0.5)).at(1, 0, 0).madeOf(Material.DEFAULT));

    /** A number that counts how often it is asked for. */
    record Counted(double number, AtomicInteger asked) {
        @Override
        public double number() {
            asked.incrementAndGet();
            return number;
        }
    }

    /** A thing that has one. */
    record Thing(Counted has) {}

    @Test
    void whatAThousandThingsHaveTogetherIsReadOnce() {
        Counted same = new Counted(7, new AtomicInteger());
        Counted other = new Counted(8, new AtomicInteger());
        List<Thing> things = new ArrayList<>(Collections.nCopies(1000, new Thing(same)));
        assertThat(number(things)).contains(7.0);
        assertThat(same.asked()).hasValue(1);
        things.add(new Thing(new Counted(7, new AtomicInteger())));
        assertThat(number(things)).contains(7.0);
        things.add(new Thing(other));
        things.addAll(Collections.nCopies(1000, new Thing(same)));
        assertThat(number(things)).isEmpty();
        assertThat(other.asked()).hasValue(1);
    }

    private static Optional<Object> number(List<Thing> things) {
        return new Property(new Target() {
            @Override
            public List<? extends Record> read(Scene scene) {
                return things;
            }

            @Override
            public Optional<Spot> spot(Scene scene) {
                return Optional.empty();
            }

            @Override
            public Scene change(Scene scene, UnaryOperator<Record> change) {
                return scene;
            }
        }, List.of("has", "number"), double.class, Trait.of(Trait.Kind.NUMBER)).read(Scene.EMPTY);
    }

    @Test
    void sceneIsShownWhenNothingIsSelected() {
        assertThat(titles(Set.of())).containsExactly("section.scene", "section.picture");
        assertThat(names(Set.of())).containsExactly("name", "description", "tags", "background", "sky", "ambient", "width", "height", "maxDepth", "integrator", "samples",
                "mostSamples", "error", "confidence", "filter", "exposure", "tone", "fps", "shutter");
    }

    @Test
    void componentsOfASelectedThingArePropertiesInOrder() {
        assertThat(titles(Set.of(ScenePath.body(0)))).containsExactly("section.object", "kind.sphere", "section.placement", "section.material");
        assertThat(names(Set.of(ScenePath.body(0)))).containsExactly("name", "pivot", "hidden", "radius", "position", "rotation", "scale", "material", "pattern", "color",
                "diffusion", "specular", "shininess", "reflection", "transparency", "refractiveIndex", "fresnel", "roughness", "thin", "attenuationColor", "attenuationDistance", "emission", "emissionStrength",
                "diffusion", "specular", "reflection", "transparency", "roughness", "relief");
        assertThat(names(Set.of(ScenePath.light(0)))).containsExactly("name", "position", "color", "intensity", "referenceDistance");
        assertThat(names(Set.of(ScenePath.camera()))).containsExactly("name", "position", "aim", "vector", "up", "lens", "fovy", "aperture", "focus");
    }

    @Test
    void severalThingsShowWhatTheyHaveInCommon() {
        Set<ScenePath> both = Set.of(ScenePath.body(0), ScenePath.body(1));
        assertThat(titles(both)).containsExactly("section.object", "section.shape", "section.placement", "section.material");
        assertThat(names(both)).startsWith("pivot", "hidden", "radius", "position").doesNotContain("name", "height", "topRadius");
        assertThat(read("radius", both)).isEmpty();
        assertThat(read("scale", both)).contains(Vec3.ONE);
        assertThat(names(Set.of(ScenePath.body(0), ScenePath.light(1)))).contains("radius", "intensity");
    }

    @Test
    void whatCountsIsShown_notWhatStandsForNoneGiven() {
        Camera down = Camera.looking(new Vec3(0, 5, 0), new Vec3(0, -1, 0));
        SpotLight narrow = SpotLight.from(new Vec3(0, 3, 0), Vec3.ZERO).withAngles(30, 20);
        Scene other = scene.withLights(List.of(narrow)).withCamera(down);
        assertThat(property("innerAngle", Set.of(ScenePath.light(0)), other).read(other)).contains(20.0);
        assertThat(property("outerAngle", Set.of(ScenePath.light(0)), other).write(other, 40.0).lights()).containsExactly(narrow.withAngles(30, 40));
        assertThat(property("up", Set.of(ScenePath.camera()), other).read(other)).contains(Vec3.Z.negated());
        assertThat(property("referenceDistance", Set.of(ScenePath.light(0)), other).read(other)).contains(0.0);
        assertThat(property("mostSamples", Set.of()).read(scene)).contains(0);
    }

    @Test
    void writingChangesAllAndNothingElse() {
        Set<ScenePath> all = items(ScenePath.body(0), ScenePath.body(1), ScenePath.body(2));
        Scene after = property("radius", all).write(scene, 7.0);
        assertThat(after.objects()).extracting(SceneObject::shape).containsExactly(new Sphere(7), new Cone(7, 3), new Sphere(7));
        assertThat(after.withObjects(scene.objects())).isEqualTo(scene);
        assertThat(property("position", all).part("y").write(scene, 9.0).objects()).extracting(object -> object.placement().position())
                .containsExactly(new Vec3(0, 9, 0), new Vec3(0, 9, 0), new Vec3(1, 9, 0));
    }

    @Test
    void materialIsChangedWhereItIsStated() {
        Scene after = property("diffusion", items(ScenePath.body(0), ScenePath.body(1))).write(scene, 0.25);
        assertThat(after.materials().get("steel")).extracting(Material::diffusion).isEqualTo(0.25);
        assertThat(((Material) after.objects().get(1).material()).diffusion()).isEqualTo(0.25);
        assertThat(after.objects().get(2)).isSameAs(scene.objects().get(2));
    }

    @Test
    void refusalIsTheRecordsOwn() {
        assertThatThrownBy(() -> property("radius", Set.of(ScenePath.body(0))).write(scene, -1.0))
                .isInstanceOf(IllegalArgumentException.class).hasMessage("sphere radius must be a finite number above 0, but is -1");
        assertThatThrownBy(() -> property("samples", Set.of()).write(scene, 99)).hasMessageContaining("from 1 to 16");
    }

    @Test
    void otherKindKeepsWhatItCan() {
        Property pattern = property("pattern", Set.of(ScenePath.body(1)));
        Scene checkered = Alternatives.choose(pattern, scene, Pattern.Checker.class);
        assertThat(((Pattern.Checker) ((Material) checkered.objects().get(1).material()).pattern()).even()).isEqualTo(new Rgb(255, 0, 0));
        assertThat(Alternatives.choose(pattern, checkered, Pattern.Plain.class)).isEqualTo(scene);
        Property aim = property("aim", Set.of(ScenePath.camera()));
        Scene aimed = Alternatives.choose(aim, scene, Camera.Target.class);
        assertThat(aimed.camera().forward()).isEqualTo(scene.camera().forward());
        assertThat(Alternatives.choose(aim, aimed, Camera.Direction.class).camera().forward()).isEqualTo(scene.camera().forward());
    }

    @Test
    void operationOfCsgIsAProperty() {
        Scene csg = Scene.EMPTY.plus(SceneObject.of(Csg.union(new Sphere(1), new Sphere(2))));
        EditorState state = EditorState.of(csg).withSelection(Set.of(ScenePath.body(0)));
        Property operation = Sections.of(state).stream().flatMap(section -> section.properties().stream())
                .filter(p -> p.name().equals("operation")).findFirst().orElseThrow();
        assertThat(((Csg) operation.write(csg, Csg.Operation.DIFFERENCE).objects().get(0).shape()).operation()).isEqualTo(Csg.Operation.DIFFERENCE);
    }

    @Test
    void sectionsStayEqualWhileValuesChange() {
        EditorState state = EditorState.of(scene).withSelection(Set.of(ScenePath.body(0)));
        assertThat(Sections.of(state.withScene(property("radius", Set.of(ScenePath.body(0))).write(scene, 3.0)))).isEqualTo(Sections.of(state));
    }

    /** What a new kind of shape must not forget: an example to add, an icon does with the general one, and a label for each component. */
    @ParameterizedTest
    @FieldSource("LANGUAGES")
    void everyKindOfShapeHasAnExampleAndEveryPropertyALabel(Locale language) {
        List<Shape> examples = Examples.ofSize(2);
        assertThat(examples.stream().<Class<?>>map(Object::getClass)).containsExactlyInAnyOrderElementsOf(
                ElementTable.of(Shape.class).filter(kind -> kind != Csg.class && kind != Mesh.class && kind != HeightField.class).toList());
        Texts texts = Texts.in(language);
        List<SceneObject> objects = new ArrayList<>(examples.stream().map(SceneObject::of).toList());
        objects.add(SceneObject.of(Csg.union(new Sphere(1))));
        // What a file holds nobody can make up.
        objects.add(SceneObject.of(Mesh.of("ring.ply")));
        Scene all = Scene.EMPTY.withLights(Adding.LIGHTS).withObjects(objects.stream().map(object -> object.madeOf(Material.DEFAULT)).toList());
        Stream<Set<ScenePath>> selections = Stream.concat(
                Stream.concat(Stream.of(Set.of(), Set.of(ScenePath.camera())), IntStream.range(0, Adding.LIGHTS.size()).mapToObj(i -> Set.of(ScenePath.light(i)))), IntStream.range(0, objects.size()).mapToObj(i -> Set.of(ScenePath.body(i))));
        selections.flatMap(items -> Sections.of(EditorState.of(all).withSelection(items)).stream()).forEach(section -> {
            assertThat(texts.of(section.title())).isNotBlank();
            section.properties().forEach(property -> {
                assertThat(texts.of(property.label())).isNotBlank();
                property.trait().presets().forEach(preset -> assertThat(texts.of(preset.name())).isNotBlank());
            });
        });
    }

    @Test
    void aMeshKeepsItsTrianglesWhileItsAngleIsChangedAndLosesThemWithItsFile() {
        Triangles one = Triangles.of(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
        Scene before = Scene.EMPTY.plus(SceneObject.of(Mesh.of("ring.ply").read(new Mesh.Whole("ring.ply", one, Map.of()))));
        Property angle = sections(Set.of(ScenePath.body(0)), before).stream().flatMap(section -> section.properties().stream())
                .filter(property -> property.name().equals("smoothAngle")).findFirst().orElseThrow();
        Mesh smooth = (Mesh) angle.write(before, 30.0).objects().get(0).shape();
        assertThat(smooth.smoothAngle()).isEqualTo(30);
        assertThat(smooth.triangles().hasNormals()).isTrue();
        Property file = sections(Set.of(ScenePath.body(0)), before).stream().flatMap(section -> section.properties().stream())
                .filter(property -> property.name().equals("file")).findFirst().orElseThrow();
        assertThat(((Mesh) file.write(before, "knot.ply").objects().get(0).shape()).isRead()).isFalse();
    }

    private static Set<ScenePath> items(ScenePath... items) {
        return new LinkedHashSet<>(List.of(items));
    }

    private List<Section> sections(Set<? extends ScenePath> items) {
        return sections(items, scene);
    }

    private static List<Section> sections(Set<? extends ScenePath> items, Scene of) {
        return Sections.of(EditorState.of(of).withSelection(items));
    }

    private List<String> titles(Set<? extends ScenePath> items) {
        return sections(items).stream().map(Section::title).toList();
    }

    private List<String> names(Set<? extends ScenePath> items) {
        return sections(items).stream().flatMap(section -> section.properties().stream()).map(Property::name).toList();
    }

    private Property property(String name, Set<? extends ScenePath> items) {
        return property(name, items, scene);
    }

    private static Property property(String name, Set<? extends ScenePath> items, Scene of) {
        return sections(items, of).stream().flatMap(section -> section.properties().stream())
                .filter(property -> property.name().equals(name)).findFirst().orElseThrow();
    }

    private Optional<Object> read(String name, Set<? extends ScenePath> items) {
        return property(name, items).read(scene);
    }
}
