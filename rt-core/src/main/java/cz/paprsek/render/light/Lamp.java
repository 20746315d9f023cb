package cz.paprsek.render.light;

import cz.paprsek.scene.Light;

/** A light ready for shading: position in world space, linear colour times intensity. */
public record Lamp(double x, double y, double z, double red, double green, double blue) {
    public static Lamp of(Light light) {
        return new Lamp(
                light.position().x(), light.position().y(), light.position().z(),
                light.color().linearRed() * light.intensity(),
                light.color().linearGreen() * light.intensity(),
                light.color().linearBlue() * light.intensity());
    }
}
