package cz.paprsek.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class CameraViewTest {
    private static final Offset<Double> EXACTLY = Offset.offset(1e-9);
    private static final Camera CAMERA = Camera.lookingAt(new Vec3(3, 4, 5), new Vec3(0.5, 0, -1)).withFovy(50);

    @Test
    void aPointOnThePixelsRayIsSeenAtThePixel() {
        Scene scene = Scene.EMPTY.withCamera(CAMERA).withSettings(new RenderSettings(80, 50, 3, 1));
        TracedRay ray = RenderScene.of(scene).explain(17, 41).rays().get(0);
        Vec3 near = ray.origin().plus(ray.direction().times(0.5));
        Vec3 far = ray.origin().plus(ray.direction().times(40));
        Segment seen = new CameraView(CAMERA, 80, 50).line(near, far).get(0);
        assertThat(seen.x1()).isCloseTo(17.5, EXACTLY);
        assertThat(seen.y1()).isCloseTo(41.5, EXACTLY);
        assertThat(seen.x2()).isCloseTo(17.5, EXACTLY);
        assertThat(seen.y2()).isCloseTo(41.5, EXACTLY);
        assertThat(new CameraView(CAMERA, 160, 100).line(near, far).get(0).x1()).as("twice as large").isCloseTo(35, EXACTLY);
    }

    @Test
    void whatIsBehindTheEyeIsNotSeen() {
        Vec3 behind = CAMERA.position().minus(CAMERA.forward());
        Vec3 before = CAMERA.position().plus(CAMERA.forward().times(2)).plus(CAMERA.right());
        CameraView picture = new CameraView(CAMERA, 80, 50);
        assertThat(picture.line(behind, behind.minus(CAMERA.forward()))).isEmpty();
        Segment cut = picture.line(before, behind).get(0);
        assertThat(cut.x1()).isEqualTo(picture.line(before, before).get(0).x1());
        assertThat(cut.x2()).as("far to the right, where the line comes up to the eye").isGreaterThan(1000);
        assertThat(picture.line(behind, before).get(0).x1()).isCloseTo(cut.x2(), Offset.offset(1e-3));
    }

    @Test
    void aSegmentIsCutToARectangle() {
        assertThat(new Segment(-10, 5, 30, 5).within(20, 10)).contains(new Segment(0, 5, 20, 5));
        assertThat(new Segment(5, 2, 5, 3).within(20, 10)).contains(new Segment(5, 2, 5, 3));
        assertThat(new Segment(-10, 5, 30, 45).within(20, 10)).isEmpty();
        assertThat(new Segment(4, -3, 4, -1).within(20, 10)).isEmpty();
    }
}
