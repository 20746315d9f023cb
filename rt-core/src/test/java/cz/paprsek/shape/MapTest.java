package cz.paprsek.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** How a picture lies on each shape: u to the right, v up, as seen from outside. */
class MapTest {
    private static final int RAYS = 2_000;
    private static final double STEP = 1e-5;

    private static final List<Placement> PLACEMENTS = List.of(
            Placement.NONE,
            Placement.at(-2, 1, 3).withRotation(new Vec3(0, 90, 0)),
            Placement.at(0, 1, 0).withRotation(new Vec3(90, 0, 180)).withScale(new Vec3(2, 2, 2)),
            Placement.at(3, -2, 1).withRotation(new Vec3(20, 50, -70)),
            Placement.at(-1, 0.5, 2).withRotation(new Vec3(-30, 10, 45)).withScale(new Vec3(0.4, 1.7, 1.1)),
            Placement.at(0.2, 1, -3).withRotation(new Vec3(10, 0, 180)).withScale(new Vec3(-1.5, 1.5, 1.5)),
            Placement.at(1, 1, 1).withScale(new Vec3(1, -1, 1)));

    /** Each shape is met from the point o towards the direction d, and there are u, v and the tangent. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            ball, middle of the picture | sphere    | 0 0 5       | 0 0 -1  | 0.5    | 0.5   | 1 0 0
            ball, to the right          | sphere    | 5 0 0       | -1 0 0  | 0.75   | 0.5   | 0 0 -1
            ball, to the left           | sphere    | -5 0 0      | 1 0 0   | 0.25   | 0.5   | 0 0 1
            ball, just left of the seam | sphere    | 1e-9 0 -5   | 0 0 1   | 1      | 0.5   | -1 0 0
            ball, the other side of it  | sphere    | -1e-9 0 -5  | 0 0 1   | 0      | 0.5   | -1 0 0
            ball, at 45 degrees up      | sphere    | 0 5 5       | 0 -1 -1 | 0.5    | 0.75  | 1 0 0
            ball, north pole: any u     | sphere    | 0 5 0       | 0 -1 0  | NaN    | 1     | 1 0 0
            ball, south pole: any u     | sphere    | 0 -5 0      | 0 1 0   | NaN    | 0     | 1 0 0
            egg, north pole: any u      | ellipsoid | 0 5 0       | 0 -1 0  | NaN    | 1     | 1 0 0
            egg, to the right           | ellipsoid | 5 0 0       | -1 0 0  | 0.75   | 0.5   | 0 0 -1
            block, front                | block     | 0.5 0.25 5  | 0 0 -1  | 0.75   | 0.625 | 1 0 0
            block, back                 | block     | 0.5 0.25 -5 | 0 0 1   | 0.25   | 0.625 | -1 0 0
            block, right                | block     | 5 0.25 1    | -1 0 0  | 0.25   | 0.625 | 0 0 -1
            block, left                 | block     | -5 0.25 1   | 1 0 0   | 0.75   | 0.625 | 0 0 1
            block, top                  | block     | 0.5 5 1     | 0 -1 0  | 0.75   | 0.25  | 1 0 0
            block, bottom               | block     | 0.5 -5 1    | 0 1 0   | 0.75   | 0.75  | 1 0 0
            cylinder, side              | cylinder  | 0 0.5 5     | 0 0 -1  | 0.5    | 0.25  | 1 0 0
            cylinder, top               | cylinder  | 0.5 5 0.25  | 0 -1 0  | 0.75   | 0.375 | 1 0 0
            cylinder, bottom            | cylinder  | 0.5 -5 0.25 | 0 1 0   | 0.75   | 0.625 | 1 0 0
            cone, side                  | cone      | 0 1 5       | 0 0 -1  | 0.5    | 0.5   | 1 0 0
            cone, top, of radius ½      | cone      | 0.25 5 0    | 0 -1 0  | 0.75   | 0.5   | 1 0 0
            cone, bottom, of radius 1   | cone      | 0.25 -5 0   | 0 1 0   | 0.625  | 0.5   | 1 0 0
            ring, outside               | torus     | 0 0 5       | 0 0 -1  | 0.5    | 0.5   | 1 0 0
            ring, on top                | torus     | 1 5 0       | 0 -1 0  | 0.75   | 0.75  | 0 0 -1
            ring, below                 | torus     | 1 -5 0      | 0 1 0   | 0.75   | 0.25  | 0 0 -1
            ground                      | plane     | 3.25 5 -7.5 | 0 -1 0  | 3.25   | 7.5   | 1 0 0
            rectangle, from min to max  | rectangle | 0.2 0.3 5   | 0 0 -1  | 0.6    | 0.65  | 1 0 0
            rectangle, from behind      | rectangle | 0.2 0.3 -5  | 0 0 1   | 0.6    | 0.65  | 1 0 0
            disc, in the square around  | disc      | 0.5 0.25 5  | 0 0 -1  | 0.75   | 0.625 | 1 0 0
            """)
    void aPlaceInThePictureByAClosedForm(String name, String shape, String from, String along, double u, double v, String tangent) {
        Vec3 o = vec(from);
        Vec3 d = vec(along);
        for (Placement placement : PLACEMENTS) {
            Affine toWorld = placement.toParent();
            Placed placed = new Placed(example(shape), toWorld);
            Hit hit = placed.hit(toWorld.point(o), toWorld.direction(d).normalized());
            Vec3 expected = toWorld.direction(vec(tangent)).normalized();
            assertThat(hit.v).as("v of %s under %s", name, placement).isCloseTo(v, within(1e-8));
            if (!Double.isNaN(u)) {
                assertThat(hit.u).as("u of %s under %s", name, placement).isCloseTo(u, within(1e-8));
                assertThat(new Vec3(hit.tx, hit.ty, hit.tz).minus(expected).length()).as("tangent of %s under %s", name, placement).isCloseTo(0, within(1e-8));
            }
        }
    }

    private static Shape example(String word) {
        return switch (word) {
            case "sphere" -> new Sphere(1);
            case "ellipsoid" -> new Ellipsoid(new Vec3(0.5, 2, 0.75));
            case "block" -> new Block(new Vec3(-1, -1, 0), new Vec3(1, 1, 4.0 / 3));
            case "cylinder" -> new Cylinder(1, 2);
            case "cone" -> new Cone(1, 0.5, 2);
            case "torus" -> new Torus(1, 0.25);
            case "plane" -> new Plane();
            case "rectangle" -> new Rectangle(-1, -1, 1, 1);
            case "disc" -> new Disc(1);
            default -> throw new IllegalArgumentException(word);
        };
    }

    static Stream<Arguments> everyShapeOfAnySize() {
        return Examples.ALL.values().stream().flatMap(shape -> PLACEMENTS.stream().flatMap(placement -> Stream.of(1e-6, 1.0, 1e6).map(size -> Arguments.of(shape,
                placement.withPosition(placement.position().times(size)).withScale(placement.scale().times(size)), size))));
    }

    static Stream<Arguments> everyVariantToo() {
        return Stream.concat(everyShapeOfAnySize(), Examples.VARIANTS.stream().map(shape -> Arguments.of(shape, PLACEMENTS.get(PLACEMENTS.size() - 1), 1.0)));
    }

    /** The tangent leads along the surface, u grows and v does not; at right angles to it, towards N × T, v grows: nothing is seen mirrored. */
    @ParameterizedTest
    @MethodSource("everyVariantToo")
    void uGrowsAlongTheTangentAndVUpwardsFromIt(Shape shape, Placement placement, double size) {
        Affine toWorld = placement.toParent();
        boolean mirrored = placement.scale().x() * placement.scale().y() * placement.scale().z() < 0;
        Placed placed = new Placed(shape, toWorld);
        Random random = new Random(5);
        int compared = 0;
        for (int i = 0; i < RAYS; i++) {
            Vec3 from = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5).normalized().times(8);
            Vec3 to = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5).times(2);
            Vec3 o = toWorld.point(from);
            Ray ray = placed.ray(o, toWorld.point(to).minus(o).normalized());
            if (ray.part < 0) {
                continue;
            }
            Hit hit = placed.described(ray);
            Vec3 p = new Vec3(hit.px, hit.py, hit.pz);
            Vec3 n = new Vec3(hit.nx, hit.ny, hit.nz);
            Vec3 t = new Vec3(hit.tx, hit.ty, hit.tz);
            assertThat(new Vec3(hit.sx, hit.sy, hit.sz)).as("light is reckoned with the surface's own normal").isEqualTo(n);
            assertThat(t.length()).isCloseTo(1, within(1e-12));
            assertThat(t.dot(n)).as("along the surface").isCloseTo(0, within(1e-9));
            double step = STEP * size;
            if (shape instanceof Csg || nearAxis(toWorld.inverse().point(p))) {
                continue;
            }
            Hit right = placed.near(p, t.times(step), n, 0.01 * size, ray);
            Hit up = placed.near(p, n.cross(t).times(step), n, 0.01 * size, ray);
            if (right != null && up != null) {
                compared++;
                double du = wrapped(right.u - hit.u);
                assertThat(du).as("u to the right").isBetween(1e-7, 1e-2);
                assertThat(Math.abs(wrapped(right.v - hit.v))).as("v to the right, where u grew by %s", du).isLessThan(1e-3 * du + 1e-10);
                assertThat(wrapped(up.v - hit.v) * (mirrored ? -1 : 1) * (ray.face < 0 ? -1 : 1)).as("v upwards").isBetween(1e-7, 1e-2);
            }
        }
        assertThat(compared).isGreaterThan(shape instanceof Csg ? -1 : RAYS / 20);
    }

    /** From a place to one a little aside, u jumps at the back of round shapes only, and v only where a ring is nearest to its axis. */
    @ParameterizedTest
    @MethodSource("everyShapeOfAnySize")
    void uAndVJumpOnlyAtTheSeams(Shape shape, Placement placement, double size) {
        Affine toWorld = placement.toParent();
        Affine toLocal = toWorld.inverse();
        Placed placed = new Placed(shape, toWorld);
        Random random = new Random(8);
        int jumps = 0;
        for (int i = 0; i < RAYS && !(shape instanceof Csg || shape instanceof Extrude || shape instanceof Lathe || shape instanceof Text || shape instanceof Isosurface); i++) {
            Vec3 o = toWorld.point(new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, -random.nextDouble()).normalized().times(8));
            Ray ray = placed.ray(o, toWorld.point(new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5)).minus(o).normalized());
            if (ray.part < 0) {
                continue;
            }
            Hit hit = placed.described(ray);
            Vec3 p = new Vec3(hit.px, hit.py, hit.pz);
            Vec3 local = toLocal.point(p);
            Vec3 n = new Vec3(hit.nx, hit.ny, hit.nz);
            Vec3 t = new Vec3(hit.tx, hit.ty, hit.tz);
            for (Vec3 way : nearAxis(local) ? List.<Vec3>of() : List.of(t, t.negated(), n.cross(t), t.cross(n))) {
                Hit aside = placed.near(p, way.times(0.02 * size), n, 0.03 * size, ray);
                if (aside != null && Math.abs(aside.u - hit.u) > 0.5) {
                    jumps++;
                    assertThat(isRound(shape) && local.z() < 0 && Math.abs(local.x()) < 0.06).as("u jumps at %s", local).isTrue();
                }
                if (aside != null && Math.abs(aside.v - hit.v) > 0.5) {
                    assertThat(shape instanceof Torus && Math.hypot(local.x(), local.z()) < 1 && Math.abs(local.y()) < 0.06).as("v jumps at %s", local).isTrue();
                }
            }
        }
        assertThat(jumps > 0).as("the seam was met").isEqualTo(isRound(shape));
    }

    private static boolean isRound(Shape shape) {
        return shape instanceof Sphere || shape instanceof Mesh || shape instanceof Ellipsoid || shape instanceof Cylinder || shape instanceof Cone || shape instanceof Torus
                || shape instanceof Capsule || shape instanceof Prism || shape instanceof Superellipsoid;
    }

    /** There u and v may change as fast as they like. */
    private static boolean nearAxis(Vec3 local) {
        return Math.hypot(local.x(), local.z()) < 0.02;
    }

    /** Across the seam there is no step but that from 1 to 0. */
    private static double wrapped(double difference) {
        return difference - Math.rint(difference);
    }

    /** A face of an operation has the map of the shape that it is a face of, also where that was taken away. */
    @ParameterizedTest
    @MethodSource("everyShapeOfAnySize")
    void aFaceOfAnOperationIsMappedAsThatOfTheShape(Shape shape, Placement placement, double size) {
        if (!(shape instanceof Solid solid) || solid instanceof Csg) {
            return;
        }
        Affine toWorld = placement.toParent();
        Placed alone = new Placed(shape, toWorld);
        Placed far = new Placed(Csg.union(Operand.of(solid), Operand.of(new Sphere(0.01)).at(50, 0, 0)), toWorld);
        Placed hole = new Placed(Csg.difference(Operand.of(new Block(new Vec3(-90, -90, -90), new Vec3(90, 90, 90))), Operand.of(solid)), toWorld);
        Random random = new Random(6);
        int met = 0;
        for (int i = 0; i < 200; i++) {
            Vec3 o = toWorld.point(new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5).normalized().times(8));
            Vec3 d = toWorld.point(new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5)).minus(o).normalized();
            if (alone.ray(o, d).part >= 0) {
                met++;
                Hit bare = alone.hit(o, d);
                assertThat(map(far.hit(o, d))).isEqualTo(map(bare));
                if (hole.ray(o, d).part == 1) {
                    assertThat(map(hole.hit(o, d))).isEqualTo(map(bare));
                }
            }
        }
        assertThat(met).isGreaterThan(10);
    }

    private static List<Double> map(Hit hit) {
        return List.of(hit.u, hit.v, hit.tx, hit.ty, hit.tz);
    }

    private static Vec3 vec(String text) {
        double[] numbers = Stream.of(text.split(" ", -1)).mapToDouble(Double::parseDouble).toArray();
        return new Vec3(numbers[0], numbers[1], numbers[2]);
    }

    /** A shape in the world. */
    private static final class Placed {
        private final TestParts parts = new TestParts();
        private final Surface surface;

        Placed(Shape shape, Affine toWorld) {
            surface = shape.place(toWorld, parts);
        }

        Ray ray(Vec3 from, Vec3 d) {
            Ray ray = new Ray(new Spans());
            ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
            surface.nearest(ray);
            return ray;
        }

        Hit hit(Vec3 from, Vec3 d) {
            return described(ray(from, d));
        }

        Hit described(Ray ray) {
            Hit hit = parts.describe(ray);
            parts.all.get(ray.part).map(ray.face < 0 ? ~ray.face : ray.face, hit);
            return hit;
        }

        /** What is met where the surface was left by a small step, along the normal; null if that is another face. */
        @Nullable Hit near(Vec3 p, Vec3 step, Vec3 n, double back, Ray from) {
            Ray ray = ray(p.plus(step).plus(n.times(back)), n.negated());
            return ray.part == from.part && ray.face == from.face && Math.abs(ray.max - back) < 0.1 * back ? described(ray) : null;
        }
    }
}
