package cz.paprsek.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.shape.placed.Volume;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What every shape must keep, tried with a hundred thousand random rays each. */
class ShapeContractTest {
    private static final int RAYS = 25_000;
    private static final List<Placement> PLACEMENTS = List.of(
            Placement.NONE,
            Placement.at(3, -2, 1).withRotation(new Vec3(20, 50, -70)),
            Placement.at(-1, 0.5, 2).withRotation(new Vec3(-30, 10, 45)).withScale(new Vec3(0.4, 1.7, 1.1)),
            Placement.at(0.2, 1, -3).withRotation(new Vec3(90, 0, 180)).withScale(new Vec3(-1.5, 0.8, 1.5)));

    /** An assertion that something is true, which for each of millions of rays takes longer than the ray itself. */
    private static void holds(String what, boolean isSo) {
        if (!isSo) {
            throw new AssertionError(what);
        }
    }

    @Test
    void everyPermittedShapeHasAnExample() {
        Stream<Class<?>> permitted = Stream.concat(Stream.of(Solid.class.getPermittedSubclasses()),
                Stream.of(Shape.class.getPermittedSubclasses()).filter(type -> type != Solid.class));
        assertThat(permitted.filter(Class::isRecord)).as("those that are not made in code").containsExactlyInAnyOrderElementsOf(Examples.ALL.keySet());
    }

    static Stream<Arguments> placedShapes() {
        return Stream.concat(Examples.ALL.values().stream(), Examples.VARIANTS.stream()).flatMap(shape -> PLACEMENTS.stream().map(placement -> Arguments.of(shape, placement)));
    }

    static Stream<Arguments> placedSolids() {
        return placedShapes().filter(arguments -> arguments.get()[0] instanceof Solid);
    }

    @ParameterizedTest
    @MethodSource("placedShapes")
    void hitsLieOnTheSurfaceWithinTheBoundsAndFaceOutwards(Shape shape, Placement placement) {
        Scene scene = new Scene(shape, placement);
        Bounds bounds = scene.surface.bounds().grown(1e-9);
        int hits = 0;
        for (int i = 0; i < RAYS; i++) {
            Ray ray = scene.randomRay();
            boolean occluded = scene.surface.occludes(ray);
            scene.surface.nearest(ray);
            holds("nearest agrees with occludes", ray.part >= 0 == occluded);
            if (ray.part < 0) {
                continue;
            }
            hits++;
            Hit hit = scene.parts.describe(ray);
            Vec3 p = new Vec3(hit.px, hit.py, hit.pz);
            Vec3 n = new Vec3(hit.nx, hit.ny, hit.nz);
            holds("a hit within the bounds", bounds.contains(p));
            holds("a normal of length 1", Math.abs(n.length() - 1) <= 1e-12);
            scene.checkNormal(p, n);
            scene.checkLeaving(ray, p, n);
        }
        assertThat(hits).isGreaterThan(RAYS / 20);
    }

    @ParameterizedTest
    @MethodSource("placedSolids")
    void boundariesArePairedSortedAndTheFirstIsTheNearest(Solid solid, Placement placement) {
        Scene scene = new Scene(solid, placement);
        Volume volume = (Volume) scene.surface;
        Spans spans = new Spans();
        for (int i = 0; i < RAYS; i++) {
            Ray ray = scene.randomRay();
            spans.release(0);
            volume.spans(ray, spans);
            holds("boundaries in pairs", spans.size() % 2 == 0);
            double first = Double.POSITIVE_INFINITY;
            for (int k = 0; k < spans.size(); k++) {
                holds("boundaries in order", k == 0 || spans.t(k) >= spans.t(k - 1));
                if (spans.t(k) > ray.min && first == Double.POSITIVE_INFINITY) {
                    first = spans.t(k);
                }
                double end = Math.min(k + 1 < spans.size() ? spans.t(k + 1) : spans.t(k) + 2, spans.t(k) + 2);
                if (spans.t(k) >= 0 && end - spans.t(k) > 1e-6) {
                    Vec3 middle = scene.local(ray, (spans.t(k) + end) / 2);
                    holds("inside after the first boundary, outside after the next, and so on", Examples.inside(solid, middle) < 0 == (k % 2 == 0));
                }
            }
            volume.nearest(ray);
            holds("the first boundary is the nearest", ray.max == first);
        }
    }

    /** Such a ray runs beside some faces without ever meeting them: the formulas have a case of its own for it. */
    @ParameterizedTest
    @MethodSource("placedSolids")
    void raysAlongTheShapesOwnAxesAgreeWithMembershipOfPoints(Solid solid, Placement placement) {
        Scene scene = new Scene(solid, placement);
        Volume volume = (Volume) scene.surface;
        Spans spans = new Spans();
        int within = 0;
        for (int i = 0; i < RAYS; i++) {
            Ray ray = scene.rayAlong(i % 3 == 0 ? Vec3.X : i % 3 == 1 ? Vec3.Y : Vec3.Z, i % 2 == 0);
            spans.release(0);
            volume.spans(ray, spans);
            double t = scene.between(0, 6);
            double value = Examples.inside(solid, scene.local(ray, t));
            if (Math.abs(value) > 1e-6) {
                int before = 0;
                while (before < spans.size() && spans.t(before) <= t) {
                    before++;
                }
                holds("inside by its boundaries as by its formula", (before % 2 != 0) == (value < 0));
                within += value < 0 ? 1 : 0;
            }
        }
        assertThat(within).isGreaterThan(RAYS / 50);
    }

