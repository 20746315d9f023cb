package cz.paprsek.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Solids that become others where one of their measures comes to its end, and areas and volumes in closed form. */
class LimitsTest {
    private static final String CIRCLE = "M0.5 0A0.5 0.5 0 0 1 -0.5 0A0.5 0.5 0 0 1 0.5 0Z";
    private static final Vec3 ONE = new Vec3(1, 1, 1);

    static Stream<Arguments> pairs() {
        return Stream.of(
                Arguments.of(new Capsule(0.8, 0), new Sphere(0.8), 1e-12),
                Arguments.of(new Block(ONE.negated(), ONE, 1), new Sphere(1), 1e-12),
                Arguments.of(new Block(ONE.negated(), new Vec3(1, 2, 1.5), 1e-14), new Block(ONE.negated(), new Vec3(1, 2, 1.5)), 1e-12),
                Arguments.of(new Superellipsoid(new Vec3(1, 0.5, 0.7), 1, 1), new Ellipsoid(new Vec3(1, 0.5, 0.7)), 1e-12),
                Arguments.of(new Superellipsoid(ONE, 1e-13, 1e-13), new Block(ONE.negated(), ONE), 1e-11),
                Arguments.of(new Superellipsoid(ONE, 2, 2), new Csg(Csg.Operation.UNION, List.of(
                        Operand.of(new Cone(1, 0, 1, 4)), Operand.of(new Cone(1, 0, 1, 4)).rotated(180, 0, 0))), 1e-12),
                Arguments.of(new Torus(1e-13, 1), new Sphere(1), 1e-12),
                Arguments.of(new Extrude(CIRCLE, "", 1.2, 0, 1), lying(new Cylinder(0.5, 1.2)), 1e-12),
                Arguments.of(new Extrude(CIRCLE, "", 1.2, 0, 0.4), lying(new Cone(0.5, 0.2, 1.2)), 1e-12),
                Arguments.of(new Extrude(CIRCLE, "", 1.2, 0, 0), lying(new Cone(0.5, 0, 1.2)), 1e-12),
                Arguments.of(new Extrude(CIRCLE, "", 1.2, 77, 1), lying(new Cylinder(0.5, 1.2)), 1e-11),
                Arguments.of(new Extrude("", "0.5 0.5 -0.5 0.5 -0.5 -0.5 0.5 -0.5", 1, 0, 1), new Block(new Vec3(-0.5, -0.5, 0), new Vec3(0.5, 0.5, 1)), 1e-12),
                Arguments.of(new Extrude("M-1-1H1V1H-1ZM.3.4H.5V.8H.3Z", "", 1, 0, 1), Csg.difference(new Block(new Vec3(-1, -1, 0), new Vec3(1, 1, 1)),
                        new Block(new Vec3(0.3, 0.4, -1), new Vec3(0.5, 0.8, 2))), 1e-12),
                Arguments.of(new Lathe("", "0 0 0.7 0 0.7 1.2 0 1.2", 360), new Cylinder(0.7, 1.2), 1e-12),
                Arguments.of(new Lathe("", "0 0 0.7 0 0.2 1.2 0 1.2", 360), new Cone(0.7, 0.2, 1.2), 1e-12),
                Arguments.of(new Lathe("M0-1A1 1 0 0 1 0 1Z", "", 360), new Sphere(1), 1e-3),
                Arguments.of(new Lathe("M1.2 0A.4 .4 0 0 1 .4 0A.4 .4 0 0 1 1.2 0", "", 360), new Torus(0.8, 0.4), 1e-3),
                Arguments.of(new Lathe("", "0 0 0.7 0 0.7 1.2 0 1.2", 180), Csg.difference(new Cylinder(0.7, 1.2),
                        new Block(new Vec3(-1, -1, 0), new Vec3(1, 2, 1))), 1e-12),
                Arguments.of(new Isosurface("x^2 + y^2 + z^2 - 1", new Vec3(-1.1, -1.1, -1.1), new Vec3(1.1, 1.1, 1.1)), new Sphere(1), 1e-12),
                Arguments.of(new Isosurface("(hypot(x, z) - 0.8)^2 + y^2 - 0.16", new Vec3(-1.3, -0.5, -1.3), new Vec3(1.3, 0.5, 1.3)), new Torus(0.8, 0.4), 1e-12),
                Arguments.of(new Isosurface("max(abs(x), abs(y), abs(z)) - 0.7", ONE.negated(), ONE), new Block(new Vec3(-0.7, -0.7, -0.7), new Vec3(0.7, 0.7, 0.7)), 1e-12),
                Arguments.of(new Cone(0.7, 0.7, 1.2, 6), new Prism(6, 0.7, 1.2), 0),
                Arguments.of(new Prism(4, Math.sqrt(2), 1), turnedBlock(), 1e-12));
    }

