package cz.paprsek.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Csg.Operation;
import cz.paprsek.shape.mesh.Meshes;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class CsgTest {
    private static final Block UNIT = new Block(Vec3.ZERO, Vec3.ONE);

    @ParameterizedTest
    @CsvSource({
        "UNION, true, true, true", "UNION, true, false, true", "UNION, false, true, true", "UNION, false, false, false",
        "DIFFERENCE, true, true, false", "DIFFERENCE, true, false, true", "DIFFERENCE, false, true, false", "DIFFERENCE, false, false, false",
        "INTERSECTION, true, true, true", "INTERSECTION, true, false, false", "INTERSECTION, false, true, false",
        "INTERSECTION, false, false, false"})
    void insideFollowsTheTruthTable(Operation operation, boolean left, boolean right, boolean result) {
        assertThat(operation.inside(left, right)).isEqualTo(result);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
    void randomTreesAgreeWithMembershipOfPoints(long seed) {
        Random random = new Random(seed);
        Solid solid = random(random, 4);
        Volume volume = solid.place(Affine.IDENTITY, new TestParts());
        Spans spans = new Spans();
        Bounds box = solid.bounds();
        for (int i = 0; i < 2000; i++) {
            Ray ray = ray(random);
            spans.release(0);
            volume.spans(ray, spans);
            for (int k = 0; k < 20; k++) {
                double t = random.nextDouble() * 12;
                double value = Examples.inside(solid, new Vec3(ray.ox + t * ray.dx, ray.oy + t * ray.dy, ray.oz + t * ray.dz));
                int before = 0;
                while (before < spans.size() && spans.t(before) <= t) {
                    before++;
                }
                if (Math.abs(value) > 1e-6) {
                    assertThat(before % 2 != 0).as("inside at t = %s", t).isEqualTo(value < 0);
                }
                if (value < -1e-6) {
                    assertThat(box.contains(new Vec3(ray.ox + t * ray.dx, ray.oy + t * ray.dy, ray.oz + t * ray.dz))).as("in the box").isTrue();
                }
            }
            double here = Examples.inside(solid, new Vec3(ray.ox, ray.oy, ray.oz));
            if (Math.abs(here) > 1e-6) {
                assertThat(volume.holdsOrigin(ray)).isEqualTo(here < 0);
            }
            volume.occludes(ray);
            volume.nearest(ray);
            assertThat(ray.spans.size()).as("scratch given back").isZero();
            assertThat(ray.met.size()).as("scratch given back").isZero();
        }
    }

    @Test
    void anOperationOnNothingIsRefused() {
        assertThatIllegalArgumentException().isThrownBy(() -> new Csg(Operation.UNION, List.of()));
    }

    @Test
    void anOperationIsCalledAsInFilesAndRefusesAMeshWithAHole() {
        assertThat(Stream.of(Csg.union(UNIT, UNIT), Csg.difference(UNIT, UNIT), Csg.intersection(UNIT, UNIT)).map(Csg::kind)).containsExactly("union", "difference", "intersection");
        Csg holed = Csg.intersection(UNIT, Mesh.of(Meshes.without(Meshes.cube(0.5), 3)));
        assertThatIllegalArgumentException().isThrownBy(() -> holed.place(Affine.IDENTITY, new TestParts()))
                .withMessage("the mesh made in code has no inside, so <intersection> cannot use it: 3 of its edges are open");
        assertThat(Csg.intersection(UNIT, Mesh.of(Meshes.cube(0.5))).place(Affine.IDENTITY, new TestParts()).contains(new Vec3(0.4, 0.4, 0.4))).isTrue();
    }

    @Test
    void whatHasMoreOperandsIsMoreWorkAndPlacingItCanBeStopped() {
        Parts parts = new TestParts();
        double one = UNIT.place(Affine.IDENTITY, parts).cost();
        double two = Csg.union(UNIT, UNIT).place(Affine.IDENTITY, parts).cost();
        double three = Csg.union(UNIT, UNIT, UNIT).place(Affine.IDENTITY, parts).cost();
        assertThat(two).isGreaterThan(2 * one);
        assertThat(three).isCloseTo(1.5 * two, within(1e-12));
        Parts stopped = new Parts() {
            @Override
            public <P extends Part> P add(IntFunction<P> maker) {
                return parts.add(maker);
            }

            @Override
            public Parts within(MaterialSource material, Affine toWorld) {
                return this;
            }

            @Override
            public boolean isCancelled() {
                return true;
            }
        };
        assertThatExceptionOfType(CancellationException.class).isThrownBy(() -> Csg.union(UNIT, UNIT).place(Affine.IDENTITY, stopped));
    }

    @Test
    void theBoxOfAnOperationIsNoLargerThanItMustBe() {
        Operand shifted = Operand.of(UNIT).at(0.25, 0, 0);
        assertThat(Csg.union(Operand.of(UNIT), shifted).bounds()).isEqualTo(new Bounds(0, 0, 0, 1.25, 1, 1));
        assertThat(Csg.intersection(Operand.of(UNIT), shifted).bounds()).isEqualTo(new Bounds(0.25, 0, 0, 1, 1, 1));
        assertThat(Csg.difference(Operand.of(UNIT), shifted).bounds()).isEqualTo(new Bounds(0, 0, 0, 1, 1, 1));
    }

    static Stream<Solid> nothings() {
        Operand shifted = Operand.of(UNIT).at(0.25, 0, 0);
        return Stream.of(
                Csg.difference(UNIT, UNIT),
                Csg.difference(new Sphere(1), new Sphere(1)),
                Csg.difference(Operand.of(new Torus(1, 0.3)).rotated(10, 20, 30), Operand.of(new Torus(1, 0.3)).rotated(10, 20, 30)),
                Csg.intersection(Operand.of(UNIT), Operand.of(UNIT).at(3, 0, 0)),
                Csg.intersection(Operand.of(UNIT), Operand.of(UNIT).at(1, 0, 0)),
                Csg.difference(Operand.of(Csg.intersection(Operand.of(UNIT), shifted)), Operand.of(UNIT)));
    }

    @ParameterizedTest
    @MethodSource("nothings")
    void aBodyWithoutItselfIsNothing(Solid nothing) {
        Volume volume = nothing.place(Affine.IDENTITY, new TestParts());
        Random random = new Random(3);
        for (int i = 0; i < 20_000; i++) {
            assertThat(volume.occludes(ray(random))).isFalse();
        }
    }

    @Test
    void aHoleFlushWithBothFacesIsOpen() {
        Csg plate = Csg.difference(Operand.of(UNIT), Operand.of(new Block(new Vec3(0.2, 0.2, 0), new Vec3(0.8, 0.8, 1))));
        Csg turned = Csg.union(Operand.of(plate).rotated(17, 29, 41));
        Affine map = Placement.NONE.withRotation(new Vec3(17, 29, 41)).toParent();
        for (Volume volume : new Volume[] {plate.place(Affine.IDENTITY, new TestParts()), turned.place(Affine.IDENTITY, new TestParts())}) {
            boolean isTurned = volume.bounds().minX() != 0;
            Random random = new Random(5);
            for (int i = 0; i < 20_000; i++) {
                Vec3 in = new Vec3(0.25 + 0.5 * random.nextDouble(), 0.25 + 0.5 * random.nextDouble(), -2);
                Vec3 out = new Vec3(in.x() + 0.01, in.y() - 0.01, 3);
                Vec3 from = isTurned ? map.point(in) : in;
                Vec3 d = (isTurned ? map.point(out) : out).minus(from).normalized();
                Ray ray = new Ray(new Spans());
                ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
                assertThat(volume.occludes(ray)).as("no skin over the hole").isFalse();
            }
        }
    }

    @Test
    void twoBlocksThatShareAFaceAreOneBody() {
        Volume both = Csg.union(Operand.of(UNIT), Operand.of(UNIT).at(1, 0, 0)).place(Affine.IDENTITY, new TestParts());
        Spans spans = new Spans();
        Random random = new Random(5);
        for (int i = 0; i < 20_000; i++) {
            Ray ray = ray(random);
            spans.release(0);
            both.spans(ray, spans);
            assertThat(spans.size()).as("no wall between them").isLessThanOrEqualTo(2);
        }
    }

    @Test
    void aDifferenceIsTheIntersectionWithTheComplement() {
        // The complement of the half-space y ≤ 0 is the half-space turned over.
        Volume cut = Csg.difference(new Sphere(1), new Plane()).place(Affine.IDENTITY, new TestParts());
        Volume common = Csg.intersection(Operand.of(new Sphere(1)), Operand.of(new Plane()).rotated(180, 0, 0))
                .place(Affine.IDENTITY, new TestParts());
        Random random = new Random(9);
        for (int i = 0; i < 20_000; i++) {
            Ray first = ray(random);
            Ray second = new Ray(new Spans());
            second.start(first.ox, first.oy, first.oz, first.dx, first.dy, first.dz);
            cut.nearest(first);
            common.nearest(second);
            assertThat(first.max).isEqualTo(second.max);
        }
    }

    /** Laws of sets, as pairs of bodies that must have the same boundaries. */
    static Stream<Arguments> laws() {
        Operand a = Operand.of(new Sphere(1)).at(0.2, 0, 0.1);
        Operand b = Operand.of(new Torus(0.9, 0.35)).rotated(30, 20, 0);
        Operand c = Operand.of(new Cone(0.8, 1.5)).at(0, -0.6, 0).rotated(0, 0, 40);
        return Stream.of(
                Arguments.of("A ∪ B = B ∪ A", Csg.union(a, b), Csg.union(b, a)),
                Arguments.of("A ∩ B = B ∩ A", Csg.intersection(a, b), Csg.intersection(b, a)),
                Arguments.of("(A ∪ B) ∪ C = A ∪ (B ∪ C)", Csg.union(op(Csg.union(a, b)), c), Csg.union(a, op(Csg.union(b, c)))),
                Arguments.of("A − B − C = A − (B ∪ C)", Csg.difference(a, b, c), Csg.difference(a, op(Csg.union(b, c)))),
                Arguments.of("A − B = A − (A ∩ B)", Csg.difference(a, b), Csg.difference(a, op(Csg.intersection(a, b)))),
                Arguments.of("A ∩ B = A − (A − B)", Csg.intersection(a, b), Csg.difference(a, op(Csg.difference(a, b)))),
                Arguments.of("(A − B) ∪ (A ∩ B) = A", Csg.union(op(Csg.difference(a, b)), op(Csg.intersection(a, b))), Csg.union(a)),
                Arguments.of("A ∩ (B ∪ C) = (A ∩ B) ∪ (A ∩ C)", Csg.intersection(a, op(Csg.union(b, c))),
                        Csg.union(op(Csg.intersection(a, b)), op(Csg.intersection(a, c)))));
    }

    private static Operand op(Solid solid) {
        return Operand.of(solid);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("laws")
    void setsObeyTheirLaws(String law, Solid left, Solid right) {
        Volume one = left.place(Affine.IDENTITY, new TestParts());
        Volume other = right.place(Affine.IDENTITY, new TestParts());
        Spans a = new Spans();
        Spans b = new Spans();
        Random random = new Random(13);
        int crossed = 0;
        for (int i = 0; i < 20_000; i++) {
            Ray ray = ray(random);
            a.release(0);
            b.release(0);
            one.spans(ray, a);
            other.spans(ray, b);
            double[] ahead = ahead(a);
            assertThat(ahead(b)).containsExactly(ahead, within(1e-8));
            crossed += ahead.length;
        }
        assertThat(crossed).isGreaterThan(5_000);
    }

    /** Boundaries before the eye; what lies behind it may be left out. */
    private static double[] ahead(Spans spans) {
        return IntStream.range(0, spans.size()).mapToDouble(spans::t).filter(t -> t > 0).toArray();
    }

    @Test
    void aThousandOperandsAndThreeHundredLevelsWork() {
        Operand[] many = new Operand[1000];
        for (int i = 0; i < many.length; i++) {
            many[i] = Operand.of(new Sphere(0.4)).at(i, 0, 0);
        }
        Ray ray = new Ray(new Spans());
        ray.start(-5, 0, 0, 1, 0, 0);
        Spans spans = new Spans();
        Csg.union(many).place(Affine.IDENTITY, new TestParts()).spans(ray, spans);
        assertThat(spans.size()).isEqualTo(2000);

        Solid deep = new Sphere(1);
        for (int i = 0; i < 300; i++) {
            deep = Csg.union(deep, new Sphere(1));
        }
        spans.release(0);
        deep.place(Affine.IDENTITY, new TestParts()).spans(ray, spans);
        assertThat(spans.size()).isEqualTo(2);
    }

    private static Ray ray(Random random) {
        Vec3 from = new Vec3(random.nextDouble() * 8 - 4, random.nextDouble() * 8 - 4, random.nextDouble() * 8 - 4);
        Vec3 to = new Vec3(random.nextDouble() * 2 - 1, random.nextDouble() * 2 - 1, random.nextDouble() * 2 - 1);
        Vec3 d = to.minus(from).normalized();
        Ray ray = new Ray(new Spans());
        ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
        return ray;
    }

    private static Solid random(Random random, int levels) {
        if (levels == 0 || random.nextInt(4) == 0) {
            return switch (random.nextInt(6)) {
                case 0 -> new Sphere(0.5 + random.nextDouble());
                case 1 -> new Block(new Vec3(-0.7, -0.7, -0.7), new Vec3(0.3 + random.nextDouble(), 0.8, 0.9));
                case 2 -> new Cylinder(0.3 + 0.5 * random.nextDouble(), 1.5);
                case 3 -> new Cone(0.9, 0.4 * random.nextDouble(), 1.5);
                case 4 -> new Torus(0.9, 0.3);
                default -> new Plane();
            };
        }
        Operand[] operands = new Operand[2 + random.nextInt(2)];
        for (int i = 0; i < operands.length; i++) {
            operands[i] = Operand.of(random(random, levels - 1))
                    .at(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5)
                    .rotated(random.nextInt(360), random.nextInt(360), random.nextInt(360))
                    .scaled(0.6 + random.nextDouble(), 0.6 + random.nextDouble(), 0.6 + random.nextDouble());
        }
        return switch (random.nextInt(3)) {
            case 0 -> Csg.union(operands);
            case 1 -> Csg.difference(operands);
            default -> Csg.intersection(operands);
        };
    }
}
