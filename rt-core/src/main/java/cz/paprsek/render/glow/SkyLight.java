package cz.paprsek.render.glow;

import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;

/** Light that comes from everywhere behind a scene, in some directions more than in others. */
public interface SkyLight {
    /** Sets the hit's colour to the light from a direction of length 1, and u and v to its place in the picture. */
    void look(double dx, double dy, double dz, Hit out);

    /** How probable it is that a direction of length 1 is chosen, per solid angle. */
    double density(double dx, double dy, double dz);

    /**
     * Chooses a direction as often as light comes from there, and turns the arrival there.
     *
     * @param u random, 0–1
     * @param v likewise
     * @param there gets the light
     * @return how probable it is, per solid angle
     */
    double choose(double u, double v, Arrival out, Hit there);
}
