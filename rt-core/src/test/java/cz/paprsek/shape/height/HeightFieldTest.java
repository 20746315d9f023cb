package cz.paprsek.shape.height;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Extrude;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.mesh.Triangles;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
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

    /** Whole numbers and zeros, as high as they say; points of the grid have whole coordinates from 0 on, less half the size. */
    private static Heights withZeros(int size) {
        Random random = new Random(size);
        float[] steps = new float[size * size];
        for (int i = 0; i < steps.length; i++) {
            steps[i] = Math.max(0, random.nextInt(8) - 2);
        }
        return new Heights(size, size, steps, 0.25);
    }

    private static Volume placedWithZeros(Heights heights, int size) {
        return HeightField.of(heights, new Vec3(size - 1, 4, size - 1)).place(Affine.IDENTITY, Parts.UNTOLD);
    }

    /** Where a line enters and leaves what lies below a profile, of which there are heights at even distances. */
    private static double[] crossings(double[] profile, double first, double apart, double y) {
        List<Double> found = new ArrayList<>();
        if (profile[0] > y) {
            found.add(first);
        }
        for (int i = 0; i + 1 < profile.length; i++) {
            if (profile[i] > y != profile[i + 1] > y) {
                found.add(first + apart * (i + (y - profile[i]) / (profile[i + 1] - profile[i])));
            }
        }
        if (profile[profile.length - 1] > y) {
            found.add(first + apart * (profile.length - 1));
        }
        return found.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** Stretches that lie behind the eye may be left out; of one around it the beginning only has to lie behind. */
    private static double[] ahead(double[] crossings) {
        int first = 0;
        while (first + 1 < crossings.length && crossings[first + 1] <= 1e-9) {
            first += 2;
        }
        return Arrays.stream(crossings).skip(first).map(t -> Math.max(0, t)).toArray();
    }

    private static void meets(Volume field, Vec3 from, Vec3 d, double[] expected, int[] met) {
        Spans spans = new Spans();
        Ray ray = new Ray(spans);
        ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
        field.spans(ray, spans);
        double[] found = new double[spans.size()];
        double first = Double.POSITIVE_INFINITY;
        for (int i = 0; i < found.length; i++) {
            found[i] = spans.t(i);
            first = found[i] > 0 ? Math.min(first, found[i]) : first;
        }
        spans.release(0);
        assertThat(ahead(found)).as("from %s along %s", from, d).containsExactly(ahead(expected), within(1e-9));
        field.nearest(ray);
        assertThat(ray.part >= 0 ? ray.max : Double.POSITIVE_INFINITY).as("nearest from %s along %s", from, d).isEqualTo(first);
        ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
        if (Arrays.stream(expected).noneMatch(t -> Math.abs(t) < 1e-9)) {
            assertThat(field.holdsOrigin(ray)).as("inside at %s", from).isEqualTo(Arrays.stream(expected).filter(t -> t < 0).count() % 2 != 0);
        }
        met[0] += expected.length;
    }

    /** From outside, and from every whole distance along the ray: on its way it lies in the ground as often as not. */
    private static void meets(Volume field, Vec3 start, Vec3 d, double length, double[] expected, int[] met) {
        for (double far = 0; far <= length; far += 1) {
            double moved = far;
            meets(field, start.plus(d.times(far)), d, Arrays.stream(expected).map(t -> t - moved).toArray(), met);
        }
    }

    @Test
    void raysAlongAxesMeetWhatTheHeightsSay() {
        int[] met = new int[1];
        for (int size : new int[] {2, 3, 9}) {
            Heights heights = withZeros(size);
            Volume field = placedWithZeros(heights, size);
            double half = (size - 1) / 2.0;
            for (int row = 0; row + 1 < size; row++) {
                for (int column = 0; column < size; column++) {
                    if (row > 0 && column > 0 && column + 1 < size) {
                        double height = heights.at(column, row) * 4;
                        double[] down = height > 0 ? new double[] {20 - height, 20} : new double[0];
                        double[] up = height > 0 ? new double[] {3, 3 + height} : new double[0];
                        meets(field, new Vec3(column - half, 20, row - half), new Vec3(0, -1, 0), down, met);
                        meets(field, new Vec3(column - half, -3, row - half), new Vec3(0, 1, 0), up, met);
                    }
                }
                for (double y = 0.3; y < 6; y += 1) {
                    // Through the middles of cells, where every half step is another triangle; and over points of the grid.
                    along(field, heights, size, row, y, true, met);
                    if (row > 0) {
                        along(field, heights, size, row, y, false, met);
                    }
                }
            }
        }
        assertThat(met[0]).isGreaterThan(1000);
    }

    private static void along(Volume field, Heights heights, int size, int row, double y, boolean isBetween, int[] met) {
        double[] profile = new double[isBetween ? 2 * size - 1 : size];
        for (int i = 0; i < profile.length; i++) {
            int column = isBetween ? Math.floorDiv(i, 2) : i;
            int next = isBetween && i % 2 != 0 ? column + 1 : column;
            profile[i] = 2 * (heights.at(column, row) + heights.at(next, isBetween ? row + 1 : row));
        }
        double half = (size - 1) / 2.0;
        double z = row - half + (isBetween ? 0.5 : 0);
        double apart = isBetween ? 0.5 : 1;
        meets(field, new Vec3(-half - 3, y, z), new Vec3(1, 0, 0), size + 5, crossings(profile, 3, apart, y), met);
        meets(field, new Vec3(half + 3, y, z), new Vec3(-1, 0, 0), size + 5, crossings(turned(profile), 3, apart, y), met);
    }

    private static double[] turned(double[] profile) {
        double[] turned = new double[profile.length];
        for (int i = 0; i < turned.length; i++) {
            turned[i] = profile[profile.length - 1 - i];
        }
        return turned;
    }

    /** The cut of each cell, from corner to corner of the whole field. */
    @Test
    void raysAlongTheCutsOfCellsMeetWhatTheHeightsSay() {
        int[] met = new int[1];
        Vec3 d = new Vec3(Math.sqrt(0.5), 0, Math.sqrt(0.5));
        for (int size : new int[] {2, 3, 9}) {
            Heights heights = withZeros(size);
            Volume field = placedWithZeros(heights, size);
            double half = (size - 1) / 2.0;
            for (int first = 0; first + 1 < size; first++) {
                double[] profile = new double[size - first];
                for (int i = 0; i < profile.length; i++) {
                    profile[i] = 4 * heights.at(first + i, i);
                }
                for (double y = 0.3; y < 6; y += 1) {
                    meets(field, new Vec3(first - half - 2, y, -half - 2), d, 16, crossings(profile, 2 * Math.sqrt(2), Math.sqrt(2), y), met);
                    meets(field, new Vec3(half + 2, y, half - first + 2), d.times(-1), 16, crossings(turned(profile), 2 * Math.sqrt(2), Math.sqrt(2), y), met);
                }
            }
        }
        assertThat(met[0]).isGreaterThan(1000);
    }

    @Test
    void heightsBeyondAllSizesAreRefused() {
        assertThatThrownBy(() -> HeightField.of(2, 2, new float[] {0, 0, 0, 1e30f}, new Vec3(1, 1e20, 1))).hasMessageStartingWith("height-field height must be a number from ");
        assertThatThrownBy(() -> HeightField.of(2, 2, new float[] {0, 0, 0, 1e-30f}, new Vec3(1, 1e-20, 1))).hasMessageStartingWith("height-field height must be a number from ");
        assertThat(HeightField.of(2, 2, new float[4], SIZE).bounds().maxY()).isZero();
    }

    @Test
    void whatIsNoGridIsRefused() {
        assertThatThrownBy(() -> new Heights(1, 5, new float[5], 1)).hasMessage("heights must be given at 2 × 2 points or more, but are at 1 × 5");
        assertThatThrownBy(() -> new Heights(2, 2, new float[] {0, Float.NaN, 0, 0}, 1)).hasMessage("heights must be finite numbers, 0 or above, but one is NaN");
        assertThatThrownBy(() -> HeightField.of(" ", SIZE)).hasMessage("height-field file must not be blank");
        assertThatThrownBy(() -> HeightField.of("a.png", new Vec3(1, 0, 1))).hasMessageStartingWith("height-field extent must be");
    }

    @Test
    void explanationsTellTheTriangleAndWhereInIt() {
        int columns = 5;
        int rows = 4;
        Heights heights = random(new Random(8), columns, rows);
        Scene scene = Scene.EMPTY.withSettings(new RenderSettings(24, 16, 2, 1)).withCamera(Camera.lookingAt(new Vec3(0.3, 4, 1.5), Vec3.ZERO)).plus(SceneObject.of(HeightField.of(heights, SIZE)));
        RenderScene prepared = RenderScene.of(scene);
        int told = 0;
        for (int i = 0; i < 24 * 16; i++) {
            Encounter.Place place = prepared.explain(i % 24, i / 24).rays().get(0).encounter().map(Encounter::place).orElse(null);
            if (place == null || place.triangle().isEmpty()) {
                assertThat(place == null || Math.abs(place.normal().y()) < 1e-9).as("walls have none").isTrue();
                continue;
            }
            told++;
            Encounter.Triangle triangle = place.triangle().get();
            int cell = triangle.number() / 2;
            int x = cell % (columns - 1);
            int z = cell / (columns - 1);
            boolean isLower = triangle.number() % 2 == 0;
            Vec3 a = corner(heights, x, z);
            Vec3 b = isLower ? corner(heights, x + 1, z) : corner(heights, x, z + 1);
            Vec3 c = corner(heights, x + 1, z + 1);
            Vec3 share = triangle.shares();
            assertThat(a.times(share.x()).plus(b.times(share.y())).plus(c.times(share.z())).minus(place.point()).length()).isLessThan(1e-9);
            assertThat(Math.min(share.x(), Math.min(share.y(), share.z()))).isBetween(0.0, 1.0);
            assertThat(Math.abs(b.minus(a).cross(c.minus(a)).normalized().dot(place.normal()))).isCloseTo(1, within(1e-12));
        }
        assertThat(told).isGreaterThan(100);
    }

    private static Vec3 corner(Heights heights, int x, int z) {
        return new Vec3(SIZE.x() * (x / (heights.columns() - 1.0) - 0.5), SIZE.y() * heights.at(x, z), SIZE.z() * (z / (heights.rows() - 1.0) - 0.5));
    }
}
