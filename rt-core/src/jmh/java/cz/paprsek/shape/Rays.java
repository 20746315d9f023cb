package cz.paprsek.shape;

import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import java.util.Random;

/** Random rays from a sphere of radius 4 towards points near the origin, the same every time; handed out in turn, so that none is learnt by heart. */
public final class Rays {
    private static final int NUMBER = 1 << 12;

    private final Ray ray;
    private final double[] numbers = new double[6 * NUMBER];
    private int next;

    public Rays(Spans spans) {
        ray = new Ray(spans);
        Random random = new Random(1);
        for (int i = 0; i < NUMBER; i++) {
            Vec3 from = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized().times(4);
            Vec3 to = new Vec3(random.nextDouble() * 2 - 1, random.nextDouble() * 2 - 1, random.nextDouble() * 2 - 1);
            Vec3 d = to.minus(from).normalized();
            double[] values = {from.x(), from.y(), from.z(), d.x(), d.y(), d.z()};
            System.arraycopy(values, 0, numbers, 6 * i, 6);
        }
    }

    /** The next ray, at its start. */
    public Ray next() {
        int i = 6 * next;
        next = (next + 1) % NUMBER;
        ray.start(numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3], numbers[i + 4], numbers[i + 5]);
        return ray;
    }
}
