package cz.paprsek.render.light;

import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.scene.PointLight;

/** A light of no size, without fall-off: the common one, which those who ask try first. */
public final class PointLamp extends LampAtPoint {
    PointLamp(PointLight light) {
        super(light);
    }

    @Override
    public boolean sample(Hit from, double u, double v, Arrival out) {
        out.towards(from, x, y, z);
        out.light(red(), green(), blue());
        return true;
    }
}
