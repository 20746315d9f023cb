package cz.paprsek.fx.model.edit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.contact.Falling;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.fx.model.edit.Arranging.Side;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Sphere;
import cz.paprsek.warning.SceneWarning;
import cz.paprsek.warning.SceneWarnings;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Bodies put in line, on the floor, in their roles; and things that are hardly meant, mended. */
class ArrangingTest {
    private static final Scene THREE = Scene.EMPTY.plus(ball(0.5, 1, 5, 0), ball(1, 4, 2, 0), ball(2, 9, 3, 0));
    private static final Set<ScenePath> ALL = new LinkedHashSet<>(List.of(ScenePath.body(1), ScenePath.body(0), ScenePath.body(2)));

    private static SceneObject ball(double radius, double x, double y, double z) {
        return SceneObject.of(new Sphere(radius)).at(x, y, z);
    }

    private static List<Vec3> positions(EditorState state) {
        return state.scene().objects().stream().map(object -> object.placement().position()).toList();
    }

    @Test
    void sidesComeIntoLineWithTheFirstSelected() {
        EditorState state = EditorState.of(THREE);
        assertThat(positions(Arranging.aligned(state, ALL, Axis.Y, Side.LEAST))).containsExactly(new Vec3(1, 1.5, 0), new Vec3(4, 2, 0), new Vec3(9, 3, 0));
        assertThat(positions(Arranging.aligned(state, ALL, Axis.X, Side.MOST))).containsExactly(new Vec3(4.5, 5, 0), new Vec3(4, 2, 0), new Vec3(3, 3, 0));
        assertThat(positions(Arranging.aligned(state, ALL, Axis.Y, Side.MIDDLE))).extracting(Vec3::y).containsOnly(2.0);
        assertThatThrownBy(() -> Arranging.aligned(state, Set.of(ScenePath.body(0)), Axis.X, Side.LEAST)).hasMessageContaining("at least two");
    }

    @Test
    void theOutermostStayWhenAllComeEquallyFarApart() {
        assertThat(positions(Arranging.distributed(EditorState.of(THREE), ALL, Axis.X))).extracting(Vec3::x).containsExactly(1.0, 5.0, 9.0);
    }

    @Test
    void aBodyFallsOntoWhatIsBelowItElseOntoTheFloor() {
        SceneObject table = SceneObject.of(new Block(new Vec3(-1, 0, -1), new Vec3(1, 2, 1))).rotated(0, 90, 0);
        SceneObject ground = SceneObject.of(new Plane()).at(0, -3, 0);
        Scene scene = Scene.EMPTY.plus(ball(0.5, 0, 7, 0), ball(0.5, 5, 7, 0), table);
        Set<ScenePath> balls = new LinkedHashSet<>(List.of(ScenePath.body(0), ScenePath.body(1)));
        assertThat(positions(Falling.onFloor(EditorState.of(scene), balls)).subList(0, 2)).containsExactly(new Vec3(0, 2.5, 0), new Vec3(5, 0.5, 0));
        assertThat(positions(Falling.onFloor(EditorState.of(scene.plus(ground)), balls)).get(1)).isEqualTo(new Vec3(5, -2.5, 0));
        EditorState locked = EditorState.of(scene).withLocked(Set.of(ScenePath.body(0)));
        assertThat(positions(Falling.onFloor(locked, balls)).get(0)).as("what is locked stays").isEqualTo(new Vec3(0, 7, 0));
    }

    @Test
    void anOperandBecomesTheBaseAndIsSeenAloneAndWithTheOthersAgain() {
        Csg bowl = Csg.difference(Operand.of(new Sphere(1)).named("ball"), Operand.of(new Sphere(2)).named("cutter"), Operand.of(new Sphere(3)).named("other"));
        EditorState state = EditorState.of(Scene.EMPTY.plus(SceneObject.of(bowl)));
        assertThat(names(Arranging.base(state, Set.of(ScenePath.body(0, 2))))).containsExactly("other", "ball", "cutter");
        assertThat(names(Arranging.base(state, Set.of(ScenePath.body(0))))).containsExactly("cutter", "ball", "other");
        EditorState solo = Arranging.solo(state, Set.of(ScenePath.body(0, 1)));
        assertThat(solo.scene()).as("the file stays").isEqualTo(state.scene());
        assertThat(Visible.of(solo).scene().objects()).as("a cutter as a body").containsExactly(SceneObject.of(Csg.union(bowl.operands().get(1))));
        assertThat(Visible.of(solo).original(ScenePath.body(0, 0))).isEqualTo(ScenePath.body(0, 1));
        assertThat(Visible.of(Arranging.solo(solo, Set.of(ScenePath.body(0, 2)))).scene().objects()).containsExactly(SceneObject.of(Csg.union(bowl.operands().get(2))));
        assertThat(Arranging.solo(solo, Set.of(ScenePath.body(0, 1)))).isEqualTo(state);
        assertThat(Arranging.role(state.scene(), ScenePath.body(0, 0))).contains(Arranging.Role.BASE);
        assertThat(Arranging.role(state.scene(), ScenePath.body(0, 1))).contains(Arranging.Role.CUTTER);
        assertThat(Arranging.role(state.scene(), ScenePath.body(0))).isEmpty();
    }

