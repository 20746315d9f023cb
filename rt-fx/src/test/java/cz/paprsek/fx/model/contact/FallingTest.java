package cz.paprsek.fx.model.contact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Bodies put down, where closed forms say how far they fall. */
class FallingTest {
    private static final double NEAR = 1.5e-6;

    private static SceneObject ball(double radius, double x, double y, double z) {
        return SceneObject.of(new Sphere(radius)).at(x, y, z);
    }

    /** The first object, put down onto the others. */
    private static Vec3 down(SceneObject... objects) {
        return place(Falling.onFloor(EditorState.of(Scene.EMPTY.withObjects(List.of(objects))), Set.of(ScenePath.body(0))), 0);
    }

    private static Vec3 place(EditorState state, int index) {
        return state.scene().objects().get(index).placement().position();
    }

    /** The centre of a ball of half a unit is above a slope by that over the cosine; also of one that has sunk into it. */
    @ParameterizedTest
    @CsvSource({"0, 3", "30, 3", "60, 3", "30, 0.2", "45, -0.2"})
    void aBallLiesOnASlope(double degrees, double from) {
        SceneObject slope = SceneObject.of(new Plane()).placed(Placement.at(0, -9, 0).withRotation(new Vec3(0, 0, -degrees)));
        double foot = -9 - Math.tan(Math.toRadians(degrees));
        assertThat(down(ball(0.5, 1, foot + from, 0.3), slope).y()).isCloseTo(foot + 0.5 / Math.cos(Math.toRadians(degrees)), within(NEAR));
    }

    @Test
    void aBallLiesOnABallBesideItsMiddleAndInABowl() {
        assertThat(down(ball(1, 1.2, 9, 0.5), ball(2, 0, 2, 0)).y()).isCloseTo(2 + Math.sqrt(9 - 1.2 * 1.2 - 0.5 * 0.5), within(NEAR));
        SceneObject bowl = SceneObject.of(Csg.difference(Operand.of(new Sphere(3)), Operand.of(new Sphere(2.5)), Operand.of(new Block(new Vec3(-4, 1, -4), new Vec3(4, 4, 4))))).at(0, 3, 0);
        assertThat(down(ball(0.5, 0.6, 9, 0), bowl).y()).isCloseTo(3 - Math.sqrt(4 - 0.6 * 0.6), within(NEAR));
        assertThat(down(ball(0.5, 7, 9, 0), bowl).y()).as("beside it").isCloseTo(0.5, within(NEAR));
    }

    /** What only stands beside it does not hold it, nor what is above it or around its middle. */
    @Test
    void whatIsNotBelowHoldsNothing() {
        SceneObject cube = SceneObject.of(new Block(new Vec3(-0.5, -0.5, -0.5), new Vec3(0.5, 0.5, 0.5)));
        assertThat(down(cube.at(0, 5, 0), cube.at(1, 2, 0))).isEqualTo(new Vec3(0, 0.5, 0));
        assertThat(down(cube.at(0, 5, 0), cube.at(0.3, 8, 0))).isEqualTo(new Vec3(0, 0.5, 0));
        assertThat(down(cube.at(0, 5, 0), ball(9, 0, 6, 0))).isEqualTo(new Vec3(0, 0.5, 0));
    }

    /** Lines from below miss what is flat and stands upright: its box counts. */
    @Test
    void whatIsFlatStandsOnItsEdge() {
        SceneObject picture = SceneObject.of(new Rectangle(-1, 0, 1, 2)).at(0.3, 8, 0.2);
        SceneObject table = SceneObject.of(new Block(new Vec3(-1, 0, -1), new Vec3(1, 2, 1)));
        assertThat(down(picture, table).y()).isCloseTo(2, within(NEAR));
        assertThat(down(picture.rotated(90, 0, 0), table).y()).as("lying").isCloseTo(2, within(NEAR));
    }

    /** Of a stack of balls beside each other's middles, which all fall by the same. */
    @Test
    void aStackStaysAStack() {
        double up = Math.sqrt(1 - 0.3 * 0.3);
        EditorState fallen = Falling.onFloor(EditorState.of(Scene.EMPTY.plus(ball(0.5, 0.3, 5 + up, 0), ball(0.5, 0, 5, 0))), Set.of(ScenePath.body(0), ScenePath.body(1)));
        assertThat(place(fallen, 1).y()).isCloseTo(0.5, within(NEAR));
        assertThat(place(fallen, 0).y()).isCloseTo(0.5 + up, within(NEAR));
    }

    /** No more is asked than a hand waits for; the boxes of what is left count. */
    @Test
    void manyFallAtOnce() {
        List<SceneObject> balls = IntStream.range(0, 900).mapToObj(i -> ball(0.5, i % 30 * 0.9, 5 + Math.floorDiv(i, 30) % 3 * 0.2, Math.floorDiv(i, 30) * 0.9)).toList();
        EditorState state = EditorState.of(Scene.EMPTY.withObjects(balls).plus(SceneObject.of(new Plane())));
        EditorState fallen = Falling.onFloor(state, IntStream.range(0, 900).filter(i -> i % 2 == 0).mapToObj(ScenePath::body).collect(Collectors.toSet()));
        assertThat(place(fallen, 0).y()).isBetween(0.5, 5.0);
        assertThat(place(fallen, 1)).as("is not moved").isEqualTo(place(state, 1));
    }
}