    private static Solid lying(Solid round) {
        return new Csg(Csg.Operation.UNION, List.of(Operand.of(round).rotated(90, 0, 0)));
    }

    private static Solid turnedBlock() {
        return new Csg(Csg.Operation.UNION, List.of(Operand.of(new Block(new Vec3(-1, 0, -1), new Vec3(1, 1, 1))).rotated(0, 45, 0)));
    }

    /** Along rays that start in the same places; those that only touch either may miss the other. */
    @ParameterizedTest
    @MethodSource("pairs")
    void atTheEndOfAMeasureOneSolidIsAnother(Solid limit, Solid plain, double tolerance) {
        Volume one = limit.place(Affine.IDENTITY, new TestParts());
        Volume other = plain.place(Affine.IDENTITY, new TestParts());
        Random random = new Random(3);
        int met = 0;
        for (int i = 0; i < 10_000; i++) {
            Vec3 from = direction(random).times(4);
            Vec3 d = direction(random).times(random.nextDouble()).minus(from).normalized();
            Spans a = spans(one, from, d);
            Spans b = spans(other, from, d);
            if (a.size() != b.size()) {
                assertThat(a.size() + b.size()).isEqualTo(2);
                Spans only = a.size() > 0 ? a : b;
                assertThat(only.t(1) - only.t(0)).as("a chord that one of them misses").isLessThan(limit instanceof Extrude e && e.twist() != 0 ? 0.15 : 1e-6);
                continue;
            }
            met += a.size() / 2;
            for (int k = 0; k < a.size(); k++) {
                // Near the rim a ray's way to the surface is longer than the distance between the two.
                assertThat(Math.abs(a.t(k) - b.t(k))).isLessThanOrEqualTo(tolerance / Math.max(1e-4, a.t(1) - a.t(0)));
            }
        }
        assertThat(met).isGreaterThan(3000);
    }

    /** Next to no height: met where its rim goes around, and nowhere else, pointed or not, also upside down. */
    @ParameterizedTest
    @CsvSource({"1, 0, 1e-3", "1, 0, 1e-7", "1, 0.5, 1e-8", "0, 1, 1e-9", "0.3, 1, 1e-12", "1, 0, 1e-12"})
    void aConeOfNoHeightIsADisc(double radius, double topRadius, double height) {
        Volume cone = new Cone(radius, topRadius, height).place(Affine.IDENTITY, new TestParts());
        Random random = new Random(4);
        int met = 0;
        for (int i = 0; i < 10_000; i++) {
            Vec3 from = direction(random).times(4);
            Vec3 to = new Vec3(3 * random.nextDouble() - 1.5, 0, 3 * random.nextDouble() - 1.5);
            Vec3 d = to.minus(from).normalized();
            Spans spans = spans(cone, from, d);
            // So far aside a line gets between the caps, and a rounded one more.
            double aside = 2 * height / Math.abs(d.y()) + 4e-15 / height;
            if (Math.abs(to.length() - 1) > aside) {
                assertThat(spans.size()).isEqualTo(to.length() < 1 ? 2 : 0);
                met += spans.size() / 2;
            }
        }
        assertThat(met).isGreaterThan(3000);
    }

    /** Chords of a fine grid of rays, added up: the volume; those that meet it, counted: the silhouette. */
    @ParameterizedTest
    @CsvSource({
            "1, 1, 3.141592653589793, 4.1887902047863905",
            "2, 2, 2, 1.3333333333333333",
            // Γ(1 + 1/p)²/Γ(1 + 2/p)·4 with p = 4, and a barrel of that section: ∫ area·(1 − y²) dy.
            "0.5, 1, 3.708149354602744, 4.944199139470325"})
    void silhouettesAndVolumesOfSuperellipsoidsAreThoseOfTheFormula(double east, double north, double area, double volume) {
        Volume solid = new Superellipsoid(ONE, east, north).place(Affine.IDENTITY, new TestParts());
        int steps = 400;
        double cell = 2.0 / steps * 2.0 / steps;
        double covered = 0;
        double filled = 0;
        for (int i = 0; i < steps; i++) {
            for (int k = 0; k < steps; k++) {
                Spans spans = spans(solid, new Vec3((2 * i + 1.0) / steps - 1, 5, (2 * k + 1.0) / steps - 1), new Vec3(0, -1, 0));
                covered += spans.size() > 0 ? cell : 0;
                filled += spans.size() > 0 ? (spans.t(1) - spans.t(0)) * cell : 0;
            }
        }
        assertThat(covered).isCloseTo(area, within(0.01));
        assertThat(filled).isCloseTo(volume, within(0.003));
    }

