package cz.paprsek.shape;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Csg.Operation;
import cz.paprsek.shape.placed.Balls;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.shape.placed.Volume;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The first boundary that a ray meets, asked for alone, is the first of all, down to the last bit. */
class CarvedTest {

    /** Answers by all boundaries. */
    private static final class ByAll extends Volume {
        private final Volume solid;

        ByAll(Volume solid) {
            this.solid = solid;
        }

        @Override
        public Bounds bounds() {
            return solid.bounds();
        }

        @Override
        public void spans(Ray ray, Spans out) {
            solid.spans(ray, out);
        }
    }

    private record Answer(double max, double reach, int part, int face, boolean occludes) {}

    @ParameterizedTest
    @CsvSource({"UNION, 2, 0", "UNION, 5, 0", "DIFFERENCE, 2, 0", "DIFFERENCE, 6, 0", "INTERSECTION, 2, 0", "INTERSECTION, 3, 0", "UNION, 3, 1", "DIFFERENCE, 2, 1",
            "DIFFERENCE, 3, 1", "INTERSECTION, 2, 1", "DIFFERENCE, 3, 2", "INTERSECTION, 3, 2", "UNION, 2, 2"})
    void theFirstBoundaryAloneIsTheFirstOfAll(Operation operation, int count, int depth) {
        Random random = new Random(operation.name().length() * 100L + 10L * count + depth);
        int hits = 0;
        int carved = 0;
        int passedBy = 0;
        for (int body = 0; body < 60; body++) {
            boolean onGrid = body % 3 == 0;
            Volume solid = place(random(operation, count, depth, onGrid, random));
            carved += solid.carved().isPresent() ? 1 : 0;
            Volume byAll = new ByAll(solid);
            Balls ball = new Balls(new Surface[] {solid});
            for (int i = 0; i < 60; i++) {
                Ray ray = ray(solid, onGrid, random);
                Answer answer = ask(solid, ray);
                assertThat(answer).as("%s %d, ray %d from %s %s %s", operation, body, i, ray.ox, ray.oy, ray.oz).isEqualTo(ask(byAll, ray));
                hits += answer.part() >= 0 ? 1 : 0;
                if (!ball.mayBeMet(0, ray)) {
                    assertThat(answer.occludes()).as("what passes by the ball around %s %d", operation, body).isFalse();
                    assertThat(answer.part()).isEqualTo(ray.part);
                    passedBy++;
                }
            }
        }
        assertThat(hits).as("rays that meet something").isGreaterThan(200);
        assertThat(passedBy > 0).as("balls around bodies that are part of another").isEqualTo(operation != Operation.UNION);
        assertThat(carved).as("bodies that answer by themselves").isPositive();
    }

    /** Where a turned block ends, there its ball does: rays that graze its corners, from near and from as far as its ball is made for. */
    @ParameterizedTest
    @ValueSource(doubles = {3, 1e3, 1e6, 1e9})
    void cornersOfTurnedBlocksAreNotLeftOutByTheBallsAroundThem(double radii) {
        Random random = new Random(5);
        Solid body = Csg.difference(new Block(new Vec3(-1, -1, -1), new Vec3(1, 1, 1)), new Sphere(0.1));
        int hits = 0;
        int passedBy = 0;
        for (int round = 0; round < 300; round++) {
            Affine turned = Affine.translation(point(false, random)).after(Affine.rotation(direction(false, random).times(180)))
                    .after(Affine.scaling(new Vec3(1 + 0.1 * random.nextDouble(), 1, 1)));
            Volume solid = body.place(turned, new Counting());
            Balls ball = new Balls(new Surface[] {solid});
            for (int i = 0; i < 8; i++) {
                Vec3 corner = new Vec3(i % 2 == 0 ? 1 : -1, i / 2 % 2 == 0 ? 1 : -1, i / 4 == 0 ? 1 : -1);
                Vec3 across = turned.direction(corner).cross(direction(false, random)).normalized();
                Ray ray = past(turned.point(corner.times(1 - 1e-9)), across, radii * turned.direction(corner).length());
                Answer answer = ask(solid, ray);
                assertThat(answer).as("corner %d of block %d", i, round).isEqualTo(ask(new ByAll(solid), ray));
                if (answer.part() >= 0) {
                    hits++;
                    assertThat(ball.mayBeMet(0, ray)).as("corner %d of block %d", i, round).isTrue();
                }
                passedBy += ball.mayBeMet(0, past(turned.point(corner.times(1.01)), across, 3)) ? 0 : 1;
            }
        }
        assertThat(hits).as("corners met").isGreaterThan(200);
        assertThat(passedBy).as("corners of bodies with a ball, passed by").isGreaterThan(200);
    }

    private static Ray past(Vec3 point, Vec3 direction, double away) {
        Ray ray = new Ray(new Spans());
        Vec3 from = point.minus(direction.times(away));
        ray.start(from.x(), from.y(), from.z(), direction.x(), direction.y(), direction.z());
        return ray;
    }

    /** A hole flush with a face leaves no skin, and of equal faces the first one's is seen. */
    @Test
    void facesInOnePlaceAreLeftToWhatCombinesAll() {
        Solid block = new Block(new Vec3(-1, -1, -1), new Vec3(1, 1, 1));
        Solid flush = new Block(new Vec3(-0.5, -0.5, -1), new Vec3(0.5, 0.5, 1));
        Volume pierced = place(Csg.difference(block, flush));
        Volume twice = place(Csg.union(block, block));
        Ray ray = new Ray(new Spans());
        ray.start(0, 0, 5, 0, 0, -1);
        pierced.nearest(ray);
        assertThat(ray.part).isEqualTo(-1);
        assertThat(pierced.occludes(ray)).isFalse();
        twice.nearest(ray);
        assertThat(ray.part).isZero();
        assertThat(ray.max).isEqualTo(4);
        ray.start(0, 0, 5, 0, 0, -1);
        assertThat(twice.occludes(ray)).isTrue();
    }

