package cz.paprsek.render.glow;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.light.Lamp;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The lights of a scene that are seen: bodies, each of one part, numbered after those of the objects; and suns, behind everything. They are few, and
 * every ray looks at each, or else there is a tree of them. Where one lies in one place with an object, it is the light that is met; of several the
 * last in the file. Immutable.
 */
public class Glows {
    /** In place of the number of a light: there is none. */
    public static final int NONE = -1;

    /** So many are looked at one by one as fast as in a tree, or faster. */
    static final int FEW = 16;

    final int firstPart;
    final Glow[] bodies;
    private final Sun[] suns;
    private final Optional<GlowTree> tree;

    private record Sun(int lamp, Vec3 towards, double cosine, double red, double green, double blue) {}

    private Glows(int firstPart, Glow[] bodies, Sun[] suns) {
        this.firstPart = firstPart;
        this.bodies = bodies;
        this.suns = suns;
        this.tree = bodies.length > FEW ? Optional.of(GlowTree.of(bodies)) : Optional.empty();
    }

    Glows(Glows same) {
        this.firstPart = same.firstPart;
        this.bodies = same.bodies;
        this.suns = same.suns;
        this.tree = same.tree;
    }

    /** The same for a single worker, who may have scratch for it. */
    public Glows forOneWorker() {
        return tree.<Glows>map(one -> new ManyGlows(this, one)).orElse(this);
    }

    /** @param firstPart the number of parts that objects have */
    public static Glows of(List<Light> lights, int firstPart) {
        List<Glow> bodies = new ArrayList<>();
        List<Sun> suns = new ArrayList<>();
        for (int i = 0; i < lights.size(); i++) {
            Glow.of(i, lights.get(i), firstPart + bodies.size()).ifPresent(bodies::add);
            if (lights.get(i) instanceof SunLight sun && sun.visible() && sun.angle() > 0) {
                suns.add(sun(i, sun));
            }
        }
        return new Glows(firstPart, bodies.toArray(Glow[]::new), suns.toArray(Sun[]::new));
    }

    /** The radiance of its disc is I/sin²(angle/2). */
    private static Sun sun(int lamp, SunLight light) {
        double sine = Angles.sin(light.angle() / 2);
        double k = Math.min(1 / (sine * sine), Lamp.MOST) * light.intensity();
        return new Sun(lamp, light.direction().normalized().negated(), Angles.cos(light.angle() / 2),
                k * light.color().linearRed(), k * light.color().linearGreen(), k * light.color().linearBlue());
    }

    /** Whether there is no body that could be in a ray's way. */
    public boolean areNone() {
        return bodies.length == 0;
    }

    /** Makes the first light that the ray meets its hit, unless something else is met before. */
    public void nearest(Ray ray) {
        for (Glow glow : bodies) {
            glow.nearest(ray, firstPart);
        }
    }

    /** Whether a light, other than the one that is looked for, stands between the ray's start and its end. */
    public boolean occludes(Ray ray, int lamp) {
        for (Glow glow : bodies) {
            if (glow.lamp != lamp && glow.surface.occludes(ray)) {
                return true;
            }
        }
        return false;
    }

    /** The number of the nearest light, other than the one that is looked for, between the ray's start and its end, or {@link #NONE}; not for the hot path. */
    public int nearestOccluder(Ray ray, int lamp) {
        int nearest = NONE;
        double least = Double.POSITIVE_INFINITY;
        for (Glow glow : bodies) {
            if (glow.lamp != lamp && glow.surface.occludes(ray) && distance(ray, glow.lamp) < least) {
                nearest = glow.lamp;
                least = distance(ray, nearest);
            }
        }
        return nearest;
    }

    /** How far along a ray it first meets a light's body; not for the hot path. */
    public double distance(Ray ray, int lamp) {
        Ray own = new Ray(new Spans());
        own.within(ray, ray.contact, ray.max);
        for (Glow glow : bodies) {
            if (glow.lamp == lamp) {
                glow.surface.nearest(own);
            }
        }
        return own.max;
    }

    /** Whether rays can see a light. */
    public boolean show(int lamp) {
        for (Glow glow : bodies) {
            if (glow.lamp == lamp) {
                return true;
            }
        }
        for (Sun sun : suns) {
            if (sun.lamp == lamp) {
                return true;
            }
        }
        return false;
    }

    /** Whether the part that a ray has hit is that of a light. */
    public boolean has(int part) {
        return part >= firstPart && part < firstPart + bodies.length;
    }

    /** The number of the light that has this part. */
    public int lamp(int part) {
        return bodies[part - firstPart].lamp;
    }

    /** Says where the surface of the part was hit. */
    public void describe(int part, int face, Hit hit) {
        bodies[part - firstPart].describe(face, hit);
    }

    /** The light that is seen of the part. */
    public void shine(int part, boolean isBehind, Arrival out) {
        bodies[part - firstPart].shine(isBehind, out);
    }

    /** The number of the sun that is seen in a direction of length 1, and its radiance; {@link #NONE} if there is none. Of several the first is seen. */
    public int sky(double dx, double dy, double dz, Arrival out) {
        for (Sun sun : suns) {
            if (dx * sun.towards.x() + dy * sun.towards.y() + dz * sun.towards.z() >= sun.cosine) {
                out.light(sun.red, sun.green, sun.blue);
                return sun.lamp;
            }
        }
        return NONE;
    }
}
