package cz.paprsek.render.light;

import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.scene.PointLight;

/** A light of no size that falls with the square of the distance: I·D²/d². */
final class FadingLamp extends LampAtPoint {
    private final double square;

    FadingLamp(PointLight light) {
        super(light);
        square = light.referenceDistance() * light.referenceDistance();
    }

    @Override
    public boolean sample(Hit from, double u, double v, Arrival out) {
        out.towards(from, x, y, z);
        return arrives(square / (out.distance * out.distance), out);
    }
}
