package cz.paprsek.render.light;

import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.scene.Light;

/** A light of intensity 0: whoever looks for it is told where it is, and that nothing arrives. */
final class DarkLamp extends Lamp {
    private final Lamp lamp;

    DarkLamp(Light light, Lamp lamp) {
        super(light.color(), 0);
        this.lamp = lamp;
    }

    @Override
    public int samples() {
        return 1;
    }

    @Override
    public boolean sample(Hit from, double u, double v, Arrival out) {
        lamp.sample(from, u, v, out);
        return false;
    }
}
