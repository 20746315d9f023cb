package cz.paprsek.scene;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import java.util.Objects;

/** What must hold for lights of several kinds. */
final class LightRules {
    private LightRules() {}

    static void check(String name, Rgb color, double intensity) {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(color, "color");
        Require.notNegative("light intensity", intensity);
        Require.within("light intensity", intensity, 0, Light.BRIGHTEST);
    }

    static void check(String name, Vec3 position, Rgb color, double intensity) {
        check(name, color, intensity);
        Require.place("light position", position);
    }

    static void checkSized(int samples, double referenceDistance) {
        Require.within("light samples", samples, 1, PlacedLight.MOST_SAMPLES);
        Require.size("light reference-distance", referenceDistance);
    }
}
