package cz.paprsek.fx.model.contact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.Adding;
import cz.paprsek.fx.model.edit.Examples;
import cz.paprsek.fx.model.edit.LightMoves;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderScene;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Into the room of Cornell: 5.528 wide, 5.488 high, 5.592 deep, open to the front. */
class DroppingTest {
    private static final Vec3 DOWN = new Vec3(0, -1, 0);

    private final EditorState room;

    DroppingTest() throws Exception {
        room = EditorState.of(SceneFiles.read(Path.of("..", "scenes", "cornell.xml")));
    }

    private Bounds dropped(Shape shape, Vec3 point, Vec3 side) {
        Scene after = Dropping.body(room, shape, "new", new Sight(point, 1), side).scene();
        return ScenePath.body(after.objects().size() - 1).placed(after).bounds();
    }

    private Light lamp(int kind, Vec3 point, Vec3 side) {
        Scene after = Dropping.light(room, Adding.LIGHTS.get(kind), "new", new Sight(point, 1), side).scene();
        return after.lights().get(after.lights().size() - 1);
    }

    @Test
    void everyKindTouchesTheWallAndStaysInTheRoom() {
        for (Shape kind : Examples.ofSize(1)) {
            if (kind.bounds().isFinite()) {
                assertThat(dropped(kind, new Vec3(2, 3, 5.592), new Vec3(0, 0, -1)).maxZ()).as("%s at the back", kind.kind()).isBetween(5.58, 5.592 + 1e-6);
                assertThat(dropped(kind, new Vec3(0, 3, 2), Vec3.X).minX()).as("%s at the right", kind.kind()).isBetween(-1e-6, 0.01);
                assertThat(dropped(kind, new Vec3(2, 5.488, 2), DOWN).maxY()).as("%s at the ceiling", kind.kind()).isBetween(5.48, 5.488 + 1e-6);
                assertThat(dropped(kind, new Vec3(5, 0, 1), Vec3.Y).minY()).as("%s on the floor", kind.kind()).isCloseTo(0, within(1e-5));
            }
        }
    }

    @Test
    void ballTouchesASlantedSide() {
        Vec3 side = new Vec3(0.8, 0, -0.6);
        Bounds ball = dropped(new Sphere(0.5), new Vec3(2, 3, 2), side);
        assertThat(ball.middle().minus(new Vec3(2.4, 3, 1.7)).length()).isCloseTo(0, within(1e-5));
    }

    @Test
    void lampsHangBelowTheCeilingAndShineDown() {
        Vec3 at = new Vec3(1, 5.488, 4);
        for (int kind = 0; kind < 4; kind++) {
            assertThat(LightMoves.place(lamp(kind, at, DOWN))).isEqualTo(new Vec3(1, 4.488, 4));
        }
        assertThat(((SpotLight) lamp(1, at, DOWN)).aim()).isEqualTo(new Camera.Target(new Vec3(1, 0, 4)));
        assertThat(((SphereLight) lamp(3, at, DOWN)).referenceDistance()).isCloseTo(4.49, within(0.006));
        AreaLight panel = (AreaLight) lamp(2, at, DOWN);
        assertThat(panel.referenceDistance()).isCloseTo(4.49, within(0.006));
        assertThat(panel).isEqualTo(panel.shiningAt(new Vec3(1, 0, 4)));
    }

    @Test
    void areaLightIsTurnedToTheWallThatItIsDroppedOn() {
        AreaLight panel = (AreaLight) lamp(2, new Vec3(0, 3, 2), Vec3.X);
        assertThat(panel.position()).isEqualTo(new Vec3(1, 3, 2));
        assertThat(panel.referenceDistance()).isEqualTo(1);
        assertThat(panel.rotation().minus(panel.shiningAt(new Vec3(0, 3, 2)).rotation()).length()).isZero();
        assertThat(((SphereLight) lamp(3, new Vec3(5, 0, 1), Vec3.Y)).referenceDistance()).isEqualTo(1);
    }

    @Test
    void fromAboveARoomHasNoRoofButATableHasATop() {
        assertThat(Dropping.top(room, 0.5, 4.5)).isCloseTo(0, within(1e-9));
        assertThat(Dropping.top(room, 1.855, 1.69)).isCloseTo(1.65, within(1e-9));
        assertThat(Dropping.top(room, 20, 20)).isZero();
        SceneObject table = SceneObject.of(new Block(new Vec3(1, 2, 1), new Vec3(3, 2.1, 3)));
        assertThat(Dropping.top(EditorState.of(room.scene().plus(table)), 1.5, 1.5)).isCloseTo(2.1, within(1e-9));
        assertThat(Dropping.top(EditorState.of(Scene.EMPTY.plus(table)), 1.5, 1.5)).isCloseTo(2.1, within(1e-9));
    }

