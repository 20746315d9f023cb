package cz.paprsek.shape.copied;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Isosurface;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Random;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is placed once for many places is met as if it were placed in each. */
class CopyTest {
    private static final int NEVER = Integer.MAX_VALUE;

    /** Nine bodies of several kinds, one taken out of another. */
    private static final Csg THING = new Csg(Csg.Operation.UNION, List.of(
            Operand.of(new Sphere(0.5)).named("ball"),
            Operand.of(new Block(new Vec3(-1, -0.25, -0.25), new Vec3(1, 0.25, 0.25))),
            Operand.of(new Sphere(1)).scaled(0.25, 1, 0.5),
            Operand.of(Csg.difference(Operand.of(new Block(new Vec3(-0.5, -0.5, -0.5), new Vec3(0.5, 0.5, 0.5))), Operand.of(new Cylinder(0.25, 2)).at(0, -1, 0))).at(0, 1.5, 0),
            Operand.of(new Torus(0.75, 0.125)).at(0, -1, 0),
            Operand.of(new Cone(0.5, 1)).rotated(0, 0, 90).at(1, 0, 0),
            Operand.of(new Sphere(0.25)).at(0, 0, 1),
            Operand.of(new Isosurface("x^2 + 2*y^2 + z^4 - 0.2", new Vec3(-0.5, -0.5, -0.7), new Vec3(0.5, 0.5, 0.7))).rotated(20, 30, 0).at(0, 0, -1)));

    private static Operand at(Solid solid, Random random) {
        double size = 0.5 + random.nextDouble();
        return Operand.of(solid).scaled(size, random.nextBoolean() ? size : 0.5 + random.nextDouble(), -size)
                .rotated(360 * random.nextDouble(), 360 * random.nextDouble(), 0).at(8 * random.nextDouble() - 4, 8 * random.nextDouble() - 4, 8 * random.nextDouble() - 4);
    }

    private static Original placed(Csg solid, int many) {
        return new Original(solid::place, new Originals(Repeated.in(List.of(solid), many), material -> true, () -> false));
    }

    @ParameterizedTest
    @EnumSource(Csg.Operation.class)
    void aCopyIsMetAsWhatIsWrittenOut(Csg.Operation operation) {
        Random random = new Random(7);
        List<Operand> operands = new ArrayList<>(List.of(Operand.of(new Sphere(4))));
        for (int i = 0; i < (operation == Csg.Operation.INTERSECTION ? 1 : 12); i++) {
            operands.add(at(THING, random));
        }
        Csg pair = new Csg(operation, operands);
        Csg all = Csg.union(Operand.of(pair), Operand.of(pair).at(9, 0, 0));
        Original copied = placed(all, 16);
        Original alone = placed(all, NEVER);
        assertThat(alone.hasCopies()).isFalse();
        assertThat(copied.hasCopies()).isTrue();
        assertThat(copied.count()).isEqualTo(alone.count());
        assertAlike(copied, alone, random, 300);
    }

