package cz.paprsek.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import java.util.List;
import java.util.Random;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class OutlineTest {
    private static final int STEPS = 64;

    static Stream<Shape> shapes() {
        return Stream.concat(Examples.ALL.values().stream(), Examples.VARIANTS.stream()).filter(shape -> !(shape instanceof Csg || shape instanceof Plane));
    }

    /** The box of a formula is drawn as well, and lies partly outside. */
    static Stream<Shape> drawnByTheirSurface() {
        return shapes().filter(shape -> !(shape instanceof Isosurface));
    }

    @ParameterizedTest
    @MethodSource("drawnByTheirSurface")
    void outlineLiesOnTheSurface(Shape shape) {
        Random random = new Random(5);
        for (int i = 0; i < 200; i++) {
            for (Vec3 p : points(shape, direction(random))) {
                assertThat(shape.bounds().grown(1e-9).contains(p)).isTrue();
                if (shape instanceof Solid solid) {
                    assertThat(Examples.inside(solid, p)).isCloseTo(0, within(1e-9));
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void outlineSeenAlongAnAxisIsAsLargeAsTheBox(Shape shape) {
        Bounds box = shape.bounds();
        for (Vec3 along : List.of(Vec3.X, Vec3.Y, Vec3.Z, new Vec3(0, -2, 0))) {
            List<Vec3> points = points(shape, along);
            if (along.x() == 0) {
                assertExtent(points, Vec3::x, box.minX(), box.maxX());
            }
            if (along.y() == 0) {
                assertExtent(points, Vec3::y, box.minY(), box.maxY());
            }
            if (along.z() == 0) {
                assertExtent(points, Vec3::z, box.minZ(), box.maxZ());
            }
        }
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void whateverIsHitIsSeenWithinTheOutline(Shape shape) {
        Random random = new Random(6);
        TestParts parts = new TestParts();
        Surface surface = shape.place(Affine.IDENTITY, parts);
        Ray ray = new Ray(new Spans());
        for (int i = 0; i < 100; i++) {
            Vec3 along = direction(random);
            Vec3 across = along.cross(direction(random)).normalized();
            List<Vec3> points = points(shape, along);
            double low = points.stream().mapToDouble(across::dot).min().orElseThrow();
            double high = points.stream().mapToDouble(across::dot).max().orElseThrow();
            // A polygon falls short of its circle by this share of the radius, which is below 2 for all examples.
            double slack = 2 * (1 - Math.cos(Math.PI / STEPS)) + 1e-9;
            for (int k = 0; k < 100; k++) {
                Vec3 origin = direction(random).times(2).minus(along.times(10));
                ray.start(origin.x(), origin.y(), origin.z(), along.x(), along.y(), along.z());
                surface.nearest(ray);
                if (ray.part >= 0) {
                    assertThat(across.dot(origin)).isBetween(low - slack, high + slack);
                }
            }
        }
    }

    private static List<Vec3> points(Shape shape, Vec3 along) {
        return shape.outline(along, STEPS).stream().flatMap(curve -> curve.points().stream()).toList();
    }

    private static void assertExtent(List<Vec3> points, ToDoubleFunction<Vec3> coordinate, double low, double high) {
        assertThat(points.stream().mapToDouble(coordinate).min().orElseThrow()).isCloseTo(low, within(1e-9));
        assertThat(points.stream().mapToDouble(coordinate).max().orElseThrow()).isCloseTo(high, within(1e-9));
    }

    private static Vec3 direction(Random random) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
    }
}
