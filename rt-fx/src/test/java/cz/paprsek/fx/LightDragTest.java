package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.LightMoves;
import cz.paprsek.fx.model.edit.Visible;
import cz.paprsek.fx.view.projection.ProjectionPane;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import java.util.List;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.Test;

/** Lights and cameras, dragged in the projections. */
class LightDragTest extends InProjections {
    @Override
    Scene scene() {
        return ProjectionTest.SCENE;
    }

    @Test
    void lightsAndTheCameraAreDraggedToo() {
        ProjectionPane front = editor.projection("front");
        drag(front, new Vec3(-3, 5, 3), new Vec3(-2, 4, 3));
        assertThat(LightMoves.place(editor.model().scene().lights().get(0)).minus(new Vec3(-2, 4, 3)).length()).isCloseTo(0, within(3 / scale(front)));
        drag(front, new Vec3(-6, 3, 6), new Vec3(-5, 4, 6));
        assertThat(editor.model().scene().camera().position().minus(new Vec3(-5, 4, 6)).length()).isCloseTo(0, within(3 / scale(front)));
        assertThat(editor.model().scene().camera().aim()).isEqualTo(new Camera.Target(Vec3.ZERO));
    }

    private void lit(Light light) {
        editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.ADD), scene -> scene.withLights(List.of(light))));
        editor.gui.act(() -> editor.model().select(ScenePath.light(0)));
    }

    @Test
    void aSpotIsAimedByItsTargetAndMadeWiderByItsRim() {
        ProjectionPane front = editor.projection("front");
        lit(SpotLight.from(new Vec3(-3, 4, 0), new Vec3(-3, 2, 0)));
        drag(front, new Vec3(-3, 2, 0), new Vec3(-2, 1, 0));
        SpotLight aimed = (SpotLight) editor.model().scene().lights().get(0);
        assertThat(((Camera.Target) aimed.aim()).point().minus(new Vec3(-2, 1, 0)).length()).isCloseTo(0, within(3 / scale(front)));
        lit(SpotLight.from(new Vec3(-3, 4, 0), new Vec3(-3, 2, 0)));
        drag(front, new Vec3(-1, 2, 0), new Vec3(-2, 2, 0));
        SpotLight narrow = (SpotLight) editor.model().scene().lights().get(0);
        assertThat(narrow.outerAngle()).isCloseTo(26.5, within(1.5));
        assertThat(narrow.innerAngle()).isLessThan(narrow.outerAngle());
    }

    @Test
    void aLightWithASizeIsTurnedByItsNormalAndStretchedByHandles() {
        ProjectionPane front = editor.projection("front");
        lit(AreaLight.rectangle(new Vec3(-3, 3, 0), 1, 1).withRotation(new Vec3(90, 0, 0)));
        drag(front, new Vec3(-3, 2, 0), new Vec3(-2, 3, 0));
        assertThat(((AreaLight) editor.model().scene().lights().get(0)).direction().minus(Vec3.X).length()).isCloseTo(0, within(0.05));
        lit(SphereLight.of(new Vec3(-3, 3, 0), 0.5));
        double air = 7 / scale(front);
        drag(front, new Vec3(-2.5 + air, 3.5 + air, 0), new Vec3(-2 + air, 4 + air, 0));
        assertThat(((SphereLight) editor.model().scene().lights().get(0)).radius()).isCloseTo(0.75, within(3 / scale(front)));
    }

    @Test
    void aSunIsDraggedByWhereItsLightComesFrom() {
        ProjectionPane front = editor.projection("front");
        lit(SunLight.along(2, -3, 0));
        drag(front, new Vec3(-2, 3, 0), new Vec3(-1, 4, 0));
        assertThat(((SunLight) editor.model().scene().lights().get(0)).direction().minus(new Vec3(1, -4, 0)).length()).isCloseTo(0, within(3 / scale(front)));
    }

    @Test
    void cameraIsAimedByWhatItLooksAt() {
        ProjectionPane front = editor.projection("front");
        editor.gui.act(() -> editor.model().select(ScenePath.camera()));
        drag(front, Vec3.ZERO, new Vec3(2, 1, 0));
        Camera.Target target = (Camera.Target) editor.model().scene().camera().aim();
        assertThat(target.point().minus(new Vec3(2, 1, 0)).length()).isCloseTo(0, within(3 / scale(front)));
    }

    /** What is alone leaves the others dark in the camera's picture too, and the file as it is. */
    @Test
    void oneLightAloneAndAllAgainByTheSameKeys() {
        editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.ADD), scene -> scene.withLights(List.of(Light.at(-3, 5, 3), Light.at(3, 5, 3), SunLight.along(0, -1, 0)))));
        editor.gui.act(() -> {
            editor.model().select(ScenePath.light(1));
            editor.projection("front").requestFocus();
        });
        Scene before = editor.model().scene();
        editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.J);
        assertThat(editor.model().state().hidden()).containsExactlyInAnyOrder(ScenePath.light(0), ScenePath.light(2));
        assertThat(editor.model().scene()).isSameAs(before);
        assertThat(Visible.of(editor.model().state()).scene().lights()).containsExactly(before.lights().get(1));
        editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.J);
        assertThat(editor.model().state().hidden()).isEmpty();
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(editor.model().state().hidden()).hasSize(2);
    }
}