    /** By the tallest and the widest kind. */
    @Test
    void whatStandsUnderSomethingIsNoLargerThanTheRoomThere() {
        for (Shape kind : Examples.ofSize(1)) {
            Bounds box = kind.bounds();
            assertThat(box.isFinite() ? box.maxY() - box.minY() : 1).as(kind.kind()).isLessThanOrEqualTo(1.2 + 1e-9);
            assertThat(box.isFinite() ? Math.max(box.maxX() - box.minX(), box.maxZ() - box.minZ()) : 1).as(kind.kind()).isLessThanOrEqualTo(1.5);
        }
        assertThat(size(room, 0.5, 0, 0.5, 20)).as("in a corner, 0.5 from the walls").isEqualTo(0.5);
        for (int i = 1; i < 6; i++) {
            Sight fit = Dropping.fitting(room, new Sight(new Vec3(i * 0.9, Dropping.top(room, i * 0.9, i * 0.8), i * 0.8), 2), Vec3.Y);
            for (Shape kind : Examples.ofSize(fit.size())) {
                Scene after = Dropping.body(room, kind, "new", fit, Vec3.Y).scene();
                Bounds box = ScenePath.body(after.objects().size() - 1).placed(after).bounds();
                assertThat(!box.isFinite() || (box.maxY() < 5.488 && box.minX() > 0 && box.minZ() > 0 && box.maxZ() < 5.592)).as("%s in %s at %s", kind.kind(), box, fit).isTrue();
            }
        }
        EditorState hall = EditorState.of(Scene.EMPTY.plus(SceneObject.of(new Block(new Vec3(-9, 0, -9), new Vec3(9, 3, 9)))));
        assertThat(size(hall, 0, 3, 0, 2)).as("on what is no roof").isEqualTo(2);
        EditorState table = EditorState.of(Scene.EMPTY.plus(SceneObject.of(new Block(new Vec3(1, 0.7, 1), new Vec3(3, 0.8, 3)))));
        assertThat(size(table, 2, 0, 2, 2)).as("under a table").isEqualTo(0.5);
        assertThat(size(table, 2, 0.8, 2, 2)).as("on it").isEqualTo(2);
        assertThat(size(table, 0.4, 0, 2, 2)).as("beside it").isEqualTo(0.5);
        assertThat(Dropping.fitting(table, new Sight(new Vec3(2, 0, 2), 2), Vec3.X).size()).as("at a wall").isEqualTo(2);
    }

    @Test
    void whatIsDroppedFromAboveIsAsLargeAsWhereTheCameraLooks() {
        Sight gaze = Sight.of(room);
        assertThat(gaze.moved(new Vec3(1.0301, 2, 3), true, 1)).isEqualTo(new Sight(new Vec3(1, 2, 3), gaze.size()));
        assertThat(gaze.moved(new Vec3(1.0301, 2, 3), true, 0.02)).as("zoomed far in").isEqualTo(new Sight(new Vec3(1.04, 2, 3), gaze.size()));
        assertThat(gaze.moved(new Vec3(1.0301, 2, 3), false, 1).point().x()).isCloseTo(1.03, within(1e-3));
        assertThat(new Sight(Vec3.ZERO, 5).smaller().smaller().smaller().smaller().size()).isEqualTo(0.2);
    }

    private static double size(EditorState state, double x, double y, double z, double wished) {
        return Dropping.fitting(state, new Sight(new Vec3(x, y, z), wished), Vec3.Y).size();
    }

    @Test
    void thePictureTellsWhichSideIsSeen() {
        RenderScene seen = RenderScene.of(room.scene());
        int side = room.scene().settings().width();
        assertThat(new PicturePoint(seen, room.scene().settings(), side / 2.0, side * 0.97).side().minus(Vec3.Y).length()).isCloseTo(0, within(1e-9));
        assertThat(new PicturePoint(seen, room.scene().settings(), side / 2.0, side * 0.03).side().minus(DOWN).length()).isCloseTo(0, within(1e-9));
        assertThat(new PicturePoint(seen, room.scene().settings(), side / 2.0, side * 0.25).side().minus(new Vec3(0, 0, -1)).length()).isCloseTo(0, within(1e-9));
    }

    @Test
    void withoutTheGridAPointIsWhereTheHandIs() {
        Vec3 point = new Vec3(1.2345, 2.7182, 5.592);
        assertThat(Sight.chosen(point, Vec3.Z, 5.5, false).point().minus(point).length()).isLessThan(1e-3);
        assertThat(Sight.chosen(point, Vec3.Z, 5.5, true).point()).isEqualTo(new Vec3(1.25, 2.75, 5.592));
    }
}
