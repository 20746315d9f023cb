package cz.paprsek.render.light;

import cz.paprsek.ray.Arrival;
import cz.paprsek.scene.AreaLight;

/** A rectangle that shines to one side. */
final class RectangleLamp extends AreaLamp {
    RectangleLamp(AreaLight light, AreaLight.Size size) {
        super(light, size.width() / 2, size.height() / 2);
    }

    @Override
    void place(double u, double v, Arrival out) {
        out.x = 2 * u - 1;
        out.y = 2 * v - 1;
    }
}
