package cz.paprsek.render.light;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.scene.SunLight;

/**
 * A disc in the sky that looks α from its middle to its rim. Directions are chosen evenly within it; each brings 2·I/(1 + cos α), which is its
 * radiance I/sin² α times its solid angle 2π(1 − cos α) by π.
 */
final class SunDiscLamp extends Lamp {
    private final Vec3 towards;
    /** 1 − cos α. */
    private final double depth;
    private final double factor;

    SunDiscLamp(SunLight light) {
        super(light.color(), light.intensity());
        towards = light.direction().normalized().negated();
        double sine = Angles.sin(light.angle() / 2);
        double cosine = Angles.cos(light.angle() / 2);
        depth = sine * sine / (1 + cosine);
        factor = 2 / (1 + cosine);
    }

    @Override
    public int samples() {
        return SunLight.SAMPLES;
    }

    Vec3 direction(double u, double v, Arrival scratch) {
        Unit.cap(towards.x(), towards.y(), towards.z(), depth, u, v, scratch);
        return new Vec3(scratch.x, scratch.y, scratch.z);
    }

    @Override
    public double density(double x, double y, double z, double dx, double dy, double dz, double distance) {
        return 1 / (2 * Math.PI * depth);
    }

    @Override
    public boolean sample(Hit from, double u, double v, Arrival out) {
        Unit.cap(towards.x(), towards.y(), towards.z(), depth, u, v, out);
        out.distance = Double.POSITIVE_INFINITY;
        return arrives(factor, out);
    }
}
