package cz.paprsek.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import java.util.Random;
import org.junit.jupiter.api.Test;

class BlockTest {
    private static final Block BLOCK = new Block(new Vec3(-1, -2, -3), new Vec3(1, 2, 3));

    /** Turned about the y axis, it is entered and left where and through which face the block as it stands is by the ray turned back; also along its faces. */
    @Test
    void aTurnedBlockIsMetAsOneThatIsNot() {
        Affine turn = Affine.rotation(new Vec3(0, 30, 0));
        Surface turned = BLOCK.place(turn, Parts.UNTOLD);
        Surface plain = BLOCK.place(Affine.IDENTITY, Parts.UNTOLD);
        Random random = new Random(8);
        int met = 0;
        for (int i = 0; i < 4000; i++) {
            int kind = i % 4;
            double y = kind == 2 ? 1.5 * (random.nextInt(5) - 2) : 4 * random.nextGaussian();
            Vec3 from = new Vec3(2 * random.nextGaussian(), y, 4 * random.nextGaussian());
            double dx = kind == 1 ? 0 : random.nextGaussian();
            double dy = kind == 2 ? 0 : kind == 1 ? 1 - 2 * random.nextInt(2) : random.nextGaussian();
            double dz = kind == 1 ? 0 : random.nextGaussian();
            Vec3 along = new Vec3(dx, dy, dz).normalized();
            Spans expected = crossings(plain, from, along);
            Spans found = crossings(turned, turn.point(from), turn.direction(along));
            assertThat(found.size()).as("ray %d from %s along %s", i, from, along).isEqualTo(expected.size());
            for (int k = 0; k < found.size(); k++) {
                assertThat(found.t(k)).isCloseTo(expected.t(k), within(1e-9));
                assertThat(found.face(k)).as("ray %d", i).isEqualTo(expected.face(k));
                met++;
            }
        }
        assertThat(met).isGreaterThan(1000);
    }

    private static Spans crossings(Surface surface, Vec3 from, Vec3 along) {
        Spans spans = new Spans();
        Ray ray = new Ray(spans);
        ray.start(from.x(), from.y(), from.z(), along.x(), along.y(), along.z());
        surface.crossings(ray, spans);
        return spans;
    }
}
