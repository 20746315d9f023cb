package cz.paprsek.render.eye;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.tree.Bundle;
import cz.paprsek.tree.Bundles;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class EyeTest {
    private static final Offset<Double> EXACTLY = Offset.offset(1e-9);
    private static final Camera CAMERA = Camera.lookingAt(new Vec3(3, 4, 5), new Vec3(0.5, 0, -1)).withUp(new Vec3(0.2, 1, 0.1));
    private static final int WIDTH = 80;
    private static final int HEIGHT = 50;

    private final Random random = new Random(5);
    private final Ray ray = new Ray(new Spans());

    static Stream<Lens> lenses() {
        return Stream.of(Lens.Perspective.DEFAULT, new Lens.Perspective(70, 0.4, 3), new Lens.Orthographic(6), new Lens.Spherical(), Lens.Fisheye.DEFAULT,
                new Lens.Fisheye(360));
    }

    /** Rays and drawings use one formula, both ways. */
    @ParameterizedTest
    @MethodSource("lenses")
    void whatIsOnThePixelsRayIsDrawnAtThePixel(Lens lens) {
        Eye eye = Eye.of(CAMERA.withLens(lens), WIDTH, HEIGHT);
        double[] xy = new double[2];
        int seen = 0;
        for (int i = 0; i < 200; i++) {
            double x = WIDTH * random.nextDouble();
            double y = HEIGHT * random.nextDouble();
            if (eye.start(ray, x, y)) {
                assertThat(eye.project(at(0.1 + 20 * random.nextDouble()), xy)).isTrue();
                assertThat(xy[0]).isCloseTo(x, EXACTLY);
                assertThat(xy[1]).isCloseTo(y, EXACTLY);
                assertThat(ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz).isCloseTo(1, EXACTLY);
                seen++;
            }
        }
        assertThat(seen).isGreaterThan(80);
    }

    /** Bit by bit, whether the loop over many has become one of vectors or not. */
    @Test
    void directionsToldTogetherAreThoseOfEachRay() {
        Eye eye = Eye.of(CAMERA, WIDTH, HEIGHT);
        Views views = new Views();
        views.reserve(67);
        Ray together = new Ray(new Spans());
        for (int round = 0; round < 2000; round++) {
            for (int i = 0; i < 67; i++) {
                views.x[i] = WIDTH * random.nextDouble();
                views.y[i] = HEIGHT * random.nextDouble();
            }
            eye.look(views, 67);
            int i = round % 67;
            eye.start(together, views, i);
            assertThat(eye.start(ray, views.x[i], views.y[i])).isTrue();
            assertThat(new double[] {together.ox, together.oy, together.oz, together.dx, together.dy, together.dz})
                    .containsExactly(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz);
        }
        assertThat(lenses().filter(lens -> Eye.of(CAMERA.withLens(lens), WIDTH, HEIGHT).looksFromOnePlace())).containsExactly(Lens.Perspective.DEFAULT);
    }

    @Test
    void raysThroughTheMiddleGoAlongTheView() {
        lenses().forEach(lens -> {
            assertThat(Eye.of(CAMERA.withLens(lens), WIDTH, HEIGHT).start(ray, WIDTH / 2.0, HEIGHT / 2.0)).isTrue();
            assertClose(new Vec3(ray.dx, ray.dy, ray.dz), CAMERA.forward());
            assertClose(new Vec3(ray.ox, ray.oy, ray.oz), CAMERA.position());
        });
    }

    /** No ray of a block leaves its bundle: it would miss what the bundle does not meet. */
    @ParameterizedTest
    @MethodSource("lenses")
    void aBundleHoldsAllRaysOfItsBlock(Lens lens) {
        Eye eye = Eye.of(CAMERA.withLens(lens), WIDTH, HEIGHT);
        for (int i = 0; i < 300; i++) {
            int side = 1 + random.nextInt(8);
            int left = random.nextInt(WIDTH - side);
            int top = random.nextInt(HEIGHT - side);
            Bundle bundle = new Bundle();
            assertThat(eye.bundle(bundle, left, top, side, side)).isTrue();
            for (int k = 0; k < 20; k++) {
                if (eye.start(ray, left + side * random.nextDouble(), top + side * random.nextDouble(), random.nextDouble(), random.nextDouble())) {
                    double t = 0.01 + 30 * random.nextDouble();
                    Bounds there = Bounds.around(at(t), new Vec3(1e-9, 1e-9, 1e-9));
                    assertThat(Bundles.mayMeet(bundle, there)).isTrue();
                    assertThat(Bundles.enters(bundle, there)).isLessThanOrEqualTo(t);
                    assertThat(eye.origins().grown(1e-12).contains(at(0))).isTrue();
                }
            }
        }
    }

    @Test
    void allRaysThroughOnePointOfThePictureMeetInTheFocus() {
        Lens.Perspective lens = new Lens.Perspective(50, 0.3, 4);
        Eye sharp = Eye.of(CAMERA.withLens(lens.withAperture(0)), WIDTH, HEIGHT);
        Eye eye = Eye.of(CAMERA.withLens(lens), WIDTH, HEIGHT);
        for (int i = 0; i < 100; i++) {
            double x = WIDTH * random.nextDouble();
            double y = HEIGHT * random.nextDouble();
            sharp.start(ray, x, y);
            Vec3 focus = at(4 / new Vec3(ray.dx, ray.dy, ray.dz).dot(CAMERA.forward()));
            eye.start(ray, x, y, random.nextDouble(), random.nextDouble());
            Vec3 way = focus.minus(at(0));
            assertClose(at(way.length()), focus);
            Vec3 lensPoint = at(0).minus(CAMERA.position());
            assertThat(lensPoint.length()).isLessThanOrEqualTo(0.3 + 1e-12);
            assertThat(lensPoint.dot(CAMERA.forward())).isCloseTo(0, EXACTLY);
        }
    }

    /** The share of lens points within each quarter of the radius is that of the area. */
    @Test
    void theLensIsCoveredEvenly() {
        int[] rings = new int[4];
        double sumX = 0;
        int side = 200;
        for (int i = 0; i < side * side; i++) {
            double u = (i % side + 0.5) / side;
            int row = i / side;
            double v = (row + 0.5) / side;
            double r = Math.hypot(Disc.x(u, v), Disc.y(u, v));
            assertThat(r).isLessThan(1);
            rings[(int) (4 * r)]++;
            sumX += Disc.x(u, v);
        }
        for (int i = 0; i < 4; i++) {
            assertThat(rings[i] / (double) (side * side)).isCloseTo((2 * i + 1) / 16.0, Offset.offset(0.004));
        }
        assertThat(sumX).isCloseTo(0, Offset.offset(1e-6));
    }

    @Test
    void aFisheyeSeesNothingOutsideItsCircleAndAHalfCircleWithin() {
        Eye eye = Eye.of(CAMERA.withLens(Lens.Fisheye.DEFAULT), WIDTH, HEIGHT);
        assertThat(eye.start(ray, 1, 1)).isFalse();
        assertThat(ray.isBlind()).isTrue();
        assertThat(eye.start(ray, WIDTH / 2.0, 0)).isTrue();
        assertThat(ray.isBlind()).isFalse();
        assertClose(new Vec3(ray.dx, ray.dy, ray.dz), CAMERA.trueUp());
        assertThat(eye.start(ray, WIDTH / 2.0 + HEIGHT / 4.0, HEIGHT / 2.0)).isTrue();
        assertClose(new Vec3(ray.dx, ray.dy, ray.dz), CAMERA.forward().plus(CAMERA.right()).normalized());
    }

    @Test
    void aGlobeSeesAllAround() {
        Eye eye = Eye.of(CAMERA.withLens(new Lens.Spherical()), WIDTH, HEIGHT);
        eye.start(ray, 0.75 * WIDTH, HEIGHT / 2.0);
        assertClose(new Vec3(ray.dx, ray.dy, ray.dz), CAMERA.right());
        eye.start(ray, 0, HEIGHT / 2.0);
        assertClose(new Vec3(ray.dx, ray.dy, ray.dz), CAMERA.forward().negated());
        eye.start(ray, 3, HEIGHT);
        assertClose(new Vec3(ray.dx, ray.dy, ray.dz), CAMERA.trueUp().negated());
    }

    @Test
    void straightUpAndDownHaveAnUpOfTheirOwn() {
        Camera down = Camera.looking(new Vec3(0, 5, 0), new Vec3(0, -2, 0));
        assertClose(down.trueUp(), new Vec3(0, 0, -1));
        assertClose(down.right(), Vec3.X);
        Camera up = Camera.looking(Vec3.ZERO, new Vec3(0, 2, 0));
        assertClose(up.trueUp(), Vec3.Z);
        assertClose(up.right(), Vec3.X);
    }

    @Test
    void whatIsBehindIsNotDrawn() {
        double[] xy = new double[2];
        Vec3 behind = CAMERA.position().minus(CAMERA.forward().times(2)).plus(CAMERA.right());
        for (Lens lens : List.of(Lens.Perspective.DEFAULT, new Lens.Orthographic(6), Lens.Fisheye.DEFAULT)) {
            assertThat(Eye.of(CAMERA.withLens(lens), WIDTH, HEIGHT).project(behind, xy)).isFalse();
        }
        for (Lens lens : List.of(new Lens.Spherical(), new Lens.Fisheye(360))) {
            assertThat(Eye.of(CAMERA.withLens(lens), WIDTH, HEIGHT).project(behind, xy)).isTrue();
        }
    }

    /** All around the rim at once, that is; not in the middle, where what is before is. */
    @Test
    void whatIsStraightBehindAFisheyeIsNotDrawn() {
        double[] xy = new double[2];
        Camera camera = Camera.looking(Vec3.ZERO, new Vec3(0, 0, -1)).withLens(new Lens.Fisheye(360));
        Eye eye = Eye.of(camera, WIDTH, HEIGHT);
        assertThat(eye.project(new Vec3(0, 0, 3), xy)).isFalse();
        assertThat(eye.project(Vec3.ZERO, xy)).isFalse();
        assertThat(eye.project(new Vec3(0, 0, -3), xy)).isTrue();
        assertThat(xy).containsExactly(WIDTH / 2.0, HEIGHT / 2.0);
        ray.start(0, 0, 0, 0, 0, 1);
        double[] place = eye.tell(ray);
        assertThat(Math.hypot(place[0], place[1])).isCloseTo(1, EXACTLY);
        ray.start(0, 0, 0, 0, 0, -1);
        assertThat(eye.tell(ray)).containsExactly(0, 0);
    }

    private Vec3 at(double t) {
        return new Vec3(ray.ox + t * ray.dx, ray.oy + t * ray.dy, ray.oz + t * ray.dz);
    }

    private static void assertClose(Vec3 found, Vec3 expected) {
        assertThat(found.minus(expected).length()).as(found + " and " + expected).isLessThan(1e-9);
    }
}
