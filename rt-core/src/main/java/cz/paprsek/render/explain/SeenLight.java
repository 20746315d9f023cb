package cz.paprsek.render.explain;

import java.util.Objects;

/**
 * A light that a ray has met: its body, or the disc of a sun. The ray ends there, and brings the light's own radiance.
 *
 * @param light its number in the scene, from 0
 * @param name its name; empty for none
 * @param distance from the ray's origin; infinite for a sun
 */
public record SeenLight(int light, String name, double distance) {
    public SeenLight {
        Objects.requireNonNull(name, "name");
    }

    /** Its name in quotes; its number, from 1, if it has none. */
    public String label() {
        return name.isEmpty() ? "#" + (light + 1) : "\"" + name + "\"";
    }
}
