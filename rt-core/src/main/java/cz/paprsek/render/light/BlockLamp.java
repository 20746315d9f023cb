package cz.paprsek.render.light;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.shape.Block;
import java.util.List;

/**
 * A block that shines. Points are chosen evenly on those of its faces that are seen from where it is looked for, A in all: each brings L·A·cos θ/(π·d²). Within it,
 * nobody looks for it.
 */
final class BlockLamp extends Lamp {
    private static final int AXES = 3;

    private final Vec3 middle;
    /** From the middle to the middles of three faces. */
    private final Vec3[] half = new Vec3[AXES];
    /** Of those faces, of length 1, outwards. */
    private final Vec3[] normal = new Vec3[AXES];
    /** How far those faces are from the middle. */
    private final double[] away = new double[AXES];
    private final double[] area = new double[AXES];

    BlockLamp(Rgb color, double strength, Block block, Affine toWorld) {
        super(color, strength);
        middle = toWorld.point(block.min().plus(block.max()).times(0.5));
        Vec3 size = block.max().minus(block.min()).times(0.5);
        List<Vec3> axes = List.of(new Vec3(size.x(), 0, 0), new Vec3(0, size.y(), 0), new Vec3(0, 0, size.z()));
        for (int i = 0; i < AXES; i++) {
            half[i] = toWorld.direction(axes.get(i));
        }
        for (int i = 0; i < AXES; i++) {
            Vec3 across = half[(i + 1) % AXES].cross(half[(i + 2) % AXES]);
            area[i] = 4 * across.length();
            normal[i] = across.normalized();
            double outwards = half[i].dot(normal[i]);
            normal[i] = outwards < 0 ? normal[i].negated() : normal[i];
            away[i] = Math.abs(outwards);
        }
    }

    /** Of all its faces. */
    double area() {
        return 2 * (area[0] + area[1] + area[2]);
    }

    @Override
    public int samples() {
        return BODY_SAMPLES;
    }

    /** How far a point is from the middle along a normal. */
    private double along(int axis, double x, double y, double z) {
        return (x - middle.x()) * normal[axis].x() + (y - middle.y()) * normal[axis].y() + (z - middle.z()) * normal[axis].z();
    }

    private double seen(double x, double y, double z) {
        double sum = 0;
        for (int i = 0; i < AXES; i++) {
            sum += Math.abs(along(i, x, y, z)) > away[i] ? area[i] : 0;
        }
        return sum;
    }

    @Override
    public double density(double x, double y, double z, double dx, double dy, double dz, double distance) {
        double all = seen(x, y, z);
        double cosine = 0;
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < AXES; i++) {
            double from = along(i, x, y, z);
            double facing = dx * normal[i].x() + dy * normal[i].y() + dz * normal[i].z();
            // The face that is met: of those that are seen, the one in whose plane the place is.
            double off = Math.abs(Math.abs(from + distance * facing) - away[i]);
            if (Math.abs(from) > away[i] && from * facing < 0 && off < nearest) {
                nearest = off;
                cosine = Math.abs(facing);
            }
        }
        return cosine > 0 ? distance * distance / (cosine * all) : 0;
    }

    @Override
    public boolean sample(Hit from, double u, double v, Arrival out) {
        double all = seen(from.px, from.py, from.pz);
        double left = u * all;
        for (int i = 0; i < AXES; i++) {
            double side = along(i, from.px, from.py, from.pz);
            if (Math.abs(side) > away[i]) {
                if (left < area[i]) {
                    face(i, side < 0 ? -1 : 1, 2 * (left / area[i]) - 1, 2 * v - 1, from, out);
                    double cosine = Math.abs(out.x * normal[i].x() + out.y * normal[i].y() + out.z * normal[i].z());
                    return arrives(cosine * all / (Math.PI * out.distance * out.distance), out);
                }
                left -= area[i];
            }
        }
        out.towards(from, middle.x(), middle.y(), middle.z());
        return arrives(0, out);
    }

    private void face(int axis, int side, double p, double q, Hit from, Arrival out) {
        Vec3 a = half[axis];
        Vec3 b = half[(axis + 1) % AXES];
        Vec3 c = half[(axis + 2) % AXES];
        out.towards(from, middle.x() + side * a.x() + p * b.x() + q * c.x(), middle.y() + side * a.y() + p * b.y() + q * c.y(), middle.z() + side * a.z() + p * b.z() + q * c.z());
    }
}
