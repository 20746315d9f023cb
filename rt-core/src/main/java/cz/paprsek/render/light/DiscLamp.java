package cz.paprsek.render.light;

import cz.paprsek.ray.Arrival;
import cz.paprsek.scene.AreaLight;

/** A disc that shines to one side. */
final class DiscLamp extends AreaLamp {
    DiscLamp(AreaLight light, AreaLight.Radius size) {
        super(light, size.radius(), size.radius());
    }

    @Override
    void place(double u, double v, Arrival out) {
        Unit.disc(u, v, out);
    }
}
