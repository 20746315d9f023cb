package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.util.function.DoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What moves while the shutter is open, against shares of time that can be worked out by hand. */
class ShutterTest {
    private static final Material GLOW = Material.color(0, 0, 0).withEmission(Rgb.WHITE, 1);
    /** Four units high, seen from the front: one unit a pixel. */
    private static final Scene BARE = Scene.EMPTY.withSettings(new RenderSettings(8, 4, 1, 16)).withCamera(Camera.looking(new Vec3(0, 0, 5), new Vec3(0, 0, -1)).withLens(new Lens.Orthographic(4)));

    private static RenderSettings settings(Integrator integrator) {
        return integrator == Integrator.PATH ? BARE.settings().withIntegrator(Integrator.PATH).withSamples(1024) : BARE.settings().withSamples(16);
    }

    private static Image rendered(DoubleFunction<Scene> moving, RenderSettings settings, int threads) {
        RenderScene scene = RenderScene.of(moving.apply(0)).exposed(moving, RenderMonitor.NONE);
        return Renderer.render(scene, RenderOptions.of(settings).withThreads(threads), RenderMonitor.NONE).image();
    }

    @ParameterizedTest
    @EnumSource(Integrator.class)
    void aPixelHasTheShareOfTheTimeThatADiscCoversIt(Integrator integrator) {
        // A disc of radius 2 moves 4 units to the right: pixel i, whose middle is c, is covered while |c − (4t − 2)| < √(4 − y²).
        DoubleFunction<Scene> moving = t -> BARE.plus(SceneObject.of(new Disc(2)).at(4 * t - 2, 0, 0).madeOf(GLOW));
        Image image = rendered(moving, settings(integrator), 2);
        for (int row = 0; row < 4; row++) {
            for (int column = 0; column < 8; column++) {
                double share = 0;
                int n = 64;
                for (int i = 0; i < n * n; i++) {
                    double x = column - 4 + (i % n + 0.5) / n;
                    int line = i / n;
                    double half = Math.sqrt(4 - Math.pow(2 - row - (line + 0.5) / n, 2));
                    share += Math.max(0, Math.min(1, (x + half + 2) / 4) - Math.max(0, (x - half + 2) / 4)) / (n * n);
                }
                assertThat(image.red(column, row)).as(column + ", " + row).isEqualTo((float) share, within(0.04f));
            }
        }
    }

    @Test
    void aPanOfTheCameraIsThatOfAllThereIsTheOtherWay() {
        Scene wall = BARE.plus(SceneObject.of(new Rectangle(-1, -9, 1, 9)).madeOf(GLOW));
        Image image = rendered(t -> wall.withCamera(wall.camera().withPosition(new Vec3(2 * t, 0, 5))), settings(Integrator.WHITTED), 2);
        for (int column = 0; column < 8; column++) {
            // The wall, two wide, is at −2t: a trapezium between −3 and 1.
            double share = 0;
            for (int i = 0; i < 1000; i++) {
                double x = column - 4 + (i + 0.5) / 1000;
                share += Math.max(0, Math.min(1, (1 - x) / 2) - Math.max(0, (-1 - x) / 2)) / 1000;
            }
            assertThat(image.red(column, 2)).as("column %s", column).isEqualTo((float) share, within(0.04f));
        }
    }

    @Test
    void whatStandsStillIsAsItIsWithoutAShutter() {
        Scene still = BARE.plus(SceneObject.of(new Sphere(1.5)).madeOf(GLOW));
        assertThat(rendered(t -> still, settings(Integrator.WHITTED), 1).toArgb()).isEqualTo(Renderer.render(RenderScene.of(still), RenderOptions.of(settings(Integrator.WHITTED)), RenderMonitor.NONE).image().toArgb());
    }

    @Test
    void everyThreadCountGivesTheSameBytes() {
        DoubleFunction<Scene> moving = t -> BARE.plus(SceneObject.of(new Sphere(1.5)).at(t, 0, 0).madeOf(GLOW));
        RenderSettings judged = BARE.settings().withSize(70, 40).withSamples(2, 4);
        assertThat(rendered(moving, judged, 1).toArgb()).isEqualTo(rendered(moving, judged, 3).toArgb());
    }

    @Test
    void theTreeIsBuiltOnceForAllInstants() {
        Scene many = BARE;
        for (int i = 0; i < 100; i++) {
            many = many.plus(SceneObject.of(new Sphere(0.1)).at(i, i, -i));
        }
        Scene all = many;
        RenderScene base = RenderScene.of(all);
        RenderScene flight = base.exposed(t -> all.withCamera(all.camera().withPosition(new Vec3(t, 0, 5))), RenderMonitor.NONE);
        assertThat(flight.instants()).hasSize(RenderScene.INSTANTS).allMatch(world -> world.bodies() == base.world().bodies());
        RenderScene next = flight.changedTo(all.withCamera(all.camera().withPosition(new Vec3(7, 0, 5))), RenderMonitor.NONE);
        assertThat(next.world().bodies()).isSameAs(base.world().bodies());
        assertThat(next.instants()).isEmpty();
    }

    @Test
    void picturesOfAnythingButLightAreRefused() {
        RenderScene scene = RenderScene.of(BARE).exposed(t -> BARE, RenderMonitor.NONE);
        assertThatIllegalArgumentException().isThrownBy(() -> Renderer.render(scene, RenderOptions.of(BARE).withMode(RenderMode.DEPTH), RenderMonitor.NONE)).withMessageStartingWith("while the shutter is open");
    }
}
