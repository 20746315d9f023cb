package cz.paprsek.shape.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Vec3;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Seams that programs reckon twice, and round. */
class SeamsTest {
    private static final int AROUND = 48;
    private static final int ACROSS = 16;
    private static final double WELD = 1e-5;

    /** A ring whose first and last row of vertices lie in one place but for rounding, as three.js writes it; both ways around. */
    private static Triangles ring(double rounding, Random random) {
        Triangles.Builder builder = Triangles.builder();
        for (int i = 0; i <= AROUND; i++) {
            for (int j = 0; j <= ACROSS; j++) {
                double u = 2 * Math.PI * i / AROUND;
                double v = 2 * Math.PI * j / ACROSS;
                double r = 3 + Math.cos(v);
                builder.vertex(r * Math.cos(u) + rounding * random.nextDouble(), r * Math.sin(u) + rounding * random.nextDouble(), Math.sin(v) + rounding * random.nextDouble());
                builder.map(i * (ACROSS + 1) + j, (double) i / AROUND, (double) j / ACROSS);
            }
        }
        for (int i = 0; i < AROUND; i++) {
            for (int j = 0; j < ACROSS; j++) {
                int a = i * (ACROSS + 1) + j;
                int b = a + ACROSS + 1;
                builder.triangle(a, b, b + 1);
                builder.triangle(a, b + 1, a + 1);
            }
        }
        return builder.build();
    }

    @Test
    void aRingIsClosedAndAsLargeAsBefore() {
        double exact = ring(0, new Random(1)).sewn(WELD).volume();
        for (double rounding : new double[] {0, 1e-12, 1e-8, 1e-6}) {
            Triangles open = ring(rounding, new Random(1));
            assertThat(open.openEdges()).as("open, as its numbers say").isGreaterThanOrEqualTo(2 * AROUND);
            Triangles closed = open.sewn(WELD);
            assertThat(closed.openEdges()).isZero();
            assertThat(open.placesSewn(WELD)).isBetween(AROUND, AROUND + ACROSS + 1);
            assertThat(open.shortSides(WELD)).isZero();
            assertThat(closed.count()).isEqualTo(open.count());
            assertThat(closed.volume()).isCloseTo(exact, within(1e-6 * exact));
            assertThat(closed.u(AROUND * (ACROSS + 1))).as("pictures stay").isEqualTo(1);
        }
    }

    @Test
    void whatIsClosedOrFartherApartStaysAsItIs() {
        Triangles open = ring(1e-8, new Random(1));
        assertThat(open.sewn(0)).isSameAs(open);
        assertThat(ring(1e-3, new Random(1)).sewn(WELD).openEdges()).isEqualTo(2 * AROUND + 2 * ACROSS);
        Triangles closed = open.sewn(WELD);
        assertThat(closed.sewn(WELD)).isSameAs(closed);
    }

    /** A sheet whose rim is finer than what is welded, and a chain of places along it. */
    @Test
    void noSideOfATriangleVanishes() {
        Triangles.Builder builder = Triangles.builder();
        int far = builder.vertex(0, 1, 0);
        for (int i = 0; i < 50; i++) {
            builder.vertex(i * 1e-6, 0, 0);
        }
        builder.vertex(1, 0, 0);
        for (int i = 1; i <= 50; i++) {
            builder.triangle(far, i, i + 1);
        }
        Triangles sheet = builder.build();
        assertThat(sheet.sewn(WELD)).isSameAs(sheet);
        Triangles.Builder short3 = Triangles.builder();
        int[] v = {short3.vertex(0, 0, 0), short3.vertex(1e-6, 0, 0), short3.vertex(0, 1, 0)};
        short3.triangle(v[0], v[1], v[2]);
        assertThat(short3.build().sewn(WELD).count()).isEqualTo(1);
        assertThat(short3.build().shortSides(WELD)).isEqualTo(1);
    }

    /** Places and not their numbers decide: the same triangles in any order are the same after. */
    @Test
    void theOrderOfVerticesMakesNoDifference() {
        Triangles open = ring(1e-6, new Random(3));
        List<Integer> order = new ArrayList<>();
        for (int i = 0; i < open.vertexCount(); i++) {
            order.add(i);
        }
        Triangles closed = open.sewn(WELD);
        Collections.shuffle(order, new Random(4));
        double[] places = new double[3 * order.size()];
        int[] corners = new int[3 * open.count()];
        for (int i = 0; i < order.size(); i++) {
            Vec3 place = open.place(i);
            places[3 * order.get(i)] = place.x();
            places[3 * order.get(i) + 1] = place.y();
            places[3 * order.get(i) + 2] = place.z();
        }
        for (int i = 0; i < corners.length; i++) {
            corners[i] = order.get(open.corner(i / 3, i % 3));
        }
        Triangles shuffled = Triangles.of(places, corners).sewn(WELD);
        for (int i = 0; i < order.size(); i++) {
            assertThat(shuffled.place(order.get(i))).isEqualTo(closed.place(i));
        }
    }

    /** A cloud of loose triangles in one cell takes no longer than others. */
    @Test
    void aCloudOfLooseTrianglesIsLeftAtOnce() {
        Random random = new Random(5);
        Triangles.Builder builder = Triangles.builder();
        for (int i = 0; i < 30_000; i++) {
            builder.vertex(random.nextDouble() * 1e-9, random.nextDouble() * 1e-9, random.nextDouble() * 1e-9);
        }
        builder.vertex(1, 0, 0);
        for (int i = 0; i < 30_000; i += 3) {
            builder.triangle(i, i + 1, i + 2);
        }
        builder.triangle(0, 1, 30_000);
        Triangles cloud = builder.build();
        assertThat(cloud.sewn(WELD)).isSameAs(cloud);
    }
}