    @Test
    void onlyConvexBodiesAnswerByThemselves() {
        Solid ball = new Sphere(1);
        Solid ring = new Torus(1, 0.2);
        assertThat(place(Csg.difference(ball, ball)).carved()).isPresent();
        assertThat(place(Csg.difference(Csg.intersection(ball, ball), Csg.union(ball, ball))).carved()).isPresent();
        assertThat(place(Csg.difference(ball, ring)).carved()).isEmpty();
        assertThat(place(Csg.difference(ball, Csg.difference(ball, ball))).carved()).isEmpty();
        assertThat(place(Csg.difference(Csg.union(ball, ball), ball)).carved()).isEmpty();
    }

    private static Answer ask(Volume solid, Ray given) {
        Ray ray = new Ray(new Spans());
        ray.within(given, given.min, given.max);
        boolean occludes = solid.occludes(ray);
        ray.within(given, given.min, given.max);
        if (given.part >= 0) {
            ray.max = Double.POSITIVE_INFINITY;
            ray.accept(given.max, given.part, given.face);
        }
        solid.nearest(ray);
        assertThat(ray.spans.size()).isZero();
        return new Answer(ray.max, ray.reach, ray.part, ray.face, occludes);
    }

    /** From somewhere around, from a boundary or near one, mostly with an end, sometimes with something hit; along the axes or not. */
    private static Ray ray(Volume solid, boolean onGrid, Random random) {
        Ray ray = new Ray(new Spans());
        Vec3 direction = direction(onGrid, random);
        Vec3 origin = point(onGrid, random);
        ray.start(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
        Spans all = new Spans();
        solid.spans(ray, all);
        int kind = random.nextInt(8);
        if (kind < 4 && all.size() > 0) {
            int from = random.nextInt(all.size());
            double t = all.t(from);
            if (Math.abs(t) < 100) {
                boolean continues = random.nextBoolean();
                Vec3 on = origin.plus(direction.times(t));
                Vec3 next = continues ? direction : direction(onGrid, random);
                double end = random.nextBoolean() ? Double.POSITIVE_INFINITY : 3 * random.nextDouble();
                int left = kind == 0 ? -1 : all.part(from);
                ray.start(on.x(), on.y(), on.z(), next.x(), next.y(), next.z(), Math.abs(t) + 5, end, left, random.nextBoolean());
                if (kind == 2) {
                    ray.min = ray.contact;
                } else if (kind == 3 && end < 3) {
                    ray.max = end + (random.nextInt(3) - 1) * 1e-11;
                }
            }
        } else if (kind == 4 && all.size() > 0) {
            double t = all.t(random.nextInt(all.size()));
            if (t > 0 && t < 100) {
                ray.accept(t + (random.nextInt(5) - 2) * 4e-12 * ray.scale, random.nextInt(6), 9);
            }
        } else if (kind == 5) {
            ray.accept(4 * random.nextDouble(), random.nextInt(6), 9);
        }
        return ray;
    }

    private static Vec3 point(boolean onGrid, Random random) {
        return onGrid ? new Vec3(grid(random), grid(random), grid(random)) : new Vec3(6 * random.nextDouble() - 3, 6 * random.nextDouble() - 3, 6 * random.nextDouble() - 3);
    }

    private static double grid(Random random) {
        return (random.nextInt(9) - 4) / 2.0;
    }

    private static Vec3 direction(boolean onGrid, Random random) {
        if (onGrid && random.nextBoolean()) {
            double side = random.nextBoolean() ? 1 : -1;
            return List.of(Vec3.X, Vec3.Y, Vec3.Z).get(random.nextInt(3)).times(side);
        }
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
    }

    private static Solid random(Operation operation, int count, int depth, boolean onGrid, Random random) {
        List<Operand> operands = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Operation within = i == 0 && operation != Operation.UNION ? (random.nextBoolean() ? Operation.DIFFERENCE : Operation.INTERSECTION)
                    : operation == Operation.INTERSECTION ? Operation.INTERSECTION : Operation.UNION;
            Solid solid = depth > 0 && random.nextInt(3) > 0 ? random(within, 2, depth - 1, onGrid, random) : random(onGrid, i, random);
            Operand operand = Operand.of(solid);
            operands.add(onGrid ? operand.at(grid(random) / 2, grid(random) / 2, grid(random) / 2)
                    : operand.at(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5)
                            .rotated(random.nextInt(4) * 45, random.nextInt(360), random.nextInt(2) * 90));
        }
        return new Csg(operation, operands);
    }

    private static Solid random(boolean onGrid, int place, Random random) {
        double size = onGrid ? (1 + random.nextInt(4)) / 2.0 : (place == 0 ? 0.8 : 0.3) + random.nextDouble();
        return switch (random.nextInt(onGrid ? 6 : 7)) {
            case 0, 1 -> new Block(new Vec3(-size, -size, -size), new Vec3(size, size, size));
            case 2 -> new Sphere(size);
            case 3 -> new Cylinder(size, 2 * size);
            case 4 -> new Plane();
            case 5 -> new Cone(size, size / 2, size);
            default -> new Ellipsoid(new Vec3(size, 0.5 * size, 0.8 * size));
        };
    }

    private static Volume place(Solid solid) {
        return solid.place(Affine.translation(new Vec3(0.125, 0, 0)), new Counting());
    }

    /** Numbers parts from 0. */
    private static final class Counting implements Parts {
        private int next;

        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            return maker.apply(next++);
        }

        @Override
        public Parts within(MaterialSource material, Affine toWorld) {
            return this;
        }
    }
}
