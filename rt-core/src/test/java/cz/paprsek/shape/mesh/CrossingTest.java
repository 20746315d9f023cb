package cz.paprsek.shape.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import cz.paprsek.tree.Sieve;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Lines through meshes: through corners and sides, through what overlaps, and as the same bodies in closed form have them. */
class CrossingTest {
    /** -Dcrossing.lines=200000 for as many past triangles without area as were tried first. */
    private static final int LINES = Integer.getInteger("crossing.lines", 50_000);

    /** Corners at whole numbers, so that nothing is rounded: a lattice of 8 × 8 × 8 fields, its outer faces cut along alternating diagonals. */
    private static Triangles lattice() {
        Triangles.Builder out = Triangles.builder();
        for (int axis = 0; axis < 3; axis++) {
            for (int side = 0; side < 2; side++) {
                for (int i = 0; i < 8; i++) {
                    for (int j = 0; j < 8; j++) {
                        int[] v = new int[4];
                        for (int k = 0; k < 4; k++) {
                            double[] at = new double[3];
                            at[axis] = side == 0 ? -4 : 4;
                            at[(axis + 1) % 3] = i - 4 + (k == 1 || k == 2 ? 1 : 0);
                            at[(axis + 2) % 3] = j - 4 + (k >= 2 ? 1 : 0);
                            v[k] = out.vertex(at[0], at[1], at[2]);
                        }
                        int turn = (i + j) % 2;
                        triangle(out, side, v[turn], v[turn + 1], v[(turn + 2) % 4]);
                        triangle(out, side, v[turn], v[(turn + 2) % 4], v[(turn + 3) % 4]);
                    }
                }
            }
        }
        return out.build();
    }

    private static void triangle(Triangles.Builder out, int side, int a, int b, int c) {
        out.triangle(a, side == 0 ? c : b, side == 0 ? b : c);
    }

