package cz.paprsek.fx.view.render;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.CustomShape;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;

/** What no ray meets, but all within ten units of the origin wait for while it is shut: a picture with it is not finished before its time on any machine. */
final class Gate implements CustomShape {
    private static final long NANOS_BETWEEN = 1_000_000;

    private final BooleanSupplier shut;

    /** @param shut asked at each ray, on any thread */
    Gate(BooleanSupplier shut) {
        this.shut = shut;
    }

    @Override
    public void cross(Line line) {
        while (shut.getAsBoolean()) {
            LockSupport.parkNanos(NANOS_BETWEEN);
        }
    }

    @Override
    public void normal(int face, Hit hit) {
        throw new IllegalStateException("nothing meets it");
    }

    @Override
    public Bounds bounds() {
        return Bounds.of(new Vec3(-10, -10, -10), new Vec3(10, 10, 10));
    }
}
