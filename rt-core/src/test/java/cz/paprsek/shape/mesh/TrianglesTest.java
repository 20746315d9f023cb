package cz.paprsek.shape.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Placement;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class TrianglesTest {
    private static final double[] THREE = {0, 0, 0, 1, 0, 0, 0, 1, 0};

    @Test
    void aCubeHasTheVolumeAndAreaOfACube() {
        Triangles cube = Meshes.cube(1.5);
        assertThat(cube.volume()).isEqualTo(27);
        assertThat(cube.area()).isEqualTo(54);
        assertThat(cube.bounds()).isEqualTo(new Bounds(-1.5, -1.5, -1.5, 1.5, 1.5, 1.5));
        assertThat(cube.isClosed()).isTrue();
        assertThat(cube.oriented()).isSameAs(cube);
    }

    /** A ball of n rings: each tetrahedron in closed form is too long; the limit is not, and errors fall with the square of n. */
    @Test
    void ballAndTorusComeNearTheirClosedForms() {
        double ball = 4 * Math.PI / 3;
        double coarse = ball - Meshes.ball(1, 50).volume();
        double fine = ball - Meshes.ball(1, 200).volume();
        assertThat(coarse / fine).isCloseTo(16, within(0.1));
        assertThat(fine / ball).isBetween(0.0, 2e-4);
        assertThat(Meshes.ball(1, 200).area()).isCloseTo(4 * Math.PI, within(2e-3));
        Triangles torus = Meshes.torus(2, 0.5, 400, 200);
        assertThat(torus.volume()).isCloseTo(2 * Math.PI * Math.PI * 2 * 0.25, within(3e-3));
        assertThat(torus.area()).isCloseTo(4 * Math.PI * Math.PI * 2 * 0.5, within(3e-3));
        assertThat(torus.isClosed()).isTrue();
    }

    @Test
    void trianglesWithCornersOfTheirOwnAreClosedAllTheSame() {
        Triangles apart = Meshes.apart(Meshes.torus(1, 0.3, 30, 20));
        assertThat(apart.vertexCount()).isEqualTo(3 * apart.count());
        assertThat(apart.openEdges()).isZero();
    }

    @Test
    void bothZerosAreOnePlace() {
        double[] places = Meshes.cube(1).places().clone();
        for (int i = 0; i < places.length; i++) {
            places[i] = places[i] < 0 ? 0.0 : places[i];
        }
        Triangles cube = Meshes.apart(Triangles.of(places, Meshes.cube(1).corners()));
        double[] signed = cube.places().clone();
        for (int i = 0; i < signed.length; i += 5) {
            signed[i] = signed[i] == 0 ? -0.0 : signed[i];
        }
        assertThat(Triangles.of(signed, cube.corners()).isClosed()).isTrue();
    }

    @Test
    void aMissingTriangleLeavesThreeEdgesOpen() {
        Triangles cube = Meshes.cube(1);
        Triangles open = Triangles.of(cube.places(), Arrays.copyOf(cube.corners(), 33));
        assertThat(open.openEdges()).isEqualTo(3);
        assertThat(open.isClosed()).isFalse();
    }

    @Test
    void trianglesTurnedAtRandomAreTurnedBack() {
        Triangles torus = Meshes.torus(1, 0.3, 40, 30);
        Random random = new Random(1);
        for (double share : new double[] {0.01, 0.3, 0.9}) {
            int[] corners = torus.corners().clone();
            for (int t = 0; t < torus.count(); t++) {
                if (random.nextDouble() < share) {
                    int b = corners[3 * t + 1];
                    corners[3 * t + 1] = corners[3 * t + 2];
                    corners[3 * t + 2] = b;
                }
            }
            Triangles mixed = Triangles.of(torus.places(), corners);
            assertThat(mixed.isClosed()).isTrue();
            Triangles oriented = mixed.oriented();
            assertThat(sameWay(oriented, torus)).as("%s turned", share).isEqualTo(torus.count());
            assertThat(oriented.oriented()).isSameAs(oriented);
            assertThat(Triangles.of(oriented.places(), oriented.corners()).oriented().openEdges()).isZero();
        }
    }

    /** How many triangles have their corners in the same cyclic order. */
    private static int sameWay(Triangles a, Triangles b) {
        int same = 0;
        for (int t = 0; t < a.count(); t++) {
            for (int k = 0; k < 3; k++) {
                same += a.corner(t, 0) == b.corner(t, k) && a.corner(t, 1) == b.corner(t, (k + 1) % 3) ? 1 : 0;
            }
        }
        return same;
    }

    @Test
    void whatIsInsideOutIsPutRightAndHollowsStay() {
        Triangles ball = Meshes.ball(1, 10);
        Triangles hollow = Meshes.both(Meshes.cube(2), ball, 0, true);
        assertThat(hollow.oriented()).isSameAs(hollow);
        assertThat(hollow.volume()).isCloseTo(64 - ball.volume(), within(1e-9));
        Triangles beside = Meshes.both(Meshes.cube(2), ball, 5, true);
        assertThat(beside.oriented().volume()).isCloseTo(64 + ball.volume(), within(1e-9));
        Triangles inverted = hollow.transformed(Affine.scaling(new Vec3(1, 1, -1))).transformed(Affine.scaling(new Vec3(1, 1, -1)));
        assertThat(inverted).isEqualTo(hollow);
        Triangles all = Triangles.of(hollow.places(), turned(hollow.corners()));
        assertThat(all.volume()).isCloseTo(ball.volume() - 64, within(1e-9));
        assertThat(all.oriented().volume()).isCloseTo(64 - ball.volume(), within(1e-9));
    }

    private static int[] turned(int[] corners) {
        int[] turned = corners.clone();
        for (int i = 0; i < corners.length; i += 3) {
            turned[i] = corners[i + 1];
            turned[i + 1] = corners[i];
        }
        return turned;
    }

    /** A strip with half a twist has no right way round: its rim is open, and one seam. */
    @Test
    void aMobiusStripStaysOpen() {
        Triangles.Builder out = Triangles.builder();
        int n = 30;
        for (int i = 0; i < n; i++) {
            double a = 2 * Math.PI * i / n;
            for (int side = -1; side <= 1; side += 2) {
                double r = 1 + 0.3 * side * StrictMath.cos(a / 2);
                out.vertex(r * StrictMath.cos(a), 0.3 * side * StrictMath.sin(a / 2), r * StrictMath.sin(a));
            }
        }
        for (int i = 0; i < n; i++) {
            boolean last = i == n - 1;
            int a = 2 * i;
            int b = 2 * i + 1;
            int c = last ? 1 : 2 * i + 2;
            int d = last ? 0 : 2 * i + 3;
            out.triangle(a, b, c);
            out.triangle(b, d, c);
        }
        assertThat(out.build().openEdges()).isGreaterThanOrEqualTo(2 * n);
    }

    @Test
    void aTriangleWithTwoCornersInOnePlaceOpensNothing() {
        Triangles cube = Meshes.cube(1);
        int[] corners = Arrays.copyOf(cube.corners(), 39);
        corners[36] = 3;
        corners[37] = 3;
        corners[38] = 5;
        assertThat(Triangles.of(cube.places(), corners).openEdges()).isZero();
    }

    @Test
    void mapsMoveTrianglesAndTheirNormals() {
        Triangles ball = Meshes.ball(1, 12);
        float[] normals = new float[ball.places().length];
        for (int i = 0; i < normals.length; i++) {
            normals[i] = (float) ball.places()[i];
        }
        Affine map = new Placement(new Vec3(1, 2, 3), new Vec3(20, 30, 40), new Vec3(2, -1, 0.5)).toParent();
        Triangles moved = ball.withNormals(normals).transformed(map);
        assertThat(moved.volume()).isCloseTo(ball.volume(), within(1e-12));
        for (int v = 0; v < moved.vertexCount(); v++) {
            Vec3 local = ball.place(v);
            assertThat(map.point(local).minus(moved.place(v)).length()).isLessThan(1e-14);
            // Out of the surface: the way from the middle is on the normal's side.
            assertThat(moved.normal(v).dot(moved.place(v).minus(new Vec3(1, 2, 3)))).isPositive();
            assertThat(moved.normal(v).length()).isCloseTo(1, within(1e-6));
            for (Vec3 along : List.of(local.cross(Vec3.X), local.cross(Vec3.Y), local.cross(Vec3.Z))) {
                assertThat(moved.normal(v).dot(map.direction(along))).as("upright on the surface").isCloseTo(0, within(1e-6));
            }
        }
    }

    @Test
    void whatComesBeforeThePartsIsAPartWithoutAName() {
        Triangles.Builder out = Triangles.builder();
        out.vertex(0, 0, 0);
        out.vertex(1, 0, 0);
        out.vertex(0, 1, 0);
        for (int i = 0; i < 200; i++) {
            out.triangle(0, 1, 2);
            out.part(i % 2 == 0 ? "one" : "");
        }
        Triangles all = out.build();
        assertThat(all.parts()).containsExactly("", "one");
        for (int i = 0; i < 200; i++) {
            assertThat(all.part(i)).isEqualTo(i % 2);
        }
    }

    @Test
    void aPartIsTakenOutWithWhatBelongsToIt() {
        Triangles.Builder out = Triangles.builder().part("one");
        for (int i = 0; i < 6; i++) {
            int v = out.vertex(i, i * i, 1);
            out.normal(v, 0, 0, i).map(v, i, -i);
        }
        out.triangle(0, 1, 2);
        out.part("two");
        out.triangle(3, 4, 5);
        out.part("one");
        out.triangle(0, 2, 5);
        Triangles all = out.build();
        assertThat(all.parts()).containsExactly("one", "two");
        Triangles two = all.onlyPart(1);
        assertThat(two.count()).isEqualTo(1);
        assertThat(two.vertexCount()).isEqualTo(3);
        assertThat(two.place(0)).isEqualTo(new Vec3(3, 9, 1));
        assertThat(two.normal(1)).isEqualTo(new Vec3(0, 0, 4));
        assertThat(two.v(2)).isEqualTo(-5);
        assertThat(two.parts()).containsExactly("two");
        assertThat(all.onlyPart(0).vertexCount()).isEqualTo(4);
    }

    @Test
    void whatCannotBeIsRefusedInASentence() {
        assertThatThrownBy(() -> Triangles.of(THREE, new int[0])).hasMessage("a mesh needs at least one triangle, but has none");
        assertThatThrownBy(() -> Triangles.of(THREE, new int[] {0, 1, 3})).hasMessage("a corner of triangle 0 is vertex 3, but vertices have numbers from 0 to 2");
        assertThatThrownBy(() -> Triangles.of(THREE, new int[] {0, 1, -1})).hasMessageContaining("vertex -1");
        assertThatThrownBy(() -> Triangles.of(THREE, new int[] {0, 1})).hasMessageContaining("three corners");
        assertThatThrownBy(() -> Triangles.of(new double[] {0, 0, 0, 1, 0, 0, 0, Double.NaN, 0}, new int[] {0, 1, 2}))
                .hasMessage("coordinate y of vertex 2 must be a finite number, but is NaN");
        Triangles one = Triangles.of(THREE, new int[] {0, 1, 2});
        assertThatThrownBy(() -> one.withNormals(new float[4])).hasMessageContaining("normal of three numbers");
        assertThatThrownBy(() -> one.withNormals(new float[] {0, 0, 0, 0, Float.NaN, 0, 0, 0, 0})).hasMessageContaining("normal of vertex 1");
        assertThatThrownBy(() -> one.withMap(new float[9])).hasMessageContaining("u and v");
        assertThatThrownBy(() -> one.withParts(List.of("a"), new int[] {1})).hasMessageContaining("part 1");
        assertThatThrownBy(() -> one.withParts(List.of(), new int[] {})).hasMessageContaining("at least one part");
        assertThatThrownBy(() -> Triangles.builder().build()).hasMessageContaining("at least one triangle");
        assertThatThrownBy(() -> Triangles.builder().expect(Integer.MAX_VALUE, 1)).hasMessage("a mesh has at most 715827877 vertices and as many triangles, but here are 2147483647");
    }
}
