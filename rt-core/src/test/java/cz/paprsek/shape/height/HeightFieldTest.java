package cz.paprsek.shape.height;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Extrude;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.mesh.Triangles;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class HeightFieldTest {
    private static final Vec3 SIZE = new Vec3(3, 1.5, 2);

    private static Volume placed(Solid solid) {
        return solid.place(Affine.rotation(new Vec3(10, 20, 30)), Parts.UNTOLD);
    }

    private static Heights random(Random random, int columns, int rows) {
        float[] steps = new float[columns * rows];
        for (int i = 0; i < steps.length; i++) {
            steps[i] = 20 + random.nextInt(236);
        }
        return new Heights(columns, rows, steps, 1.0 / 255);
    }

    /** The same cells, walls and bottom as triangles. */
    private static Mesh mesh(Heights heights, Vec3 size) {
        Triangles.Builder builder = Triangles.builder();
        int columns = heights.columns();
        int rows = heights.rows();
        for (int foot = 0; foot < 2; foot++) {
            for (int i = 0; i < columns * rows; i++) {
                builder.vertex(size.x() * ((double) (i % columns) / (columns - 1) - 0.5), foot == 1 ? 0 : size.y() * heights.at(i % columns, i / columns),
                        size.z() * (rowOf(i, columns) / (rows - 1) - 0.5));
            }
        }
        int below = columns * rows;
        for (int z = 0; z + 1 < rows; z++) {
            for (int x = 0; x + 1 < columns; x++) {
                int a = z * columns + x;
                for (int[] t : new int[][] {{a, a + columns + 1, a + 1}, {a, a + columns, a + columns + 1}}) {
                    builder.triangle(t[0], t[1], t[2]);
                    builder.triangle(below + t[0], below + t[2], below + t[1]);
                }
            }
        }
        for (int x = 0; x + 1 < columns; x++) {
            wall(builder, x, x + 1, below);
            wall(builder, (rows - 1) * columns + x + 1, (rows - 1) * columns + x, below);
        }
        for (int z = 0; z + 1 < rows; z++) {
            wall(builder, (z + 1) * columns, z * columns, below);
            wall(builder, z * columns + columns - 1, (z + 1) * columns + columns - 1, below);
        }
        return Mesh.of(builder.build());
    }

    private static double rowOf(int point, int columns) {
        return Math.floorDiv(point, columns);
    }

    private static void wall(Triangles.Builder builder, int a, int b, int below) {
        builder.triangle(a, b, below + b);
        builder.triangle(a, below + b, below + a);
    }

    private static void start(Ray ray, Random random) {
        Vec3 from = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized().times(4);
        Vec3 to = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.2, random.nextDouble() - 0.5).times(2.5);
        Vec3 d = to.minus(from).normalized();
        ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
    }

    /** Counts rays that meet both in the same places. */
    private static void same(Volume field, Volume other, int rays, double tolerance) {
        Random random = new Random(7);
        Spans spans = new Spans();
        Ray ray = new Ray(spans);
        int met = 0;
        for (int i = 0; i < rays; i++) {
            start(ray, random);
            field.spans(ray, spans);
            double[] first = new double[spans.size()];
            for (int j = 0; j < first.length; j++) {
                first[j] = spans.t(j);
            }
            spans.release(0);
            other.spans(ray, spans);
            assertThat(spans.size()).as("ray %d", i).isEqualTo(first.length);
            for (int j = 0; j < first.length; j++) {
                assertThat(first[j]).as("crossing %d of ray %d", j, i).isCloseTo(spans.t(j), within(tolerance));
            }
            met += first.length;
            spans.release(0);
        }
        assertThat(met).isGreaterThan(rays / 2);
    }

    @Test
    void everyCellIsMetAsTheTrianglesOfAMeshAre() {
        for (int[] size : new int[][] {{2, 2}, {3, 7}, {33, 20}}) {
            Heights heights = random(new Random(3), size[0], size[1]);
            same(placed(HeightField.of(heights, SIZE)), placed(mesh(heights, SIZE)), 4000, 1e-10);
        }
    }

    @Test
    void aRampOfGreysIsAWedge() {
        float[] ramp = new float[256 * 3];
        for (int i = 0; i < ramp.length; i++) {
            ramp[i] = i % 256;
        }
        Volume field = placed(HeightField.of(new Heights(256, 3, ramp, 1.0 / 255), new Vec3(2, 1, 1)));
        same(field, placed(new Extrude("", "-1 0 1 0 1 1", 1, 0, 1), Affine.translation(new Vec3(0, 0, -0.5))), 10_000, 1e-12);
    }

    private static Volume placed(Solid solid, Affine before) {
        return solid.place(Affine.rotation(new Vec3(10, 20, 30)).after(before), Parts.UNTOLD);
    }

    @Test
    void evenGreyIsABlock() {
        float[] flat = new float[65 * 65];
        Arrays.fill(flat, 1);
        same(placed(HeightField.of(new Heights(65, 65, flat, 0.5), SIZE)), placed(new Block(new Vec3(-1.5, 0, -1), new Vec3(1.5, 0.75, 1))), 10_000, 1e-12);
    }

    @Test
    void noRayThroughPointsOfTheGridSlipsBetweenTriangles() {
        Heights heights = random(new Random(5), 17, 17);
        Volume field = HeightField.of(heights, new Vec3(16, 8, 16)).place(Affine.IDENTITY, Parts.UNTOLD);
        Ray ray = new Ray(new Spans());
        Random random = new Random(11);
        for (int i = 0; i < 100_000; i++) {
            int column = 1 + random.nextInt(15);
            int row = 1 + random.nextInt(15);
            Vec3 below = new Vec3(column - 8, 8 * heights.at(column, row) - 0.01, row - 8);
            Vec3 d = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
            // Out of the ground into the ground again any number of times, but from inside one that is odd.
            ray.start(below.x(), below.y(), below.z(), d.x(), d.y(), d.z());
            Spans spans = ray.spans;
            field.spans(ray, spans);
            int ahead = 0;
            for (int j = 0; j < spans.size(); j++) {
                ahead += spans.t(j) > 0 ? 1 : 0;
                assertThat(j == 0 || spans.t(j) >= spans.t(j - 1)).isTrue();
            }
            assertThat(ahead % 2).as("ray %d", i).isEqualTo(1);
            spans.release(0);
        }
    }

    @Test
    void whatIsNoGridIsRefused() {
        assertThatThrownBy(() -> new Heights(1, 5, new float[5], 1)).hasMessage("heights must be given at 2 × 2 points or more, but are at 1 × 5");
        assertThatThrownBy(() -> new Heights(2, 2, new float[] {0, Float.NaN, 0, 0}, 1)).hasMessage("heights must be finite numbers, 0 or above, but one is NaN");
        assertThatThrownBy(() -> HeightField.of(" ", SIZE)).hasMessage("height-field file must not be blank");
        assertThatThrownBy(() -> HeightField.of("a.png", new Vec3(1, 0, 1))).hasMessageStartingWith("height-field extent must be");
    }
}