    @Test
    void trianglesWithoutAreaAreCrossedWithinTheirBoxesOnly() {
        SplittableRandom random = new SplittableRandom(7);
        Triangles.Builder out = Triangles.builder();
        Vec3[] from = new Vec3[2000];
        Vec3[] to = new Vec3[from.length];
        for (int i = 0; i < from.length; i++) {
            from[i] = point(random);
            to[i] = point(random);
            Vec3 between = from[i].plus(to[i].minus(from[i]).times(random.nextDouble()));
            out.triangle(vertex(out, from[i]), vertex(out, between), vertex(out, to[i]));
        }
        Facets facets = new Facets(out.build(), () -> false);
        MeshSearch search = new MeshSearch(facets);
        Ray ray = new Ray(new Spans());
        int met = 0;
        for (int n = 0; n < LINES; n++) {
            int aimed = n % from.length;
            Vec3 way = to[aimed].minus(from[aimed]);
            Vec3 at = from[aimed].plus(way.times(random.nextDouble()));
            Vec3 d = n % 2 == 0 ? point(random) : way.plus(point(random).times(1e-4));
            Vec3 o = at.minus(d.times(3));
            ray.start(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
            if (search.start(facets, Affine.IDENTITY, ray) && search.nearest(ray, 0, 100, MeshSearch.BOTH, 0, 0)) {
                Vec3 p = o.plus(d.times(search.nearestT()));
                int i = search.nearestNumber();
                met++;
                assertThat(Bounds.of(from[i], to[i]).grown(1e-11).contains(p)).as("%s of %s to %s", p, from[i], to[i]).isTrue();
            }
        }
        assertThat(met).as("rounding has lines meet some").isPositive();
    }

    private static Vec3 point(SplittableRandom random) {
        return new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    private static int vertex(Triangles.Builder out, Vec3 at) {
        return out.vertex(at.x(), at.y(), at.z());
    }

    @Test
    void aMillionLinesThroughCornersAndSidesEnterOnceAndLeaveOnce() {
        Triangles mesh = lattice();
        assertThat(mesh.openEdges()).isZero();
        assertThat(mesh.volume()).isEqualTo(512);
        Volume volume = place(mesh, Affine.IDENTITY);
        SplittableRandom random = new SplittableRandom(1);
        Ray ray = new Ray(new Spans());
        int wrong = 0;
        for (int n = 0; n < 1_000_000; n++) {
            // Through a corner or the middle of a side, strictly inside of the cube's outline from anywhere: in steps of a half.
            Vec3 through = new Vec3(half(random, 7), half(random, 7), half(random, 7));
            Vec3 way = new Vec3(half(random, 12), half(random, 12), half(random, 12));
            if (way.equals(Vec3.ZERO)) {
                continue;
            }
            Vec3 d = n % 2 == 0 ? way : n % 4 == 1 ? new Vec3(0, 0, way.x() < 0 ? -1 : 1) : new Vec3(way.y() < 0 ? -1 : 1, 0, 0);
            Vec3 o = through.minus(d.times(16));
            ray.start(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
            Spans spans = ray.spans;
            volume.spans(ray, spans);
            wrong += spans.size() == 2 ? 0 : 1;
            spans.release(0);
            ray.start(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
            volume.nearest(ray);
            wrong += ray.part == 0 && ray.max < 16 ? 0 : 1;
        }
        assertThat(wrong).isZero();
    }

    private static double half(SplittableRandom random, int most) {
        return random.nextInt(-most, most + 1) / 2.0;
    }

    /** Where numbers are rounded: towards corners and points of sides of a ball, from outside; each is entered as often as left, and not missed. */
    @Test
    void linesTowardsCornersAndSidesOfABallNeverSlipThrough() {
        Triangles mesh = Meshes.ball(1, 24);
        SplittableRandom random = new SplittableRandom(2);
        for (Affine map : new Affine[] {Affine.IDENTITY, new Placement(new Vec3(1e3, -20, 7), new Vec3(10, 20, 30), new Vec3(2, 0.3, -1)).toParent(),
            new Placement(new Vec3(0, 3e-9, 0), Vec3.ZERO, new Vec3(1e-8, 1e-8, 1e-8)).toParent()}) {
            Volume volume = place(mesh, map);
            Ray ray = new Ray(new Spans());
            for (int n = 0; n < 300_000; n++) {
                int t = random.nextInt(mesh.count());
                Vec3 a = mesh.place(mesh.corner(t, 0));
                Vec3 b = mesh.place(mesh.corner(t, 1));
                Vec3 aim = n % 2 == 0 ? a : a.plus(b.minus(a).times(random.nextDouble()));
                Vec3 from = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5).normalized().times(3);
                if (from.dot(aim) < 1.8) {
                    continue;
                }
                Vec3 o = map.point(from);
                Vec3 d = map.point(aim).minus(o).normalized();
                ray.start(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
                volume.spans(ray, ray.spans);
                assertThat(ray.spans.size()).isEqualTo(2);
                ray.spans.release(0);
                volume.nearest(ray);
                assertThat(ray.part).isZero();
            }
        }
    }

    /** Corners that are floats stand once more by triangle: what lines meet is the same as where one that no triangle has is none. */
    @Test
    void cornersThatAreFloatsAreMetAsOthers() {
        Triangles ball = Meshes.ball(1, 24);
        int[] corners = new int[3 * ball.count()];
        double[] places = new double[9 * ball.count() + 3];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = i;
            Vec3 at = ball.place(ball.corner(i / 3, i % 3));
            places[3 * i] = (float) at.x();
            places[3 * i + 1] = (float) at.y();
            places[3 * i + 2] = (float) at.z();
        }
        Volume floats = place(Triangles.of(places, corners), Affine.IDENTITY);
        places[places.length - 1] = 0.1;
        Volume doubles = place(Triangles.of(places, corners), Affine.IDENTITY);
        SplittableRandom random = new SplittableRandom(3);
        Ray ray = new Ray(new Spans());
        Ray other = new Ray(new Spans());
        int hits = 0;
        for (int n = 0; n < 100_000; n++) {
            Vec3 o = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5).times(4);
            Vec3 d = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5).normalized();
            ray.start(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
            floats.nearest(ray);
            other.start(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
            doubles.nearest(other);
            assertThat(other.part).isEqualTo(ray.part);
            assertThat(other.face).isEqualTo(ray.face);
            assertThat(other.max).isEqualTo(ray.max);
            hits += ray.part >= 0 ? 1 : 0;
        }
        assertThat(hits).isGreaterThan(10_000);
    }

    /** A ray leaves word where the triangle stands that it has met; who describes it without that, or with the word of another, says the same. */
    @Test
    void whereATriangleWasMetMakesNoDifferenceToItsNormal() {
        Triangles ball = Meshes.ball(1, 24);
        Triangles whole = ball.transformed(new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(8, 8, 8)).toParent());
        double[] places = new double[3 * whole.vertexCount()];
        for (int i = 0; i < places.length; i++) {
            Vec3 at = whole.place(i / 3);
            places[i] = Math.rint(i % 3 == 0 ? 64 * at.x() : i % 3 == 1 ? 64 * at.y() : 64 * at.z());
        }
        int[] corners = new int[3 * whole.count()];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = whole.corner(i / 3, i % 3);
        }
        for (Triangles mesh : new Triangles[] {whole, Triangles.of(places, corners)}) {
            Facets facets = new Facets(mesh, () -> false);
            assertThat(facets.own.length + facets.corners.length).isEqualTo(mesh.equals(whole) ? Facets.EACH * mesh.count() : Sieve.EACH * mesh.count() + Sieve.BEHIND);
            Volume volume = place(mesh, Affine.IDENTITY);
            MeshPart part = new MeshPart(0, mesh, facets, Affine.IDENTITY);
            SplittableRandom random = new SplittableRandom(4);
            Ray ray = new Ray(new Spans());
            Hit hit = new Hit();
            Hit other = new Hit();
            for (int n = 0; n < 20_000; n++) {
                Vec3 d = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5).normalized();
                ray.start(0.1 - 2000 * d.x(), 0.2 - 2000 * d.y(), 0.3 - 2000 * d.z(), d.x(), d.y(), d.z());
                volume.nearest(ray);
                assertThat(ray.part).isZero();
                int face = ray.face;
                assertThat(facets.isAt(ray.hint, face)).isTrue();
                hit.hint = ray.hint;
                part.describe(face, hit);
                other.hint = n % 3 == 0 ? -1 : n % 3 == 1 ? Integer.MAX_VALUE : random.nextInt(mesh.count());
                part.describe(face, other);
                assertThat(new Vec3(hit.nx, hit.ny, hit.nz)).isEqualTo(new Vec3(other.nx, other.ny, other.nz));
            }
        }
    }

