package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.integrate.Integrator;
import cz.paprsek.render.integrate.Whitted;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Level;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Sphere;
import cz.paprsek.standard.StandardScenes;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** How much work the standard scenes are, counted rather than timed: a tree of poorer quality shows here on every machine. */
class WorkTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 88;

    /** Visits were recorded when the tree was last improved: a better tree calls for new figures, a poorer one for a reason. Leaves met by all rays of a block at once are none. */
    static Stream<Arguments> work() {
        return Stream.of(
                Arguments.of("few", StandardScenes.few(), 10_717, 28_590, 36_428),
                Arguments.of("flake4", StandardScenes.flake(4), 7727, 41_067, 279_257),
                Arguments.of("cloud100k", StandardScenes.cloud(100_000), 0, 5514, 235_214),
                Arguments.of("csg1000", StandardScenes.carved(1000), 0, 12_188, 133_704),
                Arguments.of("csgn1000", StandardScenes.pierced(1000), 0, 11_763, 118_045),
                Arguments.of("chain100", StandardScenes.chain(100), 0, 441, 14_512));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("work")
    void raysAndVisitedNodesAreAsRecorded(String name, Scene scene, long reflected, long shadows, long visits) {
        Whitted tracer = new Whitted(RenderScene.of(scene).world(), 5, Sampling.grid(1));
        Eye eye = Eye.of(scene.camera(), WIDTH, HEIGHT);
        for (int y = 0; y < HEIGHT; y += 8) {
            for (int x = 0; x < WIDTH; x += 8) {
                tracer.trace(eye, x, y, 8, 8);
            }
        }
        String found = tracer.work().reflected() + ", " + tracer.work().shadows() + ", " + tracer.nodeVisits();
        assertThat(tracer.work().reflected()).as(found).isEqualTo(reflected);
        assertThat(tracer.work().shadows()).as(found).isEqualTo(shadows);
        assertThat(tracer.nodeVisits()).as(found).isCloseTo(visits, within(visits / 100));
    }

    /** A ball alone: of a mirror each ray that meets it is sent back, of glass it goes in and out again. */
    @ParameterizedTest
    @CsvSource({"1, 0", "0, 1"})
    void raysAreCountedByWhatTheyAre(double mirrored, double through) {
        Material material = Material.DEFAULT.withReflection(mirrored).withTransparency(through, 1.5);
        Scene scene = Scene.EMPTY.withCamera(Camera.looking(new Vec3(0, 0, 5), new Vec3(0, 0, -1))).plus(SceneObject.of(new Sphere(1)).madeOf(material));
        Whitted tracer = new Whitted(RenderScene.of(scene).world(), 5, Sampling.grid(1));
        Eye eye = Eye.of(scene.camera(), 32, 16);
        long met = 0;
        for (Level level : tracer.trace(eye, 0, 0, 32, 16)) {
            met += level.ray.part >= 0 ? 1 : 0;
        }
        assertThat(met).isPositive();
        Integrator.Work work = tracer.work();
        assertThat(work.primary()).isEqualTo(32 * 16);
        assertThat(work.reflected()).isEqualTo(mirrored > 0 ? met : 0);
        assertThat(work.refracted()).isEqualTo(through > 0 ? 2 * met : 0);
        assertThat(work.hits()).isEqualTo(through > 0 ? 2 * met : met);
        assertThat(work.shadows()).as("no light").isZero();
        assertThat(tracer.rays()).isEqualTo(work.primary() + work.reflected() + work.refracted());
    }
}
