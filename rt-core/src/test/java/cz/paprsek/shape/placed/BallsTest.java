package cz.paprsek.shape.placed;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Ellipsoid;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A body that a ray meets is never passed over because of the ball around it, from however far the ray comes and wherever the body stands. */
class BallsTest {
    private static final List<Shape> SHAPES = List.of(new Sphere(0.7), new Ellipsoid(new Vec3(0.5, 0.9, 0.2)), new Cone(0.5, 0.2, 0.9), new Cylinder(0.3, 1.1),
            new Block(new Vec3(-0.6, 0, -0.1), new Vec3(0.6, 1.4, 0.1)),
            Csg.difference(new Block(new Vec3(-0.5, -0.6, -0.7), new Vec3(0.6, 0.6, 0.4)), new Cylinder(0.3, 1)));

    private final Ray ray = new Ray(new Spans());
    private int met;
    private int passed;

    @ParameterizedTest
    @ValueSource(doubles = {3, 1e3, 1e6, 1e8})
    void whatIsMetIsNotPassedOver(double away) {
        Random random = new Random(7);
        for (int round = 0; round < 40; round++) {
            double place = round % 2 == 0 ? 0 : away;
            Affine turned = Affine.translation(new Vec3(place, -place, 2 * place)).after(Affine.rotation(some(random).times(180)))
                    .after(Affine.scaling(new Vec3(1.2, 1.2, 1.2).plus(some(random))));
            Surface[] surfaces = SHAPES.stream().map(shape -> shape.place(turned, Parts.UNTOLD)).toArray(Surface[]::new);
            Balls balls = new Balls(surfaces);
            assertThat(balls.areMost).isTrue();
            for (int i = 0; i < 500; i++) {
                aim(random, turned.point(Vec3.ZERO), away);
                for (int body = 0; body < surfaces.length; body++) {
                    ask(balls, surfaces, body);
                }
            }
        }
        assertThat(met).as("the test needs both").isGreaterThan(1000);
        assertThat(passed).isGreaterThan(1000);
    }

    /** Blocks along the axes reach the corners of their bounds; where numbers are large, the middle reckoned of a small one is not quite its middle. */
    @ParameterizedTest
    @CsvSource({"1, 0, 3", "1, 0, 1e6", "1, 0, 1e8", "1, 1e3, 1e6", "1e-3, 1e8, 1", "1e-6, 1e8, 1"})
    void cornersOfBlocksAlongTheAxesAreNotPassedOver(double size, double place, double away) {
        Random random = new Random(3);
        Vec3 sides = new Vec3(1, 1.4, 1.2).times(size);
        for (int round = 0; round < 200; round++) {
            Vec3 min = some(random).times(place).minus(sides.times(0.5));
            Vec3 max = min.plus(sides);
            Vec3 middle = min.plus(sides.times(0.5));
            Surface[] blocks = {new Block(min, max).place(Affine.IDENTITY, Parts.UNTOLD)};
            Balls balls = new Balls(blocks);
            for (int i = 0; i < 8; i++) {
                Vec3 corner = new Vec3(i % 2 == 0 ? min.x() : max.x(), i / 2 % 2 == 0 ? min.y() : max.y(), i / 4 == 0 ? min.z() : max.z());
                Vec3 outwards = corner.minus(middle);
                Vec3 across = outwards.cross(some(random)).normalized();
                Vec3 from = corner.minus(outwards.times(1e-9)).minus(across.times(away));
                ray.start(from.x(), from.y(), from.z(), across.x(), across.y(), across.z());
                ask(balls, blocks, 0);
            }
        }
        assertThat(met).as("corners met").isGreaterThan(200);
    }

    private void ask(Balls balls, Surface[] surfaces, int body) {
        ray.max = Double.POSITIVE_INFINITY;
        ray.reach = Double.POSITIVE_INFINITY;
        ray.part = -1;
        surfaces[body].nearest(ray);
        boolean mayBeMet = balls.mayBeMet(body, ray);
        if (ray.part >= 0) {
            met++;
            assertThat(mayBeMet).as("%s at %s", surfaces[body].getClass(), ray.max).isTrue();
        }
        passed += mayBeMet ? 0 : 1;
    }

    /** From a random place at a distance past the body, or through it. */
    private void aim(Random random, Vec3 body, double away) {
        Vec3 from = body.plus(some(random).normalized().times(away));
        Vec3 direction = body.plus(some(random).times(1.5)).minus(from).normalized();
        ray.start(from.x(), from.y(), from.z(), direction.x(), direction.y(), direction.z());
    }

    private static Vec3 some(Random random) {
        return new Vec3(2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1);
    }

    @Test
    void whereMostAreFlatOnlyBallsThemselvesAreTold() {
        Surface flat = new Rectangle(0, 0, 1, 1).place(Affine.IDENTITY, Parts.UNTOLD);
        Surface block = new Block(Vec3.ZERO, new Vec3(1, 1, 1)).place(Affine.rotation(new Vec3(10, 0, 0)), Parts.UNTOLD);
        Surface ball = new Sphere(1).place(Affine.IDENTITY, Parts.UNTOLD);
        ray.start(9, 9, 9, 0, 0, 1);
        Balls balls = new Balls(new Surface[] {flat, flat, block, ball});
        assertThat(balls.areMost).isFalse();
        assertThat(balls.mayBeMet(2, ray)).isTrue();
        assertThat(balls.mayBeMet(3, ray)).isFalse();
        assertThat(new Balls(new Surface[] {flat, block, ball}).mayBeMet(1, ray)).isFalse();
    }
}
