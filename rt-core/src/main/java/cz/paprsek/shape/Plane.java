package cz.paprsek.shape;

import cz.paprsek.attribute.Element;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.placed.LocalConvex;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Volume;
import java.util.List;
import java.util.Objects;

/** The solid half-space y ≤ 0: ground without end, or a knife for CSG. */
@Element("The solid half-space y at most 0.")
public record Plane() implements Solid {
    /** How far its outline is drawn, own units. */
    private static final double FAR = 1e5;

    @Override
    public Bounds bounds() {
        double inf = Double.POSITIVE_INFINITY;
        return new Bounds(-inf, -inf, -inf, inf, 0, inf);
    }

    @Override
    public List<Curve> outline(Vec3 along, int steps) {
        Objects.requireNonNull(along, "along");
        return List.of(Curve.through(new Vec3(-FAR, 0, -FAR), new Vec3(FAR, 0, -FAR), new Vec3(FAR, 0, FAR), new Vec3(-FAR, 0, FAR),
                new Vec3(-FAR, 0, -FAR)));
    }

    @Override
    public Volume place(Affine toWorld, Parts parts) {
        return parts.add(part -> new Placed(part, toWorld));
    }

    private static final class Placed extends LocalConvex {
        Placed(int part, Affine toWorld) {
            super(part, toWorld, Bounds.ALL);
        }

        @Override
        protected boolean clip(Line line, Ray ray) {
            open(ray);
            return narrow(ray, line.oy, line.dy, Double.NEGATIVE_INFINITY, 0, -1);
        }

        @Override
        protected void describe(int face, double x, double y, double z, Affine toLocal, Hit hit) {
            hit.normal(toLocal, 0, 1, 0);
        }

        @Override
        protected void map(int face, double x, double y, double z, Hit hit) {
            hit.map(x, -z, 1, 0, 0);
        }
    }
}
