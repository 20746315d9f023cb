package cz.paprsek.render.light;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.scene.AreaLight;

/** A rectangle that shines to one side, or to both. */
final class RectangleLamp extends AreaLamp {
    RectangleLamp(AreaLight light, AreaLight.Size size) {
        super(light, size.width() / 2, size.height() / 2);
    }

    /** A body, a parallelogram, that shines to both sides. */
    RectangleLamp(Rgb color, double strength, Vec3 middle, Vec3 across, Vec3 along) {
        super(color, strength, middle, across, along, 4, true);
    }

    @Override
    void place(double u, double v, Arrival out) {
        out.x = 2 * u - 1;
        out.y = 2 * v - 1;
    }
}
