package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.surface.Media;
import cz.paprsek.scene.Camera;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Numbers of a textbook.
 *
 * @source Buck, The Ray Whitted Challenge, 2019
 */
class TextbookTest {
    private static final double CLOSE = 1e-4;

    @ParameterizedTest
    @CsvSource({"0, 0, -5, 4, 6", "0, 0, 0, -1, 1", "0, 0, 5, -6, -4"})
    void aRayMeetsTheUnitSphereTwice(double x, double y, double z, double first, double second) {
        assertThat(crossings(new Sphere(1), new Vec3(x, y, z), Vec3.Z)).containsExactly(new double[] {first, second}, within(CLOSE));
    }

    @Test
    void aRayPassesTheUnitSphere() {
        assertThat(crossings(new Sphere(1), new Vec3(0, 2, -5), Vec3.Z)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "5, 0.5, 0, -1, 0, 0, 4, 6", "-5, 0.5, 0, 1, 0, 0, 4, 6", "0.5, 5, 0, 0, -1, 0, 4, 6", "0.5, -5, 0, 0, 1, 0, 4, 6",
        "0.5, 0, 5, 0, 0, -1, 4, 6", "0.5, 0, -5, 0, 0, 1, 4, 6", "0, 0.5, 0, 0, 0, 1, -1, 1"})
    void aRayMeetsTheCubeOnEachSide(double x, double y, double z, double dx, double dy, double dz, double first, double second) {
        Block cube = new Block(new Vec3(-1, -1, -1), Vec3.ONE);
        assertThat(crossings(cube, new Vec3(x, y, z), new Vec3(dx, dy, dz))).containsExactly(new double[] {first, second}, within(CLOSE));
    }

    @Test
    void mediaAreTheOnesEnteredLast() {
        // Through A (index 1.5), B (2) and C (2.5), entered in this order, left in the order B, C, A.
        Media media = new Media();
        double[][] pairs = new double[6][];
        pairs[0] = step(media, 0, 1.5);
        pairs[1] = step(media, 1, 2.0);
        pairs[2] = step(media, 2, 2.5);
        pairs[3] = step(media, 1, 0);
        pairs[4] = step(media, 2, 0);
        pairs[5] = step(media, 0, 0);
        assertThat(pairs).isDeepEqualTo(new double[][] {{1, 1.5}, {1.5, 2}, {2, 2.5}, {2.5, 2.5}, {2.5, 1.5}, {1.5, 1}});
    }

    private static double[] step(Media media, int object, double enteredIndex) {
        double before = media.refractiveIndex();
        if (enteredIndex > 0) {
            media.enter(object, enteredIndex);
        } else {
            media.leave(object);
        }
        return new double[] {before, media.refractiveIndex()};
    }

    @Test
    void theCameraLooksThroughTheMiddleAndTheCornerOfThePicture() {
        // There the field of view spans the longer side: 90° over 201 pixels are 2·atan(101/201) over 101.
        double fovy = 2 * Math.toDegrees(Math.atan(101.0 / 201));
        Eye eye = Eye.of(Camera.looking(Vec3.ZERO, new Vec3(0, 0, -1)).withFovy(fovy), 201, 101);
        Ray ray = new Ray(new Spans());
        eye.start(ray, 100.5, 50.5);
        assertThat(new double[] {ray.dx, ray.dy, ray.dz}).containsExactly(new double[] {0, 0, -1}, within(CLOSE));
        eye.start(ray, 0.5, 0.5);
        assertThat(new double[] {-ray.dx, ray.dy, ray.dz}).containsExactly(new double[] {0.66519, 0.33259, -0.66851}, within(CLOSE));
    }

    private static double[] crossings(Solid solid, Vec3 from, Vec3 direction) {
        Spans spans = new Spans();
        Ray ray = new Ray(spans);
        ray.start(from.x(), from.y(), from.z(), direction.x(), direction.y(), direction.z());
        // What lies before the ray may be left out.
        ray.min = Double.NEGATIVE_INFINITY;
        solid.place(Affine.IDENTITY, new Parts() {
            @Override
            public <P extends Part> P add(IntFunction<P> maker) {
                return maker.apply(0);
            }

            @Override
            public Parts within(MaterialSource material, Affine toWorld) {
                return this;
            }
        }).spans(ray, spans);
        double[] t = new double[spans.size()];
        for (int i = 0; i < t.length; i++) {
            t[i] = spans.t(i);
        }
        return t;
    }
}
