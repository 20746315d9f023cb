package cz.paprsek.shape.placed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Rectangle;
import java.util.Random;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;

/** A figure that says to which axis it is perpendicular is met nowhere but at its place, and within its bounds. */
class FlatTest {
    private static final int ROUNDS = 20_000;
    /** Less, relative to its numbers, than a wall of a room may be out of its place. */
    private static final double LITTLE = 1e-10;

    /** Numbers every part 1. */
    private static final class One implements Parts {
        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            return maker.apply(1);
        }

        @Override
        public Parts within(MaterialSource material, Affine toWorld) {
            return this;
        }
    }

    private final Random random = new Random(4);

    private static Flat square(Affine toWorld) {
        return (Flat) new Rectangle(-1, -1, 1, 1).place(toWorld, new One());
    }

    @Test
    void leaningFiguresAreAcrossNoAxis() {
        int across = 0;
        for (int round = 0; round < ROUNDS; round++) {
            double lean = Math.toDegrees(Math.pow(10, -18 + 16 * random.nextDouble()));
            Vec3 quarters = new Vec3(90 * random.nextInt(4), 90 * random.nextInt(4), 0);
            Flat flat = square(Affine.translation(somewhere()).after(Affine.rotation(quarters)).after(Affine.rotation(new Vec3(lean, 0, 0))));
            if (flat.axis() >= 0) {
                across++;
                double little = LITTLE * flat.bounds().magnitude();
                assertThat(low(flat.bounds(), flat.axis())).as("leaning by %s degrees", lean).isCloseTo(flat.place(), within(little));
                assertThat(high(flat.bounds(), flat.axis())).as("leaning by %s degrees", lean).isCloseTo(flat.place(), within(little));
            }
        }
        assertThat(across).isBetween(ROUNDS / 10, ROUNDS / 2);
    }

    @Test
    void raysApartFromItsPlaneDoNotMeetIt() {
        int apart = 0;
        Ray ray = new Ray(new Spans());
        Ray same = new Ray(new Spans());
        for (int round = 0; round < ROUNDS; round++) {
            Vec3 quarters = new Vec3(90 * random.nextInt(4), 90 * random.nextInt(4), 0);
            Vec3 at = somewhere();
            Flat flat = square(Affine.translation(at).after(Affine.rotation(quarters)).after(Affine.scaling(new Vec3(1, 1, 3))));
            Vec3 beside = new Vec3(beside(), beside(), beside());
            Vec3 way = new Vec3(random.nextGaussian(), random.nextInt(4) == 0 ? beside() : random.nextGaussian(), random.nextGaussian()).normalized();
            Vec3 from = at.plus(beside);
            double size = Math.abs(from.x()) + Math.abs(from.y()) + Math.abs(from.z());
            double end = random.nextInt(9) == 0 ? Double.POSITIVE_INFINITY : 2 * random.nextDouble();
            ray.start(from.x(), from.y(), from.z(), way.x(), way.y(), way.z(), size, end, 0, false);
            same.within(ray, ray.min, end);
            flat.nearest(same);
            if (flat.isApart(ray)) {
                apart++;
                assertThat(same.part).as("a figure at %s by a ray from %s, %s", at, from, way).isEqualTo(-1);
            }
        }
        assertThat(apart).isBetween(ROUNDS / 10, ROUNDS * 9 / 10);
    }

    /** Often hardly beside. */
    private double beside() {
        return random.nextInt(3) == 0 ? (random.nextInt(3) - 1) * Math.pow(10, -4 - 13 * random.nextDouble()) : random.nextGaussian();
    }

    @Test
    void unevenFiguresEndWhereTheirBoundsDo() {
        int across = 0;
        Ray ray = new Ray(new Spans());
        for (int round = 0; round < ROUNDS; round++) {
            double stretch = Math.pow(10, 10 * random.nextDouble());
            Affine after = Affine.rotation(new Vec3(0, 0, 360 * random.nextDouble()));
            Affine before = Affine.rotation(new Vec3(0, 0, 360 * random.nextDouble()));
            Affine toWorld = after.after(Affine.scaling(new Vec3(stretch, 1, 1))).after(before);
            Flat flat = square(toWorld);
            if (flat.axis() == 2) {
                across++;
                Vec3 along = after.direction(Vec3.X);
                Vec3 end = corner(toWorld, along);
                for (int i = 0; i < 8; i++) {
                    Vec3 beyond = end.plus(along.times(flat.bounds().magnitude() * Math.pow(10, -10 + 9 * random.nextDouble())));
                    ray.start(beyond.x(), beyond.y(), 1, 0, 0, -1);
                    flat.nearest(ray);
                    assertThat(ray.part).as("stretched by %s, beyond its end", stretch).isEqualTo(-1);
                }
            }
        }
        assertThat(across).isBetween(ROUNDS / 10, ROUNDS / 2);
    }

    /** The corner that lies farthest in a direction. */
    private static Vec3 corner(Affine toWorld, Vec3 along) {
        Vec3 farthest = toWorld.point(new Vec3(-1, -1, 0));
        for (int i = 1; i < 4; i++) {
            Vec3 corner = toWorld.point(new Vec3(i % 2 * 2 - 1, i / 2 * 2 - 1, 0));
            farthest = corner.dot(along) > farthest.dot(along) ? corner : farthest;
        }
        return farthest;
    }

    private Vec3 somewhere() {
        return random.nextBoolean() ? Vec3.ZERO : new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
    }

    private static double low(Bounds box, int axis) {
        return axis == 0 ? box.minX() : axis == 1 ? box.minY() : box.minZ();
    }

    private static double high(Bounds box, int axis) {
        return axis == 0 ? box.maxX() : axis == 1 ? box.maxY() : box.maxZ();
    }
}
