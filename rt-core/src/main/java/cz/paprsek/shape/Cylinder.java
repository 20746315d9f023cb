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

/** A closed cylinder about the y axis, from y = 0 to y = height. */
@Element("A closed cylinder about its y axis, from y = 0.")
public record Cylinder(
        @Attribute(value = Kind.POSITIVE, means = "Above 0", example = "0.4") double radius,
        @Attribute(value = Kind.POSITIVE, means = "Above 0", example = "1") double height) implements Solid {
    public Cylinder {
        Require.size("cylinder radius", radius);
        Require.size("cylinder height", height);
    }

    @Override
    public Face face(int number) {
        return number == Placed.SIDE ? Face.SIDE : number == Placed.BOTTOM ? Face.BOTTOM : Face.TOP;
    }

    @Override
    public Bounds bounds() {
        return new Bounds(-radius, 0, -radius, radius, height, radius);
    }

    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        return Drawn.round(radius, radius, height, along, steps);
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return parts.add(part -> new Placed(part, toWorld, this));
    }

    /** Met in its own space: the stretch between the caps and within the endless cylinder. */
    private static final class Placed extends LocalConvex {
        private static final int SIDE = 0;
        private static final int BOTTOM = 1;

        private final double radius;
        private final double height;

        Placed(int part, Affine toWorld, Cylinder shape) {
            super(part, toWorld, Cone.roundBounds(toWorld, shape.radius, shape.radius, shape.height));
            radius = shape.radius;
            height = shape.height;
        }

        @Override
        protected boolean clip(Line line, Ray ray) {
            open(ray);
            if (!narrow(ray, line.oy, line.dy, 0, height, BOTTOM)) {
                return false;
            }
            double dd = line.dx * line.dx + line.dz * line.dz;
            if (dd == 0) {
                return line.ox * line.ox + line.oz * line.oz < radius * radius;
            }
            double middle = -(line.ox * line.dx + line.oz * line.dz) / dd;
            double px = line.ox + middle * line.dx;
            double pz = line.oz + middle * line.dz;
            double half = radius * radius - (px * px + pz * pz);
            if (!(half > 0)) {
                return false;
            }
            double s = Math.sqrt(half / dd);
            return narrow(ray, middle - s, SIDE, middle + s, SIDE);
        }

        @Override
        protected void describe(int face, double x, double y, double z, Affine toLocal, Hit hit) {
            if (face == SIDE) {
                hit.normal(toLocal, x, 0, z);
            } else {
                hit.normal(toLocal, 0, face == BOTTOM ? -1 : 1, 0);
            }
        }

        @Override
        protected void map(int face, double x, double y, double z, Hit hit) {
            if (face == SIDE) {
                hit.mapAround(x, z, y / height);
            } else {
                hit.mapLid(x, z, radius, face != BOTTOM);
            }
        }
    }
}
