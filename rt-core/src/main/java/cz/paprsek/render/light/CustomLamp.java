package cz.paprsek.render.light;

import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.scene.CustomLight;
import cz.paprsek.scene.PlacedLight;
import cz.paprsek.text.Numbers;

/** A light that was made in code. */
final class CustomLamp extends Lamp {
    /** How far the square of a direction's length may be from 1. */
    private static final double UNEVEN = 1e-6;

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
        // What stands where the point is lights nothing: the way there has no direction.
        boolean shines = light.sample(from, u, v, out) && out.distance != 0;
        if (shines && !isSound(out)) {
            throw new IllegalStateException("the light \"" + light.kind() + "\", which is made in code, sends " + out.red + " " + out.green + " " + out.blue
                    + " from the direction " + out.x + " " + out.y + " " + out.z + " and from " + out.distance + " away to " + Numbers.text(new Vec3(from.px, from.py, from.pz))
                    + "; light must be finite, a direction of length 1 and a distance above 0");
        }
        return shines;
    }

    /** Whether a picture can be made of it: false for what is not a number. */
    private static boolean isSound(Arrival out) {
        double square = out.x * out.x + out.y * out.y + out.z * out.z;
        return Math.abs(square - 1) < UNEVEN && out.distance > 0 && Math.abs(out.red) <= MOST && Math.abs(out.green) <= MOST && Math.abs(out.blue) <= MOST;
    }
}