    /** One of the quadratic's roots runs to infinity; the other is where two lines in the plane z = 0 cross, x = y − 1 being the left side. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-15, 1e-12, -1e-12, 1e-9, -1e-9, 1e-6, 1e-3})
    void aRayAlmostAlongTheSideOfAConeMeetsTheOtherSideExactly(double turn) {
        Surface cone = new Cone(1, 1).place(Affine.IDENTITY, new TestParts());
        Vec3 d = new Vec3(1, -1 + turn, 0).normalized();
        Ray ray = new Ray(new Spans());
        ray.start(-1.5, 1, 0, d.x(), d.y(), 0);
        cone.nearest(ray);
        assertThat(ray.max).isCloseTo(1.5 / (d.x() - d.y()), within(1e-15));
    }

    /** One placed shape and a source of rays that mostly hit it. */
    private static final class Scene {
        private final Random random = new Random(7);
        private final Spans spans = new Spans();
        private final Shape shape;
        private final Affine toWorld;
        private final Affine toLocal;
        private final Bounds target;
        final TestParts parts = new TestParts();
        final Surface surface;

        Scene(Shape shape, Placement placement) {
            this.shape = shape;
            toWorld = placement.toParent();
            toLocal = toWorld.inverse();
            surface = shape.place(toWorld, parts);
            target = surface.bounds().isFinite() ? surface.bounds() : Bounds.around(new Vec3(0, 0, 0), new Vec3(3, 3, 3));
        }

        Ray randomRay() {
            Vec3 to = target();
            Vec3 from = new Vec3(between(-6, 6), between(-6, 6), between(-6, 6));
            return ray(from, to.minus(from).normalized());
        }

        /** A ray along one of the shape's own axes, starting below or above a point in its bounds. */
        Ray rayAlong(Vec3 axis, boolean forward) {
            Vec3 d = toWorld.direction(forward ? axis : axis.negated()).normalized();
            return ray(target().minus(d.times(3)), d);
        }

        private Vec3 target() {
            return new Vec3(between(target.minX(), target.maxX()), between(target.minY(), target.maxY()), between(target.minZ(), target.maxZ()));
        }

        private Ray ray(Vec3 from, Vec3 d) {
            Ray ray = new Ray(spans);
            ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
            return ray;
        }

        double between(double low, double high) {
            return low + (high - low) * random.nextDouble();
        }

        Vec3 local(Ray ray, double t) {
            return toLocal.point(new Vec3(ray.ox + t * ray.dx, ray.oy + t * ray.dy, ray.oz + t * ray.dz));
        }

        void checkNormal(Vec3 p, Vec3 n) {
            double step = 1e-5;
            Vec3 out = toLocal.point(p.plus(n.times(step)));
            Vec3 in = toLocal.point(p.minus(n.times(step)));
            if (shape instanceof Solid solid) {
                // At an edge both sides may be outside, or inside; the value between them must still change in the right direction.
                holds("a normal faces outwards", Examples.inside(solid, out) > Examples.inside(solid, in));
                holds("a hit on the surface", Math.abs(Examples.inside(solid, toLocal.point(p))) < 1e-9);
            } else {
                holds("a hit on the surface", Math.abs(toLocal.point(p).z()) < 1e-9);
                holds("a normal faces outwards", out.z() > in.z());
            }
        }

        /** Whatever leaves a surface does not meet it where it starts: from there on it crosses what it would cross coming from farther away. */
        void checkLeaving(Ray arrived, Vec3 p, Vec3 n) {
            double cosine = arrived.dx * n.x() + arrived.dy * n.y() + arrived.dz * n.z();
            double size = arrived.max + Math.abs(p.x()) + Math.abs(p.y()) + Math.abs(p.z());
            boolean flipped = arrived.face < 0;
            Ray mirrored = new Ray(spans);
            mirrored.start(p.x(), p.y(), p.z(), arrived.dx - 2 * cosine * n.x(), arrived.dy - 2 * cosine * n.y(),
                    arrived.dz - 2 * cosine * n.z(), size, Double.POSITIVE_INFINITY, arrived.part, cosine > 0 != flipped);
            Ray onwards = new Ray(spans);
            onwards.start(p.x(), p.y(), p.z(), arrived.dx, arrived.dy, arrived.dz, size, Double.POSITIVE_INFINITY, arrived.part,
                    cosine > 0 == flipped);
            if (!(shape instanceof Solid)) {
                holds("a figure is not met where a ray leaves it", crossings(mirrored) + crossings(onwards) == 0);
            } else if (surface.bounds().isFinite()) {
                holds("comes from inside, and has to leave", crossings(mirrored) % 2 == 1 == cosine > 0);
                holds("goes in, and has to leave", crossings(onwards) % 2 == 1 == cosine < 0);
            }
        }

        private int crossings(Ray ray) {
            surface.crossings(ray, spans);
            int count = spans.size();
            spans.release(0);
            return count;
        }
    }
}
