package cz.paprsek.fx.model.edit;

import static cz.paprsek.fx.model.TestScenes.names;
import static cz.paprsek.scene.ScenePath.body;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.TestScenes;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class StructureTest {
    private final EditorState kitchen = TestScenes.kitchenState();

    @Test
    void addedObjectGetsAFreeNameAndTheSelection() {
        EditorState after = Structure.add(kitchen, SceneObject.of(new Sphere(1)).named("ball"));
        assertThat(names(after)).isEqualTo("ball, bowl, floor, ball 2, ball 3");
        assertThat(after.selection()).containsExactly(body(4));
    }

    @Test
    void addedLightGetsAFreeNameAndTheSelection() {
        EditorState after = Structure.add(kitchen, Light.at(0, 9, 0).named("key"));
        assertThat(after.scene().lights().get(2).name()).isEqualTo("key 2");
        assertThat(after.selection()).containsExactly(ScenePath.light(2));
    }

    @Test
    void aThousandAreCopiedEachAfterItsOriginalGroupedFreedAndDeleted() {
        Scene balls = Scene.EMPTY.withObjects(IntStream.range(0, 1000).mapToObj(i -> SceneObject.of(new Sphere(1)).named(i == 0 ? "ball" : "ball " + (i + 1)).at(i, 0, 0)).toList());
        List<ScenePath> all = ScenePath.bodies(balls).map(ScenePath.class::cast).toList();
        EditorState copied = Structure.duplicate(EditorState.of(balls), all, new Vec3(0, 5, 0));
        assertThat(copied.scene().objects().subList(0, 4).stream().map(SceneObject::name)).containsExactly("ball", "ball 1001", "ball 2", "ball 1002");
        assertThat(copied.selection()).containsExactlyElementsOf(IntStream.range(0, 1000).<ScenePath>mapToObj(i -> body(2 * i + 1)).toList());
        EditorState grouped = Structure.combine(copied, copied.selection(), Csg.Operation.UNION, "ball 1500");
        assertThat(grouped.scene().objects()).hasSize(1001);
        assertThat(grouped.selection()).containsExactly(body(1));
        assertThat(grouped.scene().objects().get(1).name()).isEqualTo("ball 1500");
        EditorState freed = Structure.dissolve(grouped, grouped.selection());
        assertThat(freed.scene().objects().subList(1, 1001)).isEqualTo(IntStream.range(0, 1000).mapToObj(i -> copied.scene().objects().get(2 * i + 1)).toList());
        assertThat(Structure.delete(freed, freed.selection()).scene()).isEqualTo(balls);
        assertThat(Structure.move(freed, freed.selection(), Optional.empty(), 2000).scene().objects().subList(0, 1000)).isEqualTo(balls.objects());
    }

    /** The lists and names that are made, bytes: of ten times as many about ten times as much, not a hundred times. */
    @Test
    void whatAnEditMakesGrowsAsWhatIsEdited() {
        assertGrowsLikewise("copying", (state, all) -> Structure.duplicate(state, all, Vec3.X));
        assertGrowsLikewise("combining", (state, all) -> Structure.combine(state, all, Csg.Operation.UNION, "all"));
        assertGrowsLikewise("freeing", Structure::dissolve);
        assertGrowsLikewise("deleting", Structure::delete);
        assertGrowsLikewise("moving", (state, all) -> Structure.move(state, all, Optional.empty(), 1));
    }

    private static void assertGrowsLikewise(String what, BiFunction<EditorState, List<BodyAt>, EditorState> edit) {
        made(20, edit);
        long few = made(200, edit);
        assertThat(made(2000, edit)).as(what).isBetween(5 * few, 20 * few);
    }

    /** By an edit of pairs of balls. */
    private static long made(int count, BiFunction<EditorState, List<BodyAt>, EditorState> edit) {
        Csg pair = Csg.union(Operand.of(new Sphere(1)).named("left"), Operand.of(new Sphere(1)).named("right").at(1, 0, 0));
        EditorState state = EditorState.of(Scene.EMPTY.withObjects(IntStream.range(0, count).mapToObj(i -> SceneObject.of(pair).named("pair " + i)).toList()));
        List<BodyAt> all = ScenePath.bodies(state.scene()).filter(at -> at.depth() == 0).toList();
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
        EditorState after = edit.apply(state, all);
        long made = threads.getThreadAllocatedBytes(Thread.currentThread().getId()) - before;
        assertThat(after).isNotSameAs(state);
        return made;
    }

    @Test
    void operandsFreedMayHaveTheNamesOfOperationsThatGo() {
        Scene scene = Scene.EMPTY.plus(SceneObject.of(Csg.union(Operand.of(new Sphere(1)).named("b"), Operand.of(new Sphere(2)).named("c"))).named("a"),
                SceneObject.of(Csg.union(Operand.of(new Sphere(3)).named("a"), Operand.of(new Sphere(4)).named("c"))).named("b"));
        assertThat(names(Structure.dissolve(EditorState.of(scene), List.of(body(0), body(1))))).isEqualTo("b, c, a, c 2");
    }

    @Test
    void whatIsNotTouchedStaysTheSameObject() {
        EditorState after = Structure.delete(kitchen, Set.of(body(0)));
        assertThat(names(after)).isEqualTo("bowl, floor, ball 2");
        assertThat(after.scene().objects().get(0)).isSameAs(kitchen.scene().objects().get(1));
    }

    @Test
    void selectionHiddenAndLockedFollowWhatTheyLedTo() {
        EditorState before = kitchen.withSelection(Set.of(body(1, 1, 1))).withHidden(Set.of(body(3))).withLocked(Set.of(ScenePath.light(1)));
        EditorState after = Structure.delete(before, List.of(body(0), body(1, 1, 0), ScenePath.light(0)));
        assertThat(after.selection()).containsExactly(body(0, 1, 0));
        assertThat(after.hidden()).containsExactly(body(2));
        assertThat(after.locked()).containsExactly(ScenePath.light(0));
    }

    @Test
    void operationThatLosesItsLastOperandGoesToo() {
        EditorState after = Structure.delete(kitchen, List.of(body(1, 1, 0), body(1, 1, 1)));
        assertThat(body(1).in(after.scene()).operands()).extracting(Operand::name).containsExactly("outer");
        assertThat(names(Structure.delete(after, List.of(body(1, 0))))).isEqualTo("ball, floor, ball 2");
    }

    @Test
    void deletingTheCameraDeletesNothing() {
        assertThat(Structure.delete(kitchen, Set.of(ScenePath.camera())).scene()).isEqualTo(kitchen.scene());
    }

    @Test
    void copiesStandBesideTheirOriginals() {
        EditorState after = Structure.duplicate(kitchen, List.of(body(0), body(1, 0), ScenePath.light(0)), new Vec3(0, 0, 2));
        assertThat(names(after)).isEqualTo("ball, ball 3, bowl, floor, ball 2");
        assertThat(after.selection()).containsExactly(body(1), body(2, 1), ScenePath.light(2));
        assertThat(after.scene().objects().get(1).placement().position()).isEqualTo(new Vec3(0, 0, 2));
        // The bowl is turned by 90° about y: two units along the world's z are two along its own −x.
        assertThat(body(2, 1).in(after.scene()).placement().position()).isEqualTo(new Vec3(-2, 0, 0));
        assertThat(after.scene().lights().get(2)).isEqualTo(Light.at(4, 6, 7).named("key 2"));
    }

    @Test
    void reorderingCountsPlacesAsTheyWere() {
        EditorState selected = kitchen.withSelection(Set.of(body(0)));
        EditorState down = Structure.move(selected, List.of(body(0)), Optional.empty(), 3);
        assertThat(names(down)).isEqualTo("bowl, floor, ball, ball 2");
        assertThat(down.selection()).containsExactly(body(2));
        assertThat(names(Structure.move(kitchen, List.of(body(3)), Optional.empty(), 0))).isEqualTo("ball 2, ball, bowl, floor");
        assertThat(names(Structure.move(kitchen, List.of(body(1)), Optional.empty(), 1))).isEqualTo("ball, bowl, floor, ball 2");
    }

    @Test
    void regroupedObjectStaysWhereItIs() {
        Scene before = kitchen.scene();
        EditorState in = Structure.move(kitchen, List.of(body(0)), Optional.of(body(1, 1)), 1);
        assertThat(names(in)).isEqualTo("bowl, floor, ball 2");
        assertThat(body(0, 1, 1).in(in.scene()).name()).isEqualTo("ball");
        assertSame(body(0, 1, 1).toWorld(in.scene()), body(0).toWorld(before));

        EditorState out = Structure.move(kitchen, List.of(body(1, 1, 0)), Optional.empty(), 0);
        assertThat(names(out)).isEqualTo("hole, ball, bowl, floor, ball 2");
        assertSame(body(0).toWorld(out.scene()), body(1, 1, 0).toWorld(before));
    }

    @Test
    void objectCannotBePutIntoItselfOrIntoAPrimitive() {
        assertThatThrownBy(() -> Structure.move(kitchen, List.of(body(1)), Optional.of(body(1, 1)), 0))
                .hasMessageContaining("not itself");
        assertThatThrownBy(() -> Structure.move(kitchen, List.of(body(1)), Optional.of(body(0)), 0))
                .hasMessageContaining("only an operation");
    }

    @Test
    void lightsAreReorderedWithTheirSelection() {
        EditorState after = Structure.moveLight(kitchen.withSelection(Set.of(ScenePath.light(0))), ScenePath.light(0), 2);
        assertThat(after.scene().lights()).extracting(Light::name).containsExactly("fill", "key");
        assertThat(after.selection()).containsExactly(ScenePath.light(1));
    }

    @Test
    void differenceTakesTheOthersFromTheFirstSelected() {
        EditorState after = Structure.combine(kitchen, List.of(body(3), body(0)), Csg.Operation.DIFFERENCE, "part");
        assertThat(names(after)).isEqualTo("bowl, floor, part");
        assertThat(after.selection()).containsExactly(body(2));
        assertThat(body(2).in(after.scene()).operands()).extracting(Operand::name).containsExactly("ball 2", "ball");
    }

    @Test
    void operandsCombineWithinTheirOperation() {
        EditorState after = Structure.combine(kitchen, List.of(body(1, 1, 0), body(1, 1, 1)), Csg.Operation.INTERSECTION, "");
        assertThat(body(1, 1, 0).in(after.scene()).operands()).hasSize(2);
        assertThat(after.selection()).containsExactly(body(1, 1, 0));
    }

    @Test
    void surfaceCannotBeCombined() {
        assertThatThrownBy(() -> Structure.combine(kitchen, List.of(body(0), body(2)), Csg.Operation.UNION, ""))
                .isInstanceOf(IllegalArgumentException.class).hasMessageContaining("rectangle has no inside");
        assertThatThrownBy(() -> Structure.combine(kitchen, List.of(body(0)), Csg.Operation.UNION, "")).hasMessageContaining("at least two");
    }

    @Test
    void dissolvedOperandsStayWhereTheyAreAndWhatTheyAreMadeOf() {
        EditorState after = Structure.dissolve(kitchen, List.of(body(1)));
        assertThat(names(after)).isEqualTo("ball, outer, cut, floor, ball 2");
        assertThat(after.selection()).containsExactly(body(1), body(2));
        assertThat(after.scene().objects().get(1).material()).isEqualTo(new MaterialName("red"));
        assertThat(after.scene().objects().get(2).material()).isEqualTo(TestScenes.BLUE);
        assertThat(after.scene().objects().get(2).placement().position()).isEqualTo(new Vec3(3.25, 0, 0));
        assertThat(after.scene().objects().get(2).placement().rotation()).isEqualTo(new Vec3(0, 90, 0));
        assertThatThrownBy(() -> Structure.dissolve(kitchen, List.of(body(0)))).hasMessageContaining("select a union");
    }

    @Test
    void combiningAndDissolvingGivesTheSceneBack() {
        EditorState after = Structure.dissolve(Structure.combine(kitchen, List.of(body(0), body(1)), Csg.Operation.UNION, ""), List.of(body(0)));
        assertThat(after.scene()).isEqualTo(kitchen.scene());
    }

    @Test
    void shearIsRefusedInWords() {
        Csg turnedInside = Csg.union(Operand.of(new Sphere(1)).rotated(0, 0, 30), Operand.of(new Sphere(2)));
        Scene scene = Scene.EMPTY.plus(SceneObject.of(turnedInside).scaled(1, 2, 1));
        assertThatThrownBy(() -> Structure.dissolve(EditorState.of(scene), List.of(body(0)))).hasMessageContaining("shear");
    }

    @Test
    void renamingReachesOperandsAndLights() {
        assertThat(body(1, 1, 0).find(Structure.rename(kitchen, body(1, 1, 0), "pit").scene()).orElseThrow().name()).isEqualTo("pit");
        assertThat(Structure.rename(kitchen, ScenePath.light(1), "lamp").scene().lights().get(1).name()).isEqualTo("lamp");
        assertThatThrownBy(() -> Structure.rename(kitchen, ScenePath.light(1), "key")).hasMessageContaining("already a light named");
    }

    @Test
    void lockedOperationLocksItsOperands() {
        EditorState after = Structure.lock(kitchen, Set.of(body(1)), true);
        assertThat(after.isLocked(body(1, 0))).isTrue();
        assertThat(Structure.lock(after, Set.of(body(1)), false).isLocked(body(1, 0))).isFalse();
    }

    @Test
    void materialOfACombinationIsTheOperandsOwn() {
        EditorState after = Structure.combine(kitchen, List.of(body(0), body(3)), Csg.Operation.UNION, "");
        Body union = body(0).in(after.scene());
        assertThat(union.material()).isEqualTo(Inherited.INHERITED);
        assertThat(union.operands().get(0).material()).isEqualTo(new MaterialName("red"));
    }

    private static void assertSame(Affine actual, Affine expected) {
        for (Vec3 p : List.of(Vec3.ZERO, Vec3.X, Vec3.Y, Vec3.Z)) {
            assertThat(actual.point(p).minus(expected.point(p)).length()).isCloseTo(0, within(1e-12));
        }
    }

    private static Animation rising(String target) {
        return new Animation(target, "position", Animation.Turning.ANGLES, List.of(new Animation.Key(0, "0 1 0", Animation.Ease.LINEAR), new Animation.Key(1, "0 2 0", Animation.Ease.LINEAR)));
    }

    private static List<String> animated(EditorState state) {
        return state.scene().animations().stream().map(Animation::target).toList();
    }

    @Test
    void animationsFollowWhatTheyAreOfAndGoWithIt() {
        Scene scene = Scene.EMPTY.withCameras(List.of(Camera.DEFAULT.named("near"), Camera.DEFAULT.named("far")))
                .plus(SceneObject.of(new Sphere(1)).named("a")).plus(SceneObject.of(new Sphere(2)).named("b")).plus(Light.at(0, 9, 0)).plus(Light.at(0, 8, 0));
        EditorState state = EditorState.of(scene.withAnimations(List.of(rising("a"), rising("sphere#2"), rising("light:#2"), rising("camera:far"))));
        assertThat(animated(Structure.rename(state, body(0), "c"))).containsExactly("c", "sphere#2", "light:#2", "camera:far");
        assertThat(animated(Structure.rename(state, ScenePath.light(1), "lamp"))).containsExactly("a", "sphere#2", "light:#2", "camera:far");
        assertThat(animated(Structure.rename(state, ScenePath.camera(1), "eye"))).containsExactly("a", "sphere#2", "light:#2", "camera:eye");
        assertThat(animated(Structure.delete(state, Set.of(body(0))))).as("the other one is the first sphere now").containsExactly("b", "light:#2", "camera:far");
        assertThat(animated(Structure.delete(state, Set.of(ScenePath.light(0), ScenePath.camera(1))))).containsExactly("a", "sphere#2", "light:#1");
        assertThat(animated(Structure.delete(state, Set.of(body(0), body(1), ScenePath.light(1), ScenePath.camera(1))))).isEmpty();
        EditorState both = Structure.combine(state, List.of(body(1), body(0)), Csg.Operation.UNION, "both");
        assertThat(animated(both)).containsExactly("both/a", "both/b", "light:#2", "camera:far");
        assertThat(animated(Structure.dissolve(both, Set.of(body(0))))).containsExactly("a", "b", "light:#2", "camera:far");
        assertThat(animated(Cameras.first(state, 1))).isEqualTo(animated(state));
    }
}
