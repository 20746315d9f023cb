package cz.paprsek.render.integrate;

import cz.paprsek.ray.Arrival;
import cz.paprsek.render.surface.Level;

/**
 * Hears every term of a colour where a tracer makes it, and makes nothing of it. Whoever wants to know overrides these methods; that of a tracer that only renders
 * pictures is of this class itself, and the JVM makes nothing of its calls.
 *
 * <p>Calls nest as rays do: {@link #following} announces a ray that another one gives rise to, {@link #missed}, {@link #seen} or {@link #met} begins the
 * account of a ray, {@link #ended} ends that of one that has met an object. What a level holds is only valid during the call.
 */
public class Witness {
    /** Whether every light that was looked for is to be told, even if it is behind the surface and nobody need look. */
    public boolean hearsAll() {
        return false;
    }

    /** The next ray is mirrored, or goes on beyond the surface; its light will be added times the weight of each channel. */
    public void following(boolean refracted, double red, double green, double blue) {}

    /** The level's ray hits nothing and brings the background's light. */
    public void missed(Level level) {}

    /**
     * The level's ray has hit something. The normals are turned towards the viewer, the level's light is its ambient term.
     */
    public void met(Level level) {}

    /**
     * The level's ray sees a light as it is: its body, or the disc of a sun, and brings its light. It ends there.
     *
     * @param lamp number of the light
     */
    public void seen(Level level, int lamp) {}

    /**
     * A light was looked for.
     *
     * @param arrival where, and what it sends from there, which may be nothing
     * @param facing N·L; if it is not above 0 the surface is turned away, and nobody looked what stands between
     * @param visibility the share of that which arrives
     */
    public void sought(int lamp, Arrival arrival, double facing, double visibility) {}

    /** The substances on the way leave this share of what arrives of the light that is told next by {@link #sought}. */
    public void dimmed(double red, double green, double blue) {}

    /**
     * A rough surface strews the light sought last.
     *
     * @param spread D
     * @param seen G₁ from the viewer
     * @param lit G₁ from the light
     * @param red π·f·cos θ
     */
    public void strewn(double spread, double seen, double lit, double red, double green, double blue) {}

    /**
     * What the light sought last adds to the level's light, or to the mean of those sought.
     *
     * @param diffuse kD·max(0, N·L)
     * @param highlight kS·max(0, R·L)ⁿ
     */
    public void illuminated(double diffuse, double highlight, double red, double green, double blue) {}

    /** The light sought last was looked for at several points, and adds to the level's light the mean of what was found. */
    public void averaged(int lamp, double red, double green, double blue) {}

    /**
     * The ray comes to a transparent surface.
     *
     * @param from refractive index before it
     * @param to refractive index beyond it
     * @param cosine of the angle between the ray and the normal, or that of a rough surface's facet
     * @param radicand cosine, squared, of the angle beyond it; below 0 if all light is reflected
     */
    public void bent(double from, double to, double cosine, double radicand) {}

    /**
     * How much a surface mirrors depends on the angle.
     *
     * @param from refractive index before it
     * @param to refractive index beyond it
     * @param cosine of the angle between the ray and the normal, 0–1
     * @param beyond cosine of the angle beyond it; 0 if there is none
     * @param red the share that is mirrored at this angle, of what the material mirrors
     */
    public void split(double from, double to, double cosine, double beyond, double red, double green, double blue) {}

    /**
     * A rough surface sends the ray by one of its facets.
     *
     * @param x the facet's normal m, of length 1
     * @param chance with which it was decided whether the ray is mirrored or goes on
     * @param seen G₁, the share of facets seen from where it goes
     */
    public void facet(double x, double y, double z, double chance, double seen) {}

    /** The surface gives off light of its own, which has been added to the level's. */
    public void emitted(double red, double green, double blue) {}

    /**
     * What the level's ray brings is about to be told: the substance it comes through has left a share of it.
     *
     * @param object number of the object it is inside of
     * @param length of its way
     */
    public void absorbed(int object, double length, double red, double green, double blue) {}

    /** The level's light is complete. */
    public void ended(Level level) {}
}
