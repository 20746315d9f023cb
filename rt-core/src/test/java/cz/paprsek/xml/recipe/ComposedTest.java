package cz.paprsek.xml.recipe;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Placement;
import java.util.Random;
import org.junit.jupiter.api.Test;

class ComposedTest {
    private static final Vec3[] AXES = {new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1)};

    /** Also where the angle about y is nearly a right one, and those about x and z can hardly be told apart. */
    @Test
    void aTurnWithinATurnTurnsAsBothDo() {
        Random random = new Random(5);
        for (int i = 0; i < 20_000; i++) {
            Vec3 outer = new Vec3(angle(random), angle(random), angle(random));
            double nearly = (i % 2 * 2 - 1) * 90 + (i % 3 == 0 ? 0 : random.nextDouble() * Math.pow(10, -random.nextInt(16)));
            Vec3 inner = i % 5 == 0 ? new Vec3(angle(random), angle(random), angle(random)) : new Vec3(0, nearly - outer.y(), 0);
            Vec3 first = i % 5 == 0 ? outer : new Vec3(outer.x(), outer.y(), 0);
            Placement both = Composed.of(turned(first), turned(inner)).orElseThrow();
            Affine wanted = Affine.rotation(first).after(Affine.rotation(inner));
            for (Vec3 axis : AXES) {
                assertThat(Affine.rotation(both.rotation()).direction(axis).minus(wanted.direction(axis)).length()).as("%s within %s", inner, first).isLessThan(1e-11);
            }
        }
    }

    private static double angle(Random random) {
        return random.nextInt(4) == 0 ? 90 * (random.nextInt(9) - 4) : 720 * random.nextDouble() - 360;
    }

    private static Placement turned(Vec3 rotation) {
        return new Placement(Vec3.ZERO, rotation, Vec3.ONE);
    }
}
