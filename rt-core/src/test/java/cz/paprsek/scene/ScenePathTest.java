package cz.paprsek.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.MaterialAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import cz.paprsek.xml.RandomScenes;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

class ScenePathTest {
    private static final Material GLASS = Material.DEFAULT.withTransparency(0.9, 1.5);
    private static final Material OWN = Material.DEFAULT.withReflection(0.5);
    private static final SceneObject BOWL = SceneObject.of(Csg.difference(
            Operand.of(new Sphere(2)),
            Operand.of(Csg.union(Operand.of(new Sphere(1)), Operand.of(new Sphere(1)).named("left").at(-1, 0, 0).madeOf(OWN))).named("holes").at(2, 0, 0)))
            .named("bowl").at(0, 5, 0).madeOf("glass");
    private static final Scene SCENE = Scene.EMPTY.plus("glass", GLASS).plus(Light.at(1, 2, 3)).plus(Light.at(1, 2, 3).named("lamp"))
            .plus(SceneObject.of(new Sphere(1)), BOWL);

    @Test
    void everythingHasATextThatLeadsBackToIt() {
        Map<String, ScenePath> expected = Map.of(
                "sphere#1", ScenePath.body(0), "bowl", ScenePath.body(1), "bowl/sphere#1", ScenePath.body(1, 0),
                "bowl/holes/left", ScenePath.body(1, 1, 1), "camera:#1", ScenePath.camera(),
                "light:#1", ScenePath.light(0), "light:lamp", ScenePath.light(1), "material:glass", new MaterialAt("glass"));
        expected.forEach((text, path) -> {
            assertThat(path.text(SCENE)).isEqualTo(text);
            assertThat(ScenePath.parse(SCENE, text)).isEqualTo(path);
        });
    }

    @Test
    void whatIsInASceneIsToldWithoutTheScene() {
        assertThat(List.of(new InScene<>(SCENE, ScenePath.body(1, 1, 1)), new InScene<>(SCENE, ScenePath.light(1)), new InScene<>(SCENE, "word"), new InScene<>(SCENE, ScenePath.body(9))))
                .extracting(InScene::toString).containsExactly("bowl/holes/left", "light:lamp", "word", "BodyAt[numbers=[9]]");
    }

    @Test
    void camerasOfWhichThereAreSeveralAreToldApart() {
        Scene scene = SCENE.withCameras(List.of(Camera.DEFAULT, Camera.DEFAULT.named("above")));
        assertThat(ScenePath.parse(scene, "camera:above")).isEqualTo(ScenePath.camera(1));
        assertThat(ScenePath.camera(1).text(scene)).isEqualTo("camera:above");
        assertThat(ScenePath.parse(scene, "camera:#1")).isEqualTo(ScenePath.camera());
        assertThat(ScenePath.parse(scene, "camera:#2")).isEqualTo(ScenePath.camera(1));
    }

    @Test
    void aPlaceIsInASceneOrNot() {
        assertThat(List.of(ScenePath.camera(), ScenePath.light(1), new MaterialAt("glass"), ScenePath.body(1, 1, 1))).allMatch(at -> at.isIn(SCENE));
        assertThat(List.of(ScenePath.camera(1), ScenePath.light(2), new MaterialAt("gold"), ScenePath.body(1, 1, 2), ScenePath.body(2)))
                .noneMatch(at -> at.isIn(SCENE));
    }

    @Test
    void whatStandsAtPlacesIsChangedTheInnerFirstAndAllElseStaysTheVerySame() {
        Scene changed = SCENE.with(List.of(ScenePath.body(1), ScenePath.body(1, 1), ScenePath.body(1, 1, 1), ScenePath.body(7), ScenePath.body(1, 5)),
                (at, body) -> body.named(body.name() + at.numbers() + body.operands().stream().map(Operand::name).toList()));
        assertThat(changed.objects().get(0)).isSameAs(SCENE.objects().get(0));
        assertThat(changed.objects().get(1).name()).isEqualTo("bowl[1][, holes[1, 1][, left[1, 1, 1][]]]");
        Csg bowl = (Csg) changed.objects().get(1).shape();
        assertThat(bowl.operands().get(0)).isSameAs(((Csg) BOWL.shape()).operands().get(0));
    }

    @Test
    void aChangeThatChangesNothingLeavesTheVeryScene() {
        assertThat(SCENE.with(List.of(ScenePath.body(1, 1), ScenePath.body(0)), (at, body) -> body.named(body.name()))).isSameAs(SCENE);
        assertThat(SCENE.with(ScenePath.body(9), body -> body.named("x"))).isSameAs(SCENE);
    }

