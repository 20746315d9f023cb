package cz.paprsek.fx.model.edit;

import static cz.paprsek.scene.ScenePath.body;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.model.TestScenes;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

class MovesTest {
    private final Scene kitchen = TestScenes.kitchen();

    @Test
    void everythingMovesTogetherAndEachOnlyOnce() {
        Scene after = Moves.translated(kitchen, List.of(body(0), body(1), body(1, 0), ScenePath.light(0), ScenePath.camera()), new Vec3(1, 2, 3));
        assertThat(after.objects().get(0).placement().position()).isEqualTo(new Vec3(1, 2, 3));
        assertThat(after.objects().get(1).placement().position()).isEqualTo(new Vec3(4, 2, 3));
        assertThat(body(1, 0).in(after).placement()).isEqualTo(Placement.NONE);
        assertThat(LightMoves.place(after.lights().get(0))).isEqualTo(new Vec3(5, 8, 8));
        assertThat(after.camera().position()).isEqualTo(kitchen.camera().position().plus(new Vec3(1, 2, 3)));
    }

    @Test
    void cameraKeepsItsTarget() {
        Scene scene = kitchen.withCamera(Camera.lookingAt(new Vec3(0, 0, 5), Vec3.ZERO));
        assertThat(Moves.translated(scene, Set.of(ScenePath.camera()), Vec3.X).camera().aim()).isEqualTo(new Camera.Target(Vec3.ZERO));
    }

    @Test
    void operandMovesAlongTheWorldsAxes() {
        Vec3 before = body(1, 1, 0).toWorld(kitchen).point(Vec3.ZERO);
        Scene after = Moves.translated(kitchen, Set.of(body(1, 1, 0)), new Vec3(1, 2, 3));
        Vec3 moved = body(1, 1, 0).toWorld(after).point(Vec3.ZERO).minus(before);
        assertThat(moved.minus(new Vec3(1, 2, 3)).length()).isCloseTo(0, within(1e-12));
    }

    @Test
    void turningIsAboutThePivot() {
        Scene after = Moves.rotated(kitchen, Set.of(body(3), ScenePath.light(0)), new Vec3(0, 0, 0), new Vec3(0, 0, 90));
        assertThat(after.objects().get(3).placement().position()).isEqualTo(new Vec3(-2, 0, 0));
        assertThat(after.objects().get(3).placement().rotation()).isEqualTo(new Vec3(0, 0, 90));
        assertThat(LightMoves.place(after.lights().get(0))).isEqualTo(new Vec3(-6, 4, 5));
    }

    @Test
    void turningBackAndForthLeavesTheScaleExactly() {
        Scene scene = Scene.EMPTY.plus(SceneObject.of(new Sphere(1)).scaled(0.1, 0.2, 0.3).rotated(10, 20, 30).at(1, 2, 3));
        Scene after = Moves.rotated(scene, Set.of(body(0)), Vec3.ZERO, new Vec3(0, 37, 0));
        assertThat(after.objects().get(0).placement().scale()).isEqualTo(new Vec3(0.1, 0.2, 0.3));
        Affine expected = Affine.rotation(new Vec3(0, 37, 0)).after(scene.objects().get(0).placement().toParent());
        assertThat(body(0).toWorld(after).point(Vec3.ONE).minus(expected.point(Vec3.ONE)).length()).isCloseTo(0, within(1e-12));
    }

    @Test
    void stretchingFollowsTheWorldsAxes() {
        Scene scene = Scene.EMPTY.plus(SceneObject.of(new Block(Vec3.ZERO, Vec3.ONE)).rotated(0, 0, 90).at(2, 0, 0));
        Scene after = Moves.scaled(scene, Set.of(body(0)), Vec3.ZERO, new Vec3(3, 1, 1));
        // A quarter turn about z lays the block's own y along the world's x.
        assertThat(after.objects().get(0).placement().scale()).isEqualTo(new Vec3(1, 3, 1));
        assertThat(after.objects().get(0).placement().position()).isEqualTo(new Vec3(6, 0, 0));
    }

    @Test
    void whatStandsAskewGrowsEvenly() {
        Scene scene = Scene.EMPTY.plus(SceneObject.of(new Block(Vec3.ZERO, Vec3.ONE)).rotated(0, 0, 30));
        Scene after = Moves.scaled(scene, Set.of(body(0)), Vec3.ZERO, new Vec3(3, 1, 1));
        assertThat(after.objects().get(0).placement().scale()).isEqualTo(new Vec3(3, 3, 3));
    }

    @Test
    void placementIsFoundFromItsMap() {
        Random random = new Random(7);
        for (int i = 0; i < 1000; i++) {
            Placement placement = new Placement(
                    new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()),
                    new Vec3(random.nextInt(8) * 45 - 180, random.nextInt(5) * 45 - 90, random.nextInt(8) * 45 - 180),
                    new Vec3(1 + random.nextDouble(), 1 + random.nextDouble(), (1 + random.nextDouble()) * (random.nextBoolean() ? 1 : -1)));
            Affine map = placement.toParent();
            Affine found = Placements.of(map).orElseThrow().toParent();
            for (Vec3 p : List.of(Vec3.ZERO, Vec3.X, Vec3.Y, Vec3.Z)) {
                assertThat(found.point(p).minus(map.point(p)).length()).as("%s", placement).isCloseTo(0, within(1e-11));
            }
        }
    }

    @Test
    void roundNumbersComeOutRound() {
        Placement placement = new Placement(new Vec3(0.1, -2, 30), new Vec3(10, 20, 30), new Vec3(1, 2, 0.5));
        assertThat(Placements.of(placement.toParent())).contains(placement);
    }
}
