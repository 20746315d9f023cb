package cz.paprsek.scene;

import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;

/** A light made in code, switched off: what it brings cannot be changed otherwise. */
record Unlit(CustomLight light) implements CustomLight {

    /** A light that shines no more, in the place of another and as large. */
    static Light of(Light light) {
        return light instanceof CustomLight custom ? new Unlit(custom) : light.withIntensity(0);
    }

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