    @Test
    void aChangeThatMakesASceneThatCannotBeIsRefused() {
        assertThatThrownBy(() -> SCENE.with(ScenePath.body(0), body -> body.named("bowl"))).isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("already an object named \"bowl\"");
        assertThatThrownBy(() -> SCENE.with(ScenePath.body(1, 0), body -> body.madeOf(new MaterialName("unobtainium")))).isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("no material named \"unobtainium\"");
    }

    @Test
    void whatHasANameMayBeCalledByItsNumberToo() {
        assertThat(ScenePath.parse(SCENE, "difference#2/union#2/sphere#2")).isEqualTo(ScenePath.body(1, 1, 1));
        assertThat(ScenePath.parse(SCENE, "bowl/union#2/left")).isEqualTo(ScenePath.body(1, 1, 1));
        assertThat(ScenePath.parse(SCENE, "light:#2")).isEqualTo(ScenePath.light(1));
        assertThat(ScenePath.parse(SCENE, "material:#1")).isEqualTo(new MaterialAt("glass"));
    }

    @Test
    void inRandomScenesATextLeadsBackOrIsSharedAndRefused() {
        LongStream.range(0, 20).mapToObj(RandomScenes::of).forEach(scene -> {
            Map<String, List<BodyAt>> byText = ScenePath.bodies(scene).collect(Collectors.groupingBy(at -> at.text(scene)));
            assertThat(byText).hasSizeGreaterThan(10);
            byText.forEach((text, places) -> {
                if (places.size() == 1) {
                    assertThat(ScenePath.parse(scene, text)).isEqualTo(places.get(0));
                } else {
                    assertThatThrownBy(() -> ScenePath.parse(scene, text)).isInstanceOf(IllegalArgumentException.class)
                            .hasMessageContaining("may be any of " + places.size());
                }
            });
        });
    }

    @Test
    void aTextThatMayMeanTwoThingsIsRefused() {
        Scene slash = SCENE.plus(SceneObject.of(new Sphere(1)).named("bowl/holes"), SceneObject.of(new Sphere(1)).named("light:lamp"));
        assertThatThrownBy(() -> ScenePath.parse(slash, "bowl/holes"))
                .hasMessage("\"bowl/holes\" may be any of 2 things in this scene; give them names that tell them apart");
        assertThatThrownBy(() -> ScenePath.parse(slash, "light:lamp")).hasMessageContaining("may be any of 2 things");
        assertThat(ScenePath.parse(slash, "bowl/holes/left")).isEqualTo(ScenePath.body(1, 1, 1));
        assertThat(ScenePath.parse(slash, "sphere#3")).isEqualTo(ScenePath.body(2));
    }

    @Test
    void aTextThatLeadsNowhereIsRefusedWithWhatWasMeant() {
        assertThatThrownBy(() -> ScenePath.parse(SCENE, "bowl/hols")).hasMessage(
                "nothing in this scene is called \"bowl/hols\"; did you mean \"bowl/holes\"?");
        assertThatThrownBy(() -> ScenePath.parse(SCENE, "light:lmap")).hasMessageContaining("did you mean \"light:lamp\"?");
        for (String text : List.of("", "/", "bowl/", "#1", "sphere#0", "bowl/left", "param:n", "camera:", "sphere#1/sphere#1")) {
            assertThatThrownBy(() -> ScenePath.parse(SCENE, text)).isInstanceOf(IllegalArgumentException.class);
        }
    }

    @Test
    void aPlaceThatASceneDoesNotHaveIsRefused() {
        for (BodyAt nowhere : List.of(ScenePath.body(2), ScenePath.body(0, 0), ScenePath.body(1, 2), ScenePath.body(-1), ScenePath.body(1, -1))) {
            assertThat(nowhere.find(SCENE)).isEmpty();
            assertThatThrownBy(() -> nowhere.material(SCENE)).hasMessage("there is nothing at " + nowhere.numbers());
            assertThatThrownBy(() -> nowhere.text(SCENE)).isInstanceOf(IllegalArgumentException.class);
        }
        assertThatThrownBy(() -> ScenePath.light(2).text(SCENE)).hasMessage("there is no light #3 in this scene");
        assertThatThrownBy(() -> new MaterialAt("gold").text(SCENE)).hasMessage("there is no material named \"gold\" in this scene");
    }

