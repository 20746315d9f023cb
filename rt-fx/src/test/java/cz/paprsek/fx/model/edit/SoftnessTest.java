package cz.paprsek.fx.model.edit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.image.Image;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Plane;
import java.util.List;
import org.junit.jupiter.api.Test;

class SoftnessTest {
    private static final Scene FLOOR = Scene.EMPTY.withSettings(new RenderSettings(9, 9, 5, 1))
            .withCamera(Camera.lookingAt(new Vec3(0, 4, 6), Vec3.ZERO)).plus(SceneObject.of(new Plane())).plus(Light.at(2, 10, 3).named("key"));

    @Test
    void aPointBecomesABallOfAsMuchLightOnWhatIsLookedAt() {
        Scene soft = Softness.softened(EditorState.of(FLOOR), List.of());
        SphereLight ball = (SphereLight) soft.lights().get(0);
        assertThat(ball.name()).isEqualTo("key");
        assertThat(ball.visible()).as("nothing new is seen").isFalse();
        Image before = Renderer.render(FLOOR);
        Image after = Renderer.render(soft);
        assertThat(after.red(4, 4)).isCloseTo(before.red(4, 4), within(0.02f * before.red(4, 4)));
    }

    @Test
    void lightsWithASizeBecomeLarger() {
        Scene lights = FLOOR.withLights(List.of(SphereLight.of(Vec3.Y, 1), AreaLight.rectangle(Vec3.Y, 2, 1), SunLight.along(0, -1, 0), SpotLight.from(Vec3.Y, Vec3.ZERO)));
        Scene soft = Softness.softened(EditorState.of(lights), List.of());
        assertThat(((SphereLight) soft.lights().get(0)).radius()).isEqualTo(1.5);
        assertThat(((AreaLight) soft.lights().get(1)).form()).isEqualTo(new AreaLight.Size(3, 1.5));
        assertThat(((SunLight) soft.lights().get(2)).angle()).isEqualTo(2);
        assertThat(soft.lights().get(3)).isEqualTo(lights.lights().get(3));
    }

    @Test
    void onlyTheChosenLightsChangeAndNoneIsSaid() {
        Scene two = FLOOR.plus(Light.at(0, 5, 0)).plus(SpotLight.from(Vec3.Y, Vec3.ZERO));
        Scene soft = Softness.softened(EditorState.of(two), List.of(ScenePath.light(1)));
        assertThat(soft.lights().get(0)).isEqualTo(two.lights().get(0));
        assertThat(soft.lights().get(1)).isInstanceOf(SphereLight.class);
        assertThatThrownBy(() -> Softness.softened(EditorState.of(two), List.of(ScenePath.light(2)))).hasMessageContaining("softer");
    }
}
