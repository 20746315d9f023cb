package cz.paprsek.render.light;

import cz.paprsek.math.Require;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.scene.CustomLight;
import cz.paprsek.scene.PlacedLight;

/** A light that was made in code. */
final class CustomLamp extends Lamp {
    private final CustomLight light;
    private final int samples;

    CustomLamp(CustomLight light) {
        super(light.color(), light.intensity());
        this.light = light;
        samples = light.samples();
        Require.within("samples of a " + light.kind(), samples, 1, PlacedLight.MOST_SAMPLES);
    }

    @Override
    public int samples() {
        return samples;
    }

    @Override
    public boolean sample(Hit from, double u, double v, Arrival out) {
        return light.sample(from, u, v, out);
    }
}