    @Test
    void theSilhouetteOfACapsuleIsAStadium() {
        Volume capsule = new Capsule(0.5, 1).place(Affine.IDENTITY, new TestParts());
        for (int i = -70; i <= 170; i++) {
            double y = i / 100.0;
            double beyond = y - Math.max(0, Math.min(1, y));
            Spans spans = spans(capsule, new Vec3(4, y, 0), new Vec3(-1, 0, 0));
            double half = Math.sqrt(Math.max(0, 0.25 - beyond * beyond));
            assertThat(spans.size() > 0 ? spans.t(1) - spans.t(0) : 0).as("where it only touches, the root of rounding").isCloseTo(2 * half, within(half > 0 ? 1e-12 : 1e-7));
        }
    }

    /** On the axis the ring that covers itself is dented, and whole: √(r² − R²) from the middle to either pole. */
    @Test
    void aRingThatCoversItselfIsDentedAndWhole() {
        Spans spans = spans(new Torus(0.6, 1).place(Affine.IDENTITY, new TestParts()), new Vec3(0, 5, 0), new Vec3(0, -1, 0));
        assertThat(spans.size()).isEqualTo(2);
        assertThat(spans.t(0)).isCloseTo(5 - 0.8, within(1e-12));
        assertThat(spans.t(1)).isCloseTo(5 + 0.8, within(1e-12));
    }

    /** Rays through the edges of a twisted star, a letter of curves and a vase: each leaves as often as it enters. */
    @Test
    void raysThatGrazeEdgesLeaveAsOftenAsTheyEnter() {
        List<Solid> solids = List.of(new Extrude("", "0 1 0.59 -0.81 -0.95 0.31 0.95 0.31 -0.59 -0.81", 1, 90, 0.5),
                new Extrude("M0-.7C1.5 0 .6 1 0 .4C-.6 1-1.5 0 0-.7ZM.2 0A.2 .2 0 1 0-.2 0A.2 .2 0 1 0 .2 0", "", 1, 0, 1.5),
                new Lathe("M0 0H.5C.5 .3 .1 .2 .1 .5Q.1 .8 .4 1.4H.37C.45 .8 .05 .9 0 .8Z", "", 360));
        Random random = new Random(9);
        for (Solid solid : solids) {
            Volume volume = solid.place(Affine.IDENTITY, new TestParts());
            List<Vec3> edges = solid.outline(new Vec3(1, 0.3, 0.5), 48).stream().flatMap(curve -> curve.points().stream()).toList();
            for (int i = 0; i < 3_000; i++) {
                Vec3 at = edges.get(random.nextInt(edges.size()));
                Vec3 from = direction(random).times(5);
                Spans spans = spans(volume, from, at.minus(from).normalized());
                assertThat(spans.size() % 2).isZero();
                for (int k = 1; k < spans.size(); k++) {
                    assertThat(spans.t(k)).isGreaterThanOrEqualTo(spans.t(k - 1));
                }
            }
        }
    }

    @Test
    void theEdgeOfARoundedBlockIsRound() {
        TestParts parts = new TestParts();
        Volume block = new Block(ONE.negated(), ONE, 0.25).place(Affine.IDENTITY, parts);
        Ray ray = new Ray(new Spans());
        Vec3 d = new Vec3(-1, -1, 0).normalized();
        ray.start(3, 3, 0, d.x(), d.y(), 0);
        block.nearest(ray);
        assertThat(ray.max).isCloseTo(2.25 * Math.sqrt(2) - 0.25, within(1e-14));
        Hit hit = parts.describe(ray);
        assertThat(new Vec3(hit.nx, hit.ny, hit.nz).plus(d).length()).isLessThan(1e-14);
    }

    private static Spans spans(Volume solid, Vec3 from, Vec3 d) {
        Spans spans = new Spans();
        Ray ray = new Ray(new Spans());
        ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
        solid.spans(ray, spans);
        return spans;
    }

    private static Vec3 direction(Random random) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
    }
}
