package cz.paprsek.render.integrate;

import cz.paprsek.render.surface.Level;

/**
 * Every term of a colour, told where the tracer makes it. Whoever wants to know overrides these methods; those of the tracer that renders
 * pictures are empty, and the JVM makes nothing of them.
 *
 * <p>Calls nest as rays do: {@link #following} announces a ray that another one gives rise to, {@link #missed} or {@link #met} begins the
 * account of a ray, {@link #ended} ends that of one that has met something. What a level holds is only valid during the call.
 */
public abstract class Witness {
    /** The next ray is mirrored, or goes on beyond the surface; its light will be added times the weight. */
    public void following(boolean refracted, double weight) {}

    /** The level's ray hits nothing and brings the background's light. */
    public void missed(Level level) {}

    /**
     * The level's ray has hit something. The normal is turned towards the viewer, the level's light is its ambient term.
     *
     * @param leaving whether the normal was turned round: the ray comes from inside
     * @param cosine of the angle between the ray and the normal, 0–1
     * @param mirrorX the mirrored direction R, of length 1
     * @param size what the rounding errors of rays that start here are relative to
     */
    public void met(Level level, boolean leaving, double cosine, double mirrorX, double mirrorY, double mirrorZ, double size) {}

    /**
     * A light was looked for, in the direction (x, y, z) of length 1.
     *
     * @param facing N·L; if it is not above 0 the surface is turned away, and nobody looked what stands between
     * @param visibility the share of the light that arrives
     */
    public void sought(int lamp, double x, double y, double z, double distance, double facing, double visibility) {}

    /**
     * The light sought last adds to the level's light.
     *
     * @param diffuse kD·max(0, N·L)
     * @param highlight kS·max(0, R·L)ⁿ
     */
    public void illuminated(double diffuse, double highlight, double red, double green, double blue) {}

    /**
     * The ray comes to a transparent surface.
     *
     * @param from refractive index before it
     * @param to refractive index beyond it
     * @param radicand cosine, squared, of the angle beyond it; below 0 if all light is reflected
     */
    public void bent(double from, double to, double radicand) {}

    /** The level's light is complete. */
    public void ended(Level level) {}
}