    private static List<String> names(EditorState state) {
        return ((Csg) state.scene().objects().get(0).shape()).operands().stream().map(Operand::name).toList();
    }

    static Stream<Scene> hardlyMeant() {
        Scene lit = Scene.EMPTY.withCamera(Camera.lookingAt(new Vec3(0, 0, 5), Vec3.ZERO)).plus(Light.at(3, 9, 9)).plus(ball(1, 0, 0, 0));
        Material red = Material.color(new Rgb(200, 0, 0));
        return Stream.of(
                lit.plus(ball(3, 0, 0, 4)), lit.plus(SceneObject.of(new Plane()).at(0, 1, 0)), lit.plus(SphereLight.of(new Vec3(0, 0, 5), 1)), lit.plus(Light.at(0, 0.2, 0)),
                lit.plus(SunLight.along(0, -1, 0).withDisc(0, true)), lit.plus("never", red), lit.plus(ball(1, 3, 0, 0).madeOf(red.withDiffusion(0.9).withReflection(0.6))),
                lit.plus(ball(1, 3, 0, 0).madeOf(Material.color(new Rgb(1, 0.5, 0)))), lit.withLights(List.of()),
                lit.plus(SceneObject.of(Csg.difference(Operand.of(new Sphere(1)), Operand.of(new Sphere(1)).at(5, 0, 0))).at(-4, 0, 0)));
    }

    @ParameterizedTest
    @MethodSource("hardlyMeant")
    void whatIsHardlyMeantIsMendedByAClick(Scene scene) {
        SceneWarning warning = SceneWarnings.of(scene).stream().findFirst().orElseThrow();
        EditorState mended = Mends.of(EditorState.of(scene), warning).map(Mends.Mended::result).orElseThrow();
        assertThat(SceneWarnings.of(mended.scene())).as(warning.message()).extracting(SceneWarning::kind).doesNotContain(warning.kind());
        assertThat(Mends.of(EditorState.of(scene), new SceneWarning("indices", "", Optional.empty(), "", "", false))).as("only the author knows").isEmpty();
    }

    /** Both stacks of two selected balls: one above the floor, one that has sunk into it. */
    @ParameterizedTest
    @ValueSource(doubles = {5.5, -2.5})
    void aStackComesOntoTheFloorAsAStack(double low) {
        EditorState state = EditorState.of(Scene.EMPTY.plus(ball(0.5, 0, low + 1, 0), ball(0.5, 0, low, 0)));
        Set<ScenePath> both = Set.of(ScenePath.body(0), ScenePath.body(1));
        assertThat(positions(Falling.onFloor(state, both))).containsExactly(new Vec3(0, 1.5, 0), new Vec3(0, 0.5, 0));
        EditorState locked = state.withLocked(Set.of(ScenePath.body(1)));
        assertThat(positions(Falling.onFloor(locked, both)).get(1)).as("what is locked stays").isEqualTo(new Vec3(0, low, 0));
    }

    @Test
    void whatIsLockedIsNeitherMovedNorRoundedNorMended() {
        SceneObject odd = ball(1, 1.0 / 3, 2, 0);
        EditorState arranged = EditorState.of(Scene.EMPTY.plus(odd, ball(1, 4, 5, 0))).withLocked(Set.of(ScenePath.body(0)));
        assertThat(Arranging.aligned(arranged, List.of(ScenePath.body(1), ScenePath.body(0)), Axis.Y, Side.LEAST).scene().objects().get(0)).isEqualTo(odd);
        Scene inside = Scene.EMPTY.withCamera(Camera.lookingAt(new Vec3(0, 0, 5), Vec3.ZERO)).plus(Light.at(3, 9, 9)).plus(ball(1, 0, 0, 0)).plus(ball(3, 0, 0, 4));
        SceneWarning camera = SceneWarnings.of(inside).stream().findFirst().orElseThrow();
        assertThat(Mends.of(EditorState.of(inside).withLocked(Set.of(ScenePath.camera())), camera)).isEmpty();
        assertThat(Mends.of(EditorState.of(inside).withLocked(Set.of(ScenePath.body(1))), camera)).as("the camera is moved, not the ball").isPresent();
        Scene cut = Scene.EMPTY.withCamera(Camera.lookingAt(new Vec3(0, 0, 5), Vec3.ZERO)).plus(Light.at(3, 9, 9))
                .plus(SceneObject.of(Csg.difference(Operand.of(new Sphere(1)), Operand.of(new Sphere(1)).at(5, 0, 0))));
        SceneWarning needless = SceneWarnings.of(cut).stream().filter(warning -> warning.kind().equals("operand")).findFirst().orElseThrow();
        assertThat(Mends.of(EditorState.of(cut), needless)).isPresent();
        assertThat(Mends.of(EditorState.of(cut).withLocked(Set.of(ScenePath.body(0))), needless)).isEmpty();
    }
}
