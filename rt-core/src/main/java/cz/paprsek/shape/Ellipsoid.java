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
import cz.paprsek.shape.placed.LocalConvex;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Volume;
import java.util.List;

/** An ellipsoid about the origin with semi-axes along x, y and z. */
@Element("An ellipsoid about its origin.")
public record Ellipsoid(@Attribute(value = Kind.POSITIVE_VECTOR, means = "Along x, y and z", example = "0.6 0.4 0.4") Vec3 semiAxes) implements Solid {
    public Ellipsoid {
        Require.size("ellipsoid semi-axis x", semiAxes.x());
        Require.size("ellipsoid semi-axis y", semiAxes.y());
        Require.size("ellipsoid semi-axis z", semiAxes.z());
    }

    @Override
    public Bounds bounds() {
        return Bounds.around(Vec3.ZERO, semiAxes);
    }

    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        return List.of(Drawn.ellipsoid(semiAxes, along, steps));
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return Sphere.place(toWorld, semiAxes.x(), semiAxes.y(), semiAxes.z(), parts);
    }

    /** Any ellipsoid as the unit ball of its own space. The direction has any length there: t₀ ± √((1 − |o + t₀·d|²)/|d|²). */
    static final class Placed extends LocalConvex {
        Placed(int part, Affine fromUnit) {
            super(part, fromUnit, Bounds.ofEllipsoid(fromUnit, 1, 1, 1));
        }

        @Override
        protected boolean clip(Line line, Ray ray) {
            double dd = line.dx * line.dx + line.dy * line.dy + line.dz * line.dz;
            double middle = -(line.ox * line.dx + line.oy * line.dy + line.oz * line.dz) / dd;
            double px = line.ox + middle * line.dx;
            double py = line.oy + middle * line.dy;
            double pz = line.oz + middle * line.dz;
            double half = 1 - (px * px + py * py + pz * pz);
            if (!(half > 0)) {
                return false;
            }
            double s = Math.sqrt(half / dd);
            ray.enter = middle - s;
            ray.leave = middle + s;
            ray.enterFace = 0;
            ray.leaveFace = 0;
            return true;
        }

        @Override
        protected void describe(int face, double x, double y, double z, Affine toLocal, Hit hit) {
            hit.normal(toLocal, x, y, z);
        }

        @Override
        protected void map(int face, double x, double y, double z, Hit hit) {
            hit.mapGlobe(x, y, z);
        }
    }
}
