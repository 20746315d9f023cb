package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.material.CustomPattern;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.integrate.Whitted;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Level;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Hits of a block that are lit together get what each gets by itself. */
class BlockLightingTest {
    private static final int SIDE = 8;
    private static final int WIDTH = 12 * SIDE;
    private static final int HEIGHT = 8 * SIDE;
    private static final List<Double> EXPONENTS = List.of(0.0, 1.0, 2.0, 3.0, 7.0, 49.5, 50.0, 128.0, 100_000.0);

    private static final Pattern CHECKER = new Pattern.Checker(1, Vec3.ZERO, Rgb.WHITE, Rgb.grey(80));

    static IntStream seeds() {
        return IntStream.range(0, 30);
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void theSameLightToTheLastBit(int seed) {
        Scene scene = scene(seed);
        assertThat(lit(scene)).isGreaterThan(100);
    }

    /** So near that the square of the distance is 0: the cosine to the mirrored ray is not a number. */
    @Test
    void alsoOfALightThatIsAsNearAsNumbersGo() {
        SceneObject plane = SceneObject.of(new Plane()).rotated(30, 2, 47).madeOf(Material.color(200, 100, 50).withHighlight(0.5, 20));
        assertThat(lit(Scenes.empty().plus(plane).plus(Light.at(-1e-170, 1e-170, 1e-170)).plus(Light.at(1, 6, 7)))).isGreaterThan(100);
    }

    /** What is black by a negative number stays so: −0. */
    @Test
    void alsoWhereNothingIsAddedToNothing() {
        CustomPattern dark = (x, y, z, hit) -> hit.color(-1, -0.0, 0);
        SceneObject ball = SceneObject.of(new Sphere(2)).madeOf(Material.color(200, 100, 50).withPattern(dark));
        assertThat(lit(Scenes.empty().plus(ball).plus(Light.at(9, 0, 0)).plus(Light.at(9, 1, 0)))).isGreaterThan(100);
    }

    /** Renders both ways, so that a pixel is in the middle; how many hits were lit with others. */
    private static int lit(Scene scene) {
        Whitted together = tracer(scene);
        Whitted alone = tracer(scene);
        Eye eye = Eye.of(scene.camera(), WIDTH + 1, HEIGHT + 1);
        together.begin(() -> false);
        alone.begin(() -> false);
        int lit = 0;
        for (int y = 0; y < HEIGHT; y += SIDE) {
            for (int x = 0; x < WIDTH; x += SIDE) {
                Level[] block = together.trace(eye, x, y, SIDE, SIDE);
                for (int i = 0; i < SIDE * SIDE; i++) {
                    Level one = alone.trace(eye, x + i % SIDE, y + i / SIDE, 1, 1)[0];
                    assertThat(bits(block[i])).as("pixel %d %d", x + i % SIDE, y + i / SIDE).isEqualTo(bits(one));
                    assertThat(one.isIlluminated).isFalse();
                    lit += block[i].isIlluminated ? 1 : 0;
                }
            }
        }
        assertThat(together.work()).isEqualTo(alone.work());
        return lit;
    }

    @Test
    void notWhereItDoesNotPayOrLightsAreOthers() {
        Scene two = scene(1).withLights(List.of(Light.at(1, 6, 2), Light.at(-1, 6, 2)));
        assertThat(areTogether(two)).isTrue();
        assertThat(areTogether(two.withLights(List.of(Light.at(1, 6, 2))))).isFalse();
        assertThat(areTogether(two.plus(SunLight.along(0, -1, 0)))).isFalse();
        assertThat(areTogether(two.plus(Light.at(1, 7, 2).withReferenceDistance(6)))).isFalse();
    }

    private static boolean areTogether(Scene scene) {
        return Stream.of(tracer(scene).trace(Eye.of(scene.camera(), WIDTH, HEIGHT), WIDTH / 2, HEIGHT - SIDE, SIDE, SIDE)).anyMatch(level -> level.isIlluminated);
    }

    private static Whitted tracer(Scene scene) {
        return new Whitted(RenderScene.of(scene).world(), 5, Sampling.grid(1));
    }

    private static List<Long> bits(Level level) {
        return Stream.of(level.red, level.green, level.blue).map(Double::doubleToRawLongBits).toList();
    }

    /** Bodies of which some gleam and some are bumpy, in two to five lights: also in the plane of the floor, beneath it, and among the bodies. */
    private static Scene scene(long seed) {
        Random random = new Random(seed);
        Scene bodies = Scenes.random(seed, 12);
        List<SceneObject> objects = bodies.objects().stream().map(object -> object.madeOf(finish(random))).toList();
        List<Light> lights = IntStream.range(0, 2 + random.nextInt(4)).<Light>mapToObj(i -> light(random)).toList();
        return bodies.withObjects(objects).withLights(lights);
    }

    private static Material finish(Random random) {
        Material gleaming = Material.color(200, 100 + random.nextInt(100), 50).withHighlight(random.nextInt(3) / 2.0, EXPONENTS.get(random.nextInt(EXPONENTS.size())))
                .withDiffusion(random.nextInt(3) / 2.0).withReflection(random.nextInt(2) / 4.0);
        return random.nextInt(4) > 0 ? gleaming : gleaming.withRelief(new Material.Bump(0.1, CHECKER)).withPattern(CHECKER);
    }

    private static Light light(Random random) {
        double y = random.nextInt(4) == 0 ? -4 : 14 * random.nextDouble() - 6;
        return Light.at(12 * random.nextDouble() - 6, y, 10 * random.nextDouble() - 8).withIntensity(random.nextDouble());
    }
}
