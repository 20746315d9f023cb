package cz.paprsek.render;

/**
 * Is told every term of a colour where the tracer makes it. There is none while pictures are rendered.
 *
 * <p>Calls nest as rays do: {@link #follow} announces a ray that another one gave rise to, {@link #miss} or {@link #meet} begins the account of
 * a ray, {@link #end} ends it. What a level holds is only valid during the call.
 */
interface Witness {
    /** The next ray is mirrored, or goes on beyond the surface; its light will be added times the weight. */
    void follow(boolean refracted, double weight);

    /** The level's ray hits nothing and brings the background's light. */
    void miss(Level level);

    /**
     * The level's ray has hit something. The normal is turned towards the viewer, the level's light is its ambient term.
     *
     * @param leaving whether the normal was turned round: the ray comes from inside
     * @param cosine of the angle between the ray and the normal, 0–1
     */
    void meet(Level level, boolean leaving, double cosine);

    /**
     * A light was looked for, in the direction (x, y, z) of length 1.
     *
     * @param facing N·L; if it is not above 0 the surface is turned away, and nobody looked what stands between
     * @param visibility the share of the light that arrives
     */
    void seek(int lamp, double x, double y, double z, double distance, double facing, double visibility);

    /**
     * The light sought last adds to the level's light.
     *
     * @param diffuse kD·max(0, N·L)
     * @param highlight kS·max(0, R·L)ⁿ
     */
    void illuminate(double diffuse, double highlight, double red, double green, double blue);

    /**
     * The ray comes to a transparent surface.
     *
     * @param from refractive index before it
     * @param to refractive index beyond it
     * @param radicand 1 − sin² of the angle beyond it; below 0 if all light is reflected
     */
    void refract(double from, double to, double radicand);

    /** The level's light is complete. */
    void end(Level level);
}
