package cz.paprsek.render.light;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.scene.AreaLight;

/**
 * A flat light that shines to one side, or a body's surface that shines to both. Points are chosen evenly on it; each brings I·D²·cos θ/d², with θ the angle between the way to the
 * point and the light's normal.
 */
abstract class AreaLamp extends Lamp {
    private final int samples;
    private final double square;
    private final Vec3 middle;
    private final Vec3 across;
    private final Vec3 along;
    private final Vec3 normal;
    private final double area;
    private final boolean shinesToBothSides;

    /**
     * A light as it stands.
     *
     * @param halfWidth how far from its middle it reaches along its own x
     * @param halfHeight likewise along y
     */
    AreaLamp(AreaLight light, double halfWidth, double halfHeight) {
        super(light.color(), light.intensity());
        samples = light.samples();
        square = light.referenceDistance() * light.referenceDistance();
        Affine toWorld = light.placement().toParent();
        middle = light.position();
        across = toWorld.direction(Vec3.X).times(halfWidth);
        along = toWorld.direction(Vec3.Y).times(halfHeight);
        normal = toWorld.direction(Vec3.Z);
        area = light.form().area();
        shinesToBothSides = false;
    }

    /**
     * A flat body that shines with the radiance L: each of its points brings L·A·cos θ/(π·d²).
     *
     * @param across from its middle as far as it reaches one way, world space
     * @param along likewise the other way, not along the first
     * @param share how large it is by a parallelogram that the two span
     * @param toBothSides whether it shines to both sides, or only to that from which the way from the first to the second runs counter-clockwise
     */
    AreaLamp(Rgb color, double strength, Vec3 middle, Vec3 across, Vec3 along, double share, boolean toBothSides) {
        super(color, strength);
        samples = BODY_SAMPLES;
        this.middle = middle;
        this.across = across;
        this.along = along;
        Vec3 upright = across.cross(along);
        normal = upright.normalized();
        area = share * upright.length();
        square = area / Math.PI;
        shinesToBothSides = toBothSides;
    }

    @Override
    public final int samples() {
        return samples;
    }

    final double area() {
        return area;
    }

    /** Puts a point of it into the arrival's x and y: ±1 where it ends. */
    abstract void place(double u, double v, Arrival out);

    /** A point of it, world space. */
    final Vec3 point(double u, double v, Arrival scratch) {
        place(u, v, scratch);
        return middle.plus(across.times(scratch.x)).plus(along.times(scratch.y));
    }

    @Override
    public final double density(double x, double y, double z, double dx, double dy, double dz, double distance) {
        double cosine = facing(dx, dy, dz);
        return cosine > 0 ? distance * distance / (cosine * area) : 0;
    }

    /** The cosine of the angle between a direction that leads here and the side that is seen; not above 0 where that does not shine. */
    private double facing(double dx, double dy, double dz) {
        double cosine = -(dx * normal.x() + dy * normal.y() + dz * normal.z());
        return shinesToBothSides ? Math.abs(cosine) : cosine;
    }

    @Override
    public final boolean sample(Hit from, double u, double v, Arrival out) {
        place(u, v, out);
        double p = out.x;
        double q = out.y;
        out.towards(from, middle.x() + p * across.x() + q * along.x(), middle.y() + p * across.y() + q * along.y(),
                middle.z() + p * across.z() + q * along.z());
        double cosine = facing(out.x, out.y, out.z);
        return cosine > 0 && arrives(cosine * (square / (out.distance * out.distance)), out);
    }
}