    @Test
    void aMaterialIsItsOwnOrThatOfTheOperationsAroundOrTheDefault() {
        assertThat(ScenePath.body(0).material(SCENE)).isEqualTo(Material.DEFAULT);
        assertThat(ScenePath.body(0).source(SCENE)).isEqualTo(Inherited.INHERITED);
        assertThat(ScenePath.body(1, 1, 0).material(SCENE)).isEqualTo(GLASS);
        assertThat(ScenePath.body(1, 1, 0).materialName(SCENE)).isEqualTo("glass");
        assertThat(ScenePath.body(1, 1, 1).material(SCENE)).isEqualTo(OWN);
        assertThat(ScenePath.body(1, 1, 1).materialName(SCENE)).isEmpty();
    }

    @Test
    void theMapToTheWorldIsTheOneThatOperandsAreRenderedWith() {
        LongStream.range(0, 20).mapToObj(RandomScenes::of).forEach(scene -> {
            for (int i = 0; i < scene.objects().size(); i++) {
                Map<BodyAt, Affine> rendered = new HashMap<>();
                SceneObject object = scene.objects().get(i);
                object.shape().place(object.placement().toParent(), new Watched(ScenePath.body(i), rendered));
                assertThat(rendered).hasSize((int) ScenePath.body(i).withOperands(scene).count() - 1);
                rendered.forEach((at, toWorld) -> assertThat(at.toWorld(scene)).isEqualTo(toWorld));
                assertThat(ScenePath.body(i).toWorld(scene)).isEqualTo(object.placement().toParent());
            }
        });
    }

    @Test
    void aPointIsContainedWhereARayThatComesFromElsewhereIsInside() {
        Random random = new Random(5);
        int inside = 0;
        int tried = 0;
        for (BodyAt at : ScenePath.bodies(SCENE).toList()) {
            Volume placed = (Volume) at.placed(SCENE);
            for (int i = 0; i < 500; i++, tried++) {
                Vec3 point = near(placed.bounds(), random);
                boolean contained = at.contains(SCENE, point);
                assertThat(contained).isEqualTo(isInside(placed, point, random));
                if (at.in(SCENE).shape() instanceof Csg csg) {
                    assertThat(contained).isEqualTo(combined(at, csg, point));
                }
                inside += contained ? 1 : 0;
            }
        }
        assertThat(inside).isBetween(tried / 10, tried * 9 / 10);
    }

    @Test
    void aPathKnowsItsWayAndWhatItHolds() {
        BodyAt left = ScenePath.body(1, 1, 1);
        assertThat(left.way()).containsExactly(ScenePath.body(1), ScenePath.body(1, 1), left);
        assertThat(left.parent().child(1)).isEqualTo(left);
        assertThat(left.object()).isEqualTo(ScenePath.body(1)).isEqualTo(left.object().parent());
        assertThat(left.object().holds(left)).isTrue();
        assertThat(left.holds(left)).isFalse();
        assertThat(left.label(SCENE)).isEqualTo("sphere \"left\"");
        assertThat(ScenePath.body(1, 0).label(SCENE)).isEqualTo("sphere #1");
    }

    private static boolean combined(BodyAt at, Csg csg, Vec3 point) {
        boolean inside = at.child(0).contains(SCENE, point);
        for (int i = 1; i < csg.operands().size(); i++) {
            inside = csg.operation().inside(inside, at.child(i).contains(SCENE, point));
        }
        return inside;
    }

    private static boolean isInside(Volume placed, Vec3 point, Random random) {
        Vec3 direction = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
        Vec3 start = point.minus(direction.times(50));
        Spans spans = new Spans();
        Ray ray = new Ray(spans);
        ray.start(start.x(), start.y(), start.z(), direction.x(), direction.y(), direction.z());
        placed.spans(ray, spans);
        int before = 0;
        while (before < spans.size() && spans.t(before) < 50) {
            before++;
        }
        return before % 2 != 0;
    }

    private static Vec3 near(Bounds box, Random random) {
        return new Vec3(between(box.minX(), box.maxX(), random), between(box.minY(), box.maxY(), random), between(box.minZ(), box.maxZ(), random));
    }

    private static double between(double low, double high, Random random) {
        return low - 0.1 + (high - low + 0.2) * random.nextDouble();
    }

    /** Notes with which map each operand is placed. */
    private static final class Watched implements Parts {
        private final BodyAt at;
        private final Map<BodyAt, Affine> maps;
        private int operands;

        Watched(BodyAt at, Map<BodyAt, Affine> maps) {
            this.at = at;
            this.maps = maps;
        }

        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            return maker.apply(0);
        }

        @Override
        public Parts within(MaterialSource material, Affine toWorld) {
            BodyAt child = at.child(operands++);
            maps.put(child, toWorld);
            return new Watched(child, maps);
        }
    }
}
