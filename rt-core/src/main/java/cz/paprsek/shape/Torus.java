package cz.paprsek.shape;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.outline.Drawn;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Quartic;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import java.util.List;

/**
 * A ring about the y axis: all that is not farther than the minor radius from a circle.
 *
 * @param majorRadius from the axis to the middle of the tube
 * @param minorRadius of the tube; beyond the major radius there is no hole but a dent above and below, and what the tube covers twice is inside
 */
@Element("A ring about its y axis.")
public record Torus(
        @Attribute(value = Kind.POSITIVE, means = "From the axis to the middle of the tube", example = "0.4") double majorRadius,
        @Attribute(value = Kind.POSITIVE, means = "Of the tube; if larger than the major radius, there is no hole but two dents", example = "0.15") double minorRadius) implements Solid {
    public Torus {
        Require.size("torus major-radius", majorRadius);
        Require.size("torus minor-radius", minorRadius);
    }

    @Override
    public Bounds bounds() {
        double outer = majorRadius + minorRadius;
        return new Bounds(-outer, -minorRadius, -outer, outer, minorRadius, outer);
    }

    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        return Drawn.ring(majorRadius, minorRadius, along, steps);
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return parts.add(part -> new Placed(part, toWorld, this));
    }

    private static final class Placed extends Volume implements Part {
        /** How far rounding may move a crossing, relative to the numbers it is made of. */
        private static final double LAST_BITS = 2e-16;

        private final int part;
        private final Affine toLocal;
        private final Bounds bounds;
        private final double major;
        private final double minor;
        private final double size;

        Placed(int part, Affine toWorld, Torus shape) {
            this.part = part;
            toLocal = toWorld.inverse();
            major = shape.majorRadius;
            minor = shape.minorRadius;
            size = Math.max(major, minor);
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
         * With p the point of the line nearest to the centre and s the way from there in units of the shape, the distance from the tube
         * changes its sign at the roots of a quartic, at most once between two of its turning points. These are found first; the
         * crossings come out sorted and in pairs, however close together.
         */
        @Override
        public void spans(Ray ray, Spans out) {
            Line line = ray.in(toLocal);
            double length = Math.sqrt(line.dx * line.dx + line.dy * line.dy + line.dz * line.dz);
            line.dx /= length;
            line.dy /= length;
            line.dz /= length;
            double middle = -(line.ox * line.dx + line.oy * line.dy + line.oz * line.dz);
            line.ox += middle * line.dx;
            line.oy += middle * line.dy;
            line.oz += middle * line.dz;
            double pp = line.ox * line.ox + line.oy * line.oy + line.oz * line.oz;
            double reach = (major + minor) * (major + minor) - pp;
            if (!(reach > 0)) {
                return;
            }
            double c2 = 2 * (pp + major * major - minor * minor) - 4 * major * major * (line.dx * line.dx + line.dz * line.dz);
            double c1 = -8 * major * major * (line.ox * line.dx + line.oz * line.dz);
            int mark = out.size();
            cross(line, c2, c1, Math.sqrt(reach) * (1 + 1e-9), middle, 1 / length, ray.breaks, out);
            if (part == ray.left) {
                out.leaveFrom(mark, ray.inwards);
            }
        }

        /** At both ends the line counts as outside, whatever rounding says: the interval reaches out of the body. */
        private void cross(Line line, double c2, double c1, double reach, double middle, double unit, double[] breaks, Spans out) {
            int count = Quartic.turningPoints(c2, c1, reach, breaks);
            double low = -reach;
            boolean inside = false;
            for (int i = 0; i <= count; i++) {
                double high = i < count ? breaks[i] : reach;
                boolean insideNext = i < count && outside(line, high) < 0;
                if (inside != insideNext) {
                    out.add((middle + crossing(line, low, high, inside)) * unit, part, 0);
                }
                low = high;
                inside = insideNext;
            }
        }

        /** Below 0 in the tube, above outside: (ρ − R)² + y² − r². The quartic, times a factor that is never negative, without its large numbers. */
        private double outside(Line line, double s) {
            double x = line.ox + s * line.dx;
            double y = line.oy + s * line.dy;
            double z = line.oz + s * line.dz;
            double beyond = Math.sqrt(x * x + z * z) - major;
            return beyond * beyond + y * y - minor * minor;
        }

        private double slope(Line line, double s) {
            double x = line.ox + s * line.dx;
            double y = line.oy + s * line.dy;
            double z = line.oz + s * line.dz;
            double rho = Math.sqrt(x * x + z * z);
            return 2 * ((rho - major) / rho * (x * line.dx + z * line.dz) + y * line.dy);
        }

        /** The crossing between low and high by Newton's method kept inside a shrinking bracket, to the last bits. */
        private double crossing(Line line, double low, double high, boolean insideAtLow) {
            double a = low;
            double b = high;
            double s = (a + b) / 2;
            while (s > a && s < b) {
                double f = outside(line, s);
                if (f < 0 == insideAtLow) {
                    a = s;
                } else {
                    b = s;
                }
                double step = f / slope(line, s);
                if (Math.abs(step) <= LAST_BITS * (size + Math.abs(s))) {
                    return s - step;
                }
                s -= step;
                if (!(s > a && s < b)) {
                    s = (a + b) / 2;
                }
            }
            return s;
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

        @Override
        public void map(int face, Hit hit) {
            double x = toLocal.pointX(hit.px, hit.py, hit.pz);
            double y = toLocal.pointY(hit.px, hit.py, hit.pz);
            double z = toLocal.pointZ(hit.px, hit.py, hit.pz);
            hit.mapAround(x, z, 0.5 + StrictMath.atan2(y, Math.sqrt(x * x + z * z) - major) / (2 * Math.PI));
            hit.tangentFrom(toLocal);
        }
    }
}
