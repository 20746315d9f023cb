package cz.paprsek.scene;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import java.util.Objects;

/** What must hold for lights of several kinds, and how they are switched off. */
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

    /** A light that shines no more, in the place of another and as large. */
    static Light unlit(Light light) {
        return light instanceof CustomLight custom ? new Unlit(custom) : light.withIntensity(0);
    }

    /** A light made in code, switched off: what it brings cannot be changed otherwise. */
    private record Unlit(CustomLight light) implements CustomLight {
        @Override
        public String kind() {
            return light.kind();
        }

        @Override
        public String name() {
            return light.name();
        }

        @Override
        public double intensity() {
            return 0;
        }

        @Override
        public boolean sample(Hit from, double u, double v, Arrival out) {
            light.sample(from, u, v, out);
            return false;
        }
    }
}
