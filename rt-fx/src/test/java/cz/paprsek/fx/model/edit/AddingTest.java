package cz.paprsek.fx.model.edit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AddingTest {
    @Test
    void middleOfAnEmptySceneIsSeenByTheFirstCamera() {
        assertThat(Sight.of(EditorState.of(Scene.EMPTY))).isEqualTo(new Sight(new Vec3(0, 1, 0), 1));
    }

    @Test
    void targetOfTheCameraIsWhereTheUserLooks() {
        Scene scene = Scene.EMPTY.withCamera(Camera.lookingAt(new Vec3(0, 0, 10), new Vec3(2, 3, 0)));
        assertThat(Sight.of(EditorState.of(scene)).point()).isEqualTo(new Vec3(2, 3, 0));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 1, 1e6})
    void newThingsAreAsLargeAsTheSceneIs(double scale) {
        Scene scene = Scene.EMPTY.withCamera(Camera.looking(new Vec3(0, 0, 5 * scale), new Vec3(0, 0, -1)))
                .plus(SceneObject.of(new Sphere(scale)));
        assertThat(Sight.of(EditorState.of(scene)).size() / scale).isBetween(0.5, 2.0);
    }

    @Test
    void middleOfTheShapeIsWhereTheUserLooks() {
        EditorState after = Adding.shape(EditorState.of(Scene.EMPTY), new Cylinder(1, 4), "rod", new Sight(new Vec3(1, 2, 3), 1));
        assertThat(after.scene().objects().get(0).placement().position()).isEqualTo(new Vec3(1, 0, 3));
        assertThat(after.selection()).containsExactly(ScenePath.body(0));
    }

    @Test
    void planeIsTheGroundUnderWhatThereIs() {
        EditorState state = EditorState.of(Scene.EMPTY.plus(SceneObject.of(new Sphere(2)).at(0, 1, 0)));
        EditorState after = Adding.shape(state, new Plane(), "ground", Sight.of(state));
        assertThat(after.scene().objects().get(1).placement().position()).isEqualTo(new Vec3(0, -1, 0));
    }

    @Test
    void everyKindOfLightLightsWhatIsSeenAsBrightlyAsTheOthers() {
        Scene floor = Scene.EMPTY.plus(SceneObject.of(new cz.paprsek.shape.Disc(0.1)).rotated(-90, 0, 0));
        for (Light kind : Adding.LIGHTS) {
            Scene lit = Adding.light(EditorState.of(floor), kind, "lamp", new Sight(Vec3.ZERO, 2)).scene();
            double bright = cz.paprsek.render.RenderScene.of(lit).explainRay(new Vec3(0, 0.01, 0), new Vec3(0, -1, 0), 1).light().red();
            assertThat(bright).as("%s", kind).isCloseTo(0.8 * 4 / Math.sqrt(24), org.assertj.core.api.Assertions.within(0.05));
        }
    }

    /** −0 is another number than 0, and reads as if it were wrong. */
    @Test
    void nothingIsTurnedByLessThanNothing() {
        Scene scene = Scene.EMPTY.withCamera(Camera.looking(new Vec3(0, 5, 0), new Vec3(1, 0, 1)));
        Light panel = Adding.light(EditorState.of(scene), Adding.LIGHTS.get(2), "lamp", new Sight(new Vec3(-0.001, 0, 0), 2)).scene().lights().get(0);
        Vec3 turned = ((AreaLight) panel).rotation();
        assertThat(turned).isEqualTo(new Vec3(turned.x() + 0.0, turned.y() + 0.0, turned.z() + 0.0));
    }

    @Test
    void lightStandsAboveAndOutsideWhatIsSeen() {
        EditorState after = Adding.light(EditorState.of(Scene.EMPTY), Light.at(0, 0, 0), "lamp", new Sight(Vec3.ZERO, 2));
        assertThat(LightMoves.place(after.scene().lights().get(0))).isEqualTo(new Vec3(-2, 4, 2));
    }

    @Test
    void examplesAreAboutAsLargeAsAsked() {
        Examples.ofSize(0.2).stream().map(shape -> shape.bounds()).filter(Bounds::isFinite)
                .forEach(box -> assertThat(box.maxX() - box.minX()).isBetween(0.15, 0.25));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.5, 2, 100})
    void examplesAreAlikeAtAnySize(double size) {
        List<Shape> small = Examples.ofSize(1);
        List<Shape> large = Examples.ofSize(size);
        for (int i = 0; i < small.size(); i++) {
            Bounds one = small.get(i).bounds();
            Bounds other = large.get(i).bounds();
            if (one.isFinite()) {
                assertThat(other.maxX() - other.minX()).as(small.get(i).kind()).isCloseTo(size * (one.maxX() - one.minX()), within(1e-9 * size));
                assertThat(other.maxY() - other.minY()).as(small.get(i).kind()).isCloseTo(size * (one.maxY() - one.minY()), within(1e-9 * size));
                assertThat(other.maxZ() - other.minZ()).as(small.get(i).kind()).isCloseTo(size * (one.maxZ() - one.minZ()), within(1e-9 * size));
            }
        }
        assertThat(large).hasSameSizeAs(small);
    }
}
