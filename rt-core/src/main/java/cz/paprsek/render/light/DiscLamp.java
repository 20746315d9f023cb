package cz.paprsek.render.light;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.scene.AreaLight;

/** A disc that shines to one side, or to both. */
final class DiscLamp extends AreaLamp {
    DiscLamp(AreaLight light, AreaLight.Radius size) {
        super(light, size.radius(), size.radius());
    }

    /** A body, an ellipse, that shines to both sides. */
    DiscLamp(Rgb color, double strength, Vec3 middle, Vec3 across, Vec3 along) {
        super(color, strength, middle, across, along, Math.PI, true);
    }

    @Override
    void place(double u, double v, Arrival out) {
        Unit.disc(u, v, out);
    }
}
