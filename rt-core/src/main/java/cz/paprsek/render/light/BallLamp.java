package cz.paprsek.render.light;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.scene.SphereLight;

/**
 * A ball that shines to all sides. Directions are chosen evenly within the cone that it fills, of which α is the angle from the middle; each brings
 * its radiance I·D²/r² times the solid angle 2π(1 − cos α) by π.
 */
final class BallLamp extends Lamp {
    private final int samples;
    private final double x;
    private final double y;
    private final double z;
    private final double radius;
    /** The radiance by that of a light of intensity 1. */
    private final double bright;
    /** Up to which square of the sine of its half angle it is looked for: on the body itself, where rounding says whether that is 1, paths find it by chance. */
    private final double widest;
    private final boolean isBody;

    BallLamp(SphereLight light) {
        super(light.color(), light.intensity());
        samples = light.samples();
        x = light.position().x();
        y = light.position().y();
        z = light.position().z();
        radius = light.radius();
        double by = light.referenceDistance() / radius;
        bright = by * by;
        widest = 1;
        isBody = false;
    }

    /** A body that shines with a radiance. */
    BallLamp(Rgb color, double strength, Vec3 middle, double radius) {
        super(color, strength);
        samples = BODY_SAMPLES;
        x = middle.x();
        y = middle.y();
        z = middle.z();
        this.radius = radius;
        bright = 1;
        widest = 1 - 1e-6;
        isBody = true;
    }

    @Override
    public int samples() {
        return samples;
    }

    @Override
    public double density(double ox, double oy, double oz, double dx, double dy, double dz, double distance) {
        double cx = x - ox;
        double cy = y - oy;
        double cz = z - oz;
        double square = radius * radius / (cx * cx + cy * cy + cz * cz);
        return square < widest ? (1 + Math.sqrt(1 - square)) / (2 * Math.PI * square) : 0;
    }

    @Override
    public boolean sample(Hit from, double u, double v, Arrival out) {
        out.towards(from, x, y, z);
        double distance = out.distance;
        double sine = radius / distance;
        double square = sine * sine;
        if (!(sine < 1 && square < widest)) {
            // Within it, where it gives no light, or on it.
            return arrives(0, out);
        }
        double depth = square / (1 + Math.sqrt(1 - square));
        double wx = out.x;
        double wy = out.y;
        double wz = out.z;
        double down = Unit.cap(wx, wy, wz, depth, u, v, out);
        double cosine = isBody ? 1 - down : wx * out.x + wy * out.y + wz * out.z;
        // A body must not hide its own points: the way to them must be known well, also where it is seen as a dot.
        double half = square - (isBody ? down * (2 - down) : (1 - cosine) * (1 + cosine));
        out.distance = distance * (cosine - Math.sqrt(half > 0 ? half : 0));
        return arrives(2 * bright * depth, out);
    }
}
