package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Sphere;
import java.util.List;
import org.junit.jupiter.api.Test;

class RenderSceneTest {
    private static final Scene SCENE = Scenes.random(3, 20).plus("glass", Material.color(255, 255, 255).withTransparency(0.9, 1.5))
            .plus(SceneObject.of(new Sphere(1)).at(0, 0, 20).madeOf("glass"));
    private static final RenderScene READY = RenderScene.of(SCENE);

    private static void assertSamePicture(Scene changed, boolean sharesBodies) {
        RenderScene again = READY.changedTo(changed, RenderMonitor.NONE);
        Image image = Renderer.render(again, RenderOptions.of(changed), RenderMonitor.NONE).image();
        assertThat(Scenes.difference(image, Renderer.render(changed), 0)).isZero();
        assertThat(again.world().bodies() == READY.world().bodies()).isEqualTo(sharesBodies);
    }

    @Test
    void aMovedCameraSharesTheBodies() {
        assertSamePicture(SCENE.withCamera(Camera.lookingAt(new Vec3(3, 4, 5), Vec3.ZERO)), true);
    }

    @Test
    void aCameraMovedIntoGlassSeesThroughIt() {
        assertSamePicture(SCENE.withCamera(Camera.lookingAt(new Vec3(0.3, 0.2, 20), Vec3.ZERO)), true);
    }

    @Test
    void lightsAndColoursOfTheAirShareTheBodies() {
        assertSamePicture(SCENE.withLights(List.of(Light.at(0, 9, 9))).withAmbient(Rgb.grey(90)).withBackground(Rgb.WHITE), true);
    }

    @Test
    void aChangedMaterialIsSeen() {
        assertSamePicture(SCENE.plus("glass", Material.color(200, 30, 30)).withCamera(Camera.lookingAt(new Vec3(0, 0, 25), Vec3.ZERO)), false);
    }

    @Test
    void aMovedObjectIsSeen() {
        assertSamePicture(SCENE.plus(SceneObject.of(new Sphere(2))), false);
    }
}
