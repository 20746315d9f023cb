package cz.paprsek.render.light;

import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.buffer.LightPlace;
import cz.paprsek.scene.SunLight;
import java.util.Optional;

/** Parallel light. */
final class SunLamp extends Lamp {
    private final Vec3 towards;

    SunLamp(SunLight light) {
        super(light.color(), light.intensity());
        towards = light.direction().normalized().negated();
    }

    @Override
    public int samples() {
        return 1;
    }

    @Override
    public boolean sample(Hit from, double u, double v, Arrival out) {
        out.x = towards.x();
        out.y = towards.y();
        out.z = towards.z();
        out.distance = Double.POSITIVE_INFINITY;
        return arrives(1, out);
    }

    @Override
    public Optional<LightPlace> place() {
        return Optional.of(new LightPlace(towards, true));
    }
}