    /** From the eye, then on from what is hit, inwards and outwards. */
    private static void assertAlike(Original copied, Original alone, Random random, int rays) {
        Ray one = new Ray(new Spans());
        Ray other = new Ray(new Spans());
        int hits = 0;
        for (int i = 0; i < rays; i++) {
            Vec3 from = vector(random).times(12).plus(new Vec3(4, 0, 0));
            Vec3 to = vector(random).times(4).plus(new Vec3(random.nextBoolean() ? 9 : 0, 0, 0)).minus(from).normalized();
            one.start(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
            other.start(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
            for (int depth = 0; depth < 4 && assertSameHit(copied, alone, one, other); depth++) {
                hits++;
                Vec3 on = vector(random).normalized();
                Hit hit = hit(alone, other);
                boolean inwards = on.x() * hit.nx + on.y() * hit.ny + on.z() * hit.nz < 0 != other.face < 0;
                Vec3 p = new Vec3(other.ox + other.max * other.dx, other.oy + other.max * other.dy, other.oz + other.max * other.dz);
                double size = other.max + Math.abs(p.x()) + Math.abs(p.y()) + Math.abs(p.z());
                one.start(p.x(), p.y(), p.z(), on.x(), on.y(), on.z(), size, 20, other.part, inwards);
                other.start(p.x(), p.y(), p.z(), on.x(), on.y(), on.z(), size, 20, other.part, inwards);
                assertThat(copied.whole().occludes(one)).isEqualTo(alone.whole().occludes(other));
            }
        }
        assertThat(hits).isGreaterThan(rays / 20);
    }

    private static boolean assertSameHit(Original copied, Original alone, Ray one, Ray other) {
        Spans crossed = new Spans();
        Spans crossedAlone = new Spans();
        copied.whole().crossings(one, crossed);
        alone.whole().crossings(other, crossedAlone);
        assertThat(crossed.size()).isEqualTo(crossedAlone.size());
        for (int i = 0; i < crossed.size(); i++) {
            assertThat(crossed.t(i)).isCloseTo(crossedAlone.t(i), within(1e-9));
            assertThat(crossed.part(i)).isEqualTo(crossedAlone.part(i));
            assertThat(crossed.face(i)).isEqualTo(crossedAlone.face(i));
        }
        copied.whole().nearest(one);
        alone.whole().nearest(other);
        assertThat(one.part).isEqualTo(other.part);
        if (one.part < 0) {
            return false;
        }
        assertThat(one.face).isEqualTo(other.face);
        assertThat(one.max).isCloseTo(other.max, within(1e-9));
        Hit a = hit(copied, one);
        Hit b = hit(alone, one);
        assertThat(Stream.of(a.nx, a.ny, a.nz, a.sx, a.sy, a.sz).toList()).zipSatisfy(Stream.of(b.nx, b.ny, b.nz, b.sx, b.sy, b.sz).toList(), (x, y) -> assertThat(x).isCloseTo(y, within(1e-9)));
        Part.map(copied, one, a);
        Part.map(alone, one, b);
        assertThat(Stream.of(a.u, a.v, a.tx, a.ty, a.tz).toList()).zipSatisfy(Stream.of(b.u, b.v, b.tx, b.ty, b.tz).toList(), (x, y) -> assertThat(x).isCloseTo(y, within(1e-6)));
        return true;
    }

    private static Hit hit(Original of, Ray ray) {
        Hit hit = new Hit();
        hit.px = ray.ox + ray.max * ray.dx;
        hit.py = ray.oy + ray.max * ray.dy;
        hit.pz = ray.oz + ray.max * ray.dz;
        of.part(ray.part >> Original.BITS, new CopiedPart()).describe(ray.face < 0 ? ~ray.face : ray.face, hit);
        return hit;
    }

    /** Calls by short names. */
    private static final class Part {
        static void map(Original of, Ray ray, Hit hit) {
            of.part(ray.part >> Original.BITS, new CopiedPart()).map(ray.face < 0 ? ~ray.face : ray.face, hit);
        }
    }

    private static Vec3 vector(Random random) {
        return new Vec3(2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1);
    }

    private static Csg row(Solid of, int count, double apart) {
        return new Csg(Csg.Operation.UNION, IntStream.range(0, count).mapToObj(i -> Operand.of(of).at(i * apart, 0, 0)).toList());
    }

    /** A hundred balls, ten of these, ten of those, and ten of those: each is kept once. */
    @Test
    void ofCopiesOfCopiesEachIsKeptOnce() {
        Csg balls = row(new Sphere(0.4), 100, 1);
        Csg all = row(row(row(balls, 10, 100), 10, 1000), 10, 10_000);
        Original once = placed(all, 500);
        assertThat(once.count()).isEqualTo(100_000);
        assertThat(once.kept()).as("one for each copy of all, and none for what lies within").isEqualTo(10);
        Original alone = placed(all, NEVER);
        assertThat(alone.kept()).isEqualTo(100_000);
        Ray ray = new Ray(new Spans());
        ray.start(98_765, 0, 5, 0, 0, -1);
        once.whole().nearest(ray);
        assertThat(ray.part >> Original.BITS).isEqualTo(98_765);
        assertThat(ray.max).isCloseTo(4.6, within(1e-12));
        assertThat(once.part(98_765, new CopiedPart())).isInstanceOf(CopiedPart.class);
    }

    /** Numbers that are exact: then the first of what lies in one place is met, be it in a copy or not. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void ofFacesInOnePlaceTheFirstIsMet(boolean copiesFirst) {
        Csg blocks = row(new Block(new Vec3(0, 0, 0), new Vec3(1, 1, 1)), 8, 1);
        Operand wall = Operand.of(new Block(new Vec3(-10, 0.5, -2), new Vec3(30, 0.75, 1)));
        List<Operand> two = List.of(Operand.of(blocks), Operand.of(blocks).at(8, 0, 0));
        Csg all = new Csg(Csg.Operation.UNION, copiesFirst ? Stream.concat(two.stream(), Stream.of(wall)).toList() : Stream.concat(Stream.of(wall), two.stream()).toList());
        Original copied = placed(all, 16);
        Original alone = placed(all, NEVER);
        Ray one = new Ray(new Spans());
        Ray other = new Ray(new Spans());
        for (double x = 0.25; x < 16; x += 0.5) {
            one.start(x, 0.625, 9, 0, 0, -1);
            other.start(x, 0.625, 9, 0, 0, -1);
            assertSameHit(copied, alone, one, other);
            assertThat(one.max).isEqualTo(8);
            assertThat(one.part >> Original.BITS).isEqualTo(copiesFirst ? (int) x : 0);
        }
    }

    @Test
    void whatStandsInFewPlacesIsPlacedInEach() {
        Csg ten = row(new Sphere(0.4), 10, 1);
        assertThat(Repeated.in(List.of(ten, ten, ten), 30).has(ten)).isTrue();
        assertThat(Repeated.in(List.of(ten, row(new Sphere(0.4), 10, 1), ten), 30).has(row(new Sphere(0.4), 10, 1))).as("equal ones").isTrue();
        assertThat(Repeated.in(List.of(ten, ten, ten), 31).has(ten)).isFalse();
        assertThat(Repeated.in(List.of(ten, ten, row(new Sphere(0.5), 10, 1)), 30).has(ten)).isFalse();
        Csg few = row(new Sphere(0.4), 3, 1);
        assertThat(Repeated.in(List.of(few, few, few), 3).has(few)).as("too small").isFalse();
        Csg pair = row(ten, 2, 20);
        Repeated nested = Repeated.in(List.of(pair, pair, pair), 30);
        assertThat(nested.has(pair)).isTrue();
        assertThat(nested.has(ten)).as("stands twice in what is placed once").isFalse();
        assertThat(Repeated.in(List.of(new Csg(Csg.Operation.UNION, List.of(Operand.of(ten).madeOf(Inherited.INHERITED).placed(Placement.at(0, 1, 0)))), ten, ten), 30).has(ten)).isTrue();
    }

    /** Else each would have to be compared with all others. */
    @Test
    void operationsThatDifferHaveHashesThatDo() {
        List<UnaryOperator<Operand>> ways = new ArrayList<>();
        for (int i = 0; i < 500; i++) {
            int k = i;
            int more = i / 256;
            ways.add(operand -> operand.madeOf(Material.color(k % 256, more, 7)));
            ways.add(operand -> operand.madeOf(new MaterialName("paint " + k)));
            ways.add(operand -> operand.at(k % 32, more, 1 + k));
        }
        ways.add(operand -> new Operand("", operand.solid(), operand.placement(), Placement.MIDDLE, true, Inherited.INHERITED));
        Alike alike = new Alike();
        for (UnaryOperator<Operand> way : ways) {
            assertThat(alike.of(Csg.union(way.apply(Operand.of(new Sphere(0.5))), Operand.of(new Sphere(1)))).size()).isEqualTo(2);
            assertThat(alike.of(Csg.union(way.apply(Operand.of(Csg.union(new Sphere(0.5), new Sphere(2)))), Operand.of(new Sphere(1)))).size()).isEqualTo(3);
        }
        assertThat(alike.hashes()).isGreaterThan(2 * ways.size() - 3);
    }

    @Test
    void aChangeThatMakesFewOfManyIsKnown() {
        Csg ten = row(new Sphere(0.4), 10, 1);
        Csg other = row(new Sphere(0.3), 10, 1);
        Repeated of = Repeated.in(List.of(ten, ten, ten, ten, other), 30);
        assertThat(of.changed(List.of(ten), List.of(), () -> List.of(ten, ten, ten, other))).isPresent();
        assertThat(of.changed(List.of(other), List.of(new Sphere(1)), () -> List.of(ten, ten, ten, ten, new Sphere(1)))).isPresent();
        assertThat(of.changed(List.of(ten, ten), List.of(), () -> List.of(ten, ten, other))).as("few are left").isEmpty();
        assertThat(of.changed(List.of(other), List.of(ten), () -> List.of(ten, ten, ten, ten, ten))).as("one more").isPresent();
        assertThat(of.changed(List.of(), List.of(other, other), () -> List.of(ten, ten, ten, ten, other, other, other))).as("now many").isEmpty();
        assertThat(Repeated.in(List.of(ten), 30).changed(List.of(), List.of(ten), () -> List.of(ten, ten))).isPresent();
        assertThat(Repeated.in(List.of(ten), 30).changed(List.of(), List.of(ten, ten), () -> List.of(ten, ten, ten))).isEmpty();
    }

    /** So a change costs what it is, not what the scene is. */
    @Test
    void whereNothingIsPlacedOnceASmallChangeIsToldWithoutLookingAtAll() {
        Csg ten = row(new Sphere(0.4), 10, 1);
        Supplier<Collection<? extends Shape>> never = () -> {
            throw new AssertionError("looks at all");
        };
        List<Csg> different = IntStream.range(0, 10).mapToObj(i -> row(new Sphere(0.1 + i), 10, 1)).toList();
        Repeated little = Repeated.in(List.of(ten, row(new Sphere(0.3), 3, 1), row(new Sphere(0.3), 3, 1), row(new Sphere(0.3), 3, 1)), 30);
        assertThat(little.changed(List.of(), List.of(row(new Sphere(0.2), 19, 1)), never)).as("29 primitives, small operations apart").isPresent();
        Repeated much = Repeated.in(different, 30);
        assertThat(much.has(different.get(0))).isFalse();
        assertThat(much.changed(List.of(different.get(1)), List.of(different.get(1)), never)).as("moved").isPresent();
        assertThat(much.changed(List.of(different.get(1)), List.of(row(new Sphere(7), 9, 1)), never)).as("less than the smallest").isPresent();
        assertThat(much.changed(List.of(), List.of(ten), () -> Stream.concat(different.stream(), Stream.of(ten)).toList())).as("looked at").isPresent();
        List<Csg> two = List.of(different.get(3), different.get(3));
        assertThat(much.changed(List.of(), two, () -> Stream.concat(different.stream(), two.stream()).toList())).isEmpty();
    }

    /** Eight balls doubled so often that their number would not go into an int or a long. */
    @ParameterizedTest
    @ValueSource(ints = {24, 28, 29, 60, 61})
    void tooManyPartsAreRefusedBeforeTheyAreWalked(int times) {
        Csg all = row(new Sphere(0.4), 8, 1);
        for (int i = 0; i < times; i++) {
            all = row(all, 2, 1 + i);
        }
        Csg nest = all;
        String expected = "the scene has more than 134216704 primitives in all places together";
        assertThatThrownBy(() -> Repeated.in(List.of(nest))).isInstanceOf(IllegalArgumentException.class).hasMessage(expected);
        Repeated small = Repeated.in(List.of(new Sphere(1)));
        assertThatThrownBy(() -> small.changed(List.of(), List.of(nest), () -> List.of(nest))).hasMessage(expected);
        assertThat(Original.sum(Original.MOST - 16, 16)).isEqualTo(Original.MOST);
        assertThatThrownBy(() -> Original.sum(Original.MOST - 15, 16)).hasMessage(expected);
        assertThatThrownBy(() -> Original.sum(Original.MOST, Integer.MAX_VALUE)).hasMessage(expected);
    }
}