    @Test
    void whatOverlapsIsOneBodyAndHollowsAreHollow() {
        Volume two = place(Meshes.both(Meshes.cube(1), Meshes.cube(1), 1.2, false), Affine.IDENTITY);
        assertThat(along(two, new Vec3(-5, 0.2, 0.3), Vec3.X)).containsExactly(new double[] {4, 7.2}, within(1e-14));
        Volume hollow = place(Meshes.both(Meshes.cube(2), Meshes.cube(1), 0, true), Affine.IDENTITY);
        assertThat(along(hollow, new Vec3(-5, 0.2, 0.3), Vec3.X)).containsExactly(new double[] {3, 4, 6, 7}, within(1e-14));
        assertThat(hollow.contains(new Vec3(1.5, 0, 0))).isTrue();
        assertThat(hollow.contains(Vec3.ZERO)).isFalse();
        // Who starts inside of what is wound around twice leaves through the outermost wall.
        Ray ray = new Ray(new Spans());
        ray.start(0.6, 0.2, 0.3, 1, 0, 0);
        two.nearest(ray);
        assertThat(ray.max).isCloseTo(1.6, within(1e-14));
    }

    private static double[] along(Volume volume, Vec3 o, Vec3 d) {
        Ray ray = new Ray(new Spans());
        ray.start(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
        volume.spans(ray, ray.spans);
        double[] all = new double[ray.spans.size()];
        for (int i = 0; i < all.length; i++) {
            all[i] = ray.spans.t(i);
        }
        return all;
    }

    /** Of the crossings, those that both have lie within what the fields cut off; a line may miss one of them only beside the rim. */
    @Test
    void ballAndTorusAreCrossedWhereTheyAreInClosedForm() {
        compare(Meshes.ball(1, 300), new Sphere(1), 1e-4);
        compare(Meshes.torus(1, 0.4, 600, 300), new Torus(1, 0.4), 1e-4);
    }

    private static void compare(Triangles mesh, Solid exact, double depth) {
        Volume fine = place(mesh, Affine.IDENTITY);
        Volume smooth = exact.place(Affine.IDENTITY, Parts.UNTOLD);
        SplittableRandom random = new SplittableRandom(3);
        int different = 0;
        for (int n = 0; n < 20_000; n++) {
            Vec3 o = new Vec3(random.nextDouble(-3, 3), random.nextDouble(-3, 3), random.nextDouble(-3, 3));
            Vec3 d = new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)).minus(o).normalized();
            double[] a = along(fine, o, d);
            double[] b = along(smooth, o, d);
            if (a.length != b.length) {
                different++;
                continue;
            }
            for (int i = 0; i < a.length; i++) {
                different += Math.abs(a[i] - b[i]) > 100 * depth ? 1 : 0;
            }
        }
        assertThat(different).isLessThan(40);
    }

    private static Volume place(Triangles mesh, Affine map) {
        return mesh.place(map, part -> Parts.UNTOLD);
    }
}
