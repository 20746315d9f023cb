package cz.paprsek.shape;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import java.util.List;

/**
 * A ring about the y axis.
 *
 * @param majorRadius from the axis to the middle of the tube
 * @param minorRadius of the tube; at most the major radius
 */
public record Torus(double majorRadius, double minorRadius) implements Solid {
    public Torus {
        Require.size("torus major-radius", majorRadius);
        Require.size("torus minor-radius", minorRadius);
        Require.that(minorRadius <= majorRadius, "torus minor-radius must be at most its major-radius of " + majorRadius
                + ", but is " + minorRadius);
    }

    @Override
    public Bounds bounds() {
        double outer = majorRadius + minorRadius;
        return new Bounds(-outer, -minorRadius, -outer, outer, minorRadius, outer);
    }

    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        return Outlines.ring(majorRadius, minorRadius, along, steps);
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return parts.add(part -> new Placed(part, toWorld, this));
    }

    private static final class Placed extends Volume implements Part {
        private final int part;
        private final Affine toLocal;
        private final Bounds bounds;
        private final double major;
        private final double minor;

        Placed(int part, Affine toWorld, Torus shape) {
            this.part = part;
            toLocal = toWorld.inverse();
            major = shape.majorRadius;
            minor = shape.minorRadius;
            Bounds circle = Bounds.ofEllipsoid(toWorld, major, 0, major);
            Bounds tube = Bounds.ofEllipsoid(toWorld, minor, minor, minor);
            Vec3 half = new Vec3((tube.maxX() - tube.minX()) / 2, (tube.maxY() - tube.minY()) / 2, (tube.maxZ() - tube.minZ()) / 2);
            bounds = new Bounds(circle.minX() - half.x(), circle.minY() - half.y(), circle.minZ() - half.z(),
                    circle.maxX() + half.x(), circle.maxY() + half.y(), circle.maxZ() + half.z());
        }

        @Override
        public Bounds bounds() {
            return bounds;
        }

        @Override
        public double cost() {
            return 20;
        }

        /**
         * With p the point of the line nearest to the centre and s the way from there in units of the shape, the crossings are the
         * roots of s⁴ + c₂s² + c₁s + c₀ within the ball around the torus. They are bracketed by the turning points, themselves
         * bracketed in the same way, and so come out sorted and in pairs, however close together.
         */
        @Override
        public void spans(Ray ray, Spans out) {
            Line line = ray.local;
            line.set(ray, toLocal);
            double length = Math.sqrt(line.dx * line.dx + line.dy * line.dy + line.dz * line.dz);
            double dx = line.dx / length;
            double dy = line.dy / length;
            double dz = line.dz / length;
            double middle = -(line.ox * dx + line.oy * dy + line.oz * dz);
            double px = line.ox + middle * dx;
            double py = line.oy + middle * dy;
            double pz = line.oz + middle * dz;
            double pp = px * px + py * py + pz * pz;
            double reach = (major + minor) * (major + minor) - pp;
            if (!(reach > 0)) {
                return;
            }
            double k = pp + major * major - minor * minor;
            double rho = Math.sqrt(px * px + pz * pz);
            double c2 = 2 * k - 4 * major * major * (dx * dx + dz * dz);
            double c1 = -8 * major * major * (px * dx + pz * dz);
            // k² − 4R²ρ² as a product: the difference would lose the digits of a thin ring.
            double inner = (rho - major) * (rho - major) + py * py - minor * minor;
            double outer = (rho + major) * (rho + major) + py * py - minor * minor;
            double c0 = inner * outer;
            Quartic.roots(c2, c1, c0, Math.sqrt(reach) * (1 + 1e-9), middle, 1 / length, part, ray.breaks, out);
        }

        @Override
        public void describe(int face, Hit hit) {
            double x = toLocal.pointX(hit.px, hit.py, hit.pz);
            double y = toLocal.pointY(hit.px, hit.py, hit.pz);
            double z = toLocal.pointZ(hit.px, hit.py, hit.pz);
            double rho = Math.sqrt(x * x + z * z);
            double k = rho > 0 ? 1 - major / rho : 0;
            hit.normal(toLocal, x * k, y, z * k);
        }
    }
}
