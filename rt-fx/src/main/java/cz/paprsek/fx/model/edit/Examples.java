package cz.paprsek.fx.model.edit;

import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Ellipsoid;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.function.DoubleFunction;

/** One shape of each primitive kind, to begin with. */
public final class Examples {
    /** By kind, for a size: about what each measures across. */
    private static final List<DoubleFunction<Shape>> TABLE = List.of(
            size -> new Sphere(part(size, 0.5)),
            size -> new Block(corner(size, -0.5), corner(size, 0.5)),
            size -> new Cylinder(part(size, 0.4), size),
            size -> new Cone(part(size, 0.5), size),
            size -> new Torus(part(size, 0.4), part(size, 0.15)),
            size -> new Ellipsoid(new Vec3(part(size, 0.6), part(size, 0.4), part(size, 0.4))),
            size -> new Plane(),
            size -> new Rectangle(part(size, -0.5), part(size, -0.5), part(size, 0.5), part(size, 0.5)),
            size -> new Disc(part(size, 0.5)));

    private Examples() {}

    /** One of each kind, of about the given size. */
    public static List<Shape> ofSize(double size) {
        return TABLE.stream().map(example -> example.apply(size)).toList();
    }

    private static Vec3 corner(double size, double share) {
        double c = part(size, share);
        return new Vec3(c, c, c);
    }

    /** A share of a size, without the noise of binary fractions. */
    private static double part(double size, double share) {
        return new BigDecimal(size * share).round(new MathContext(10)).doubleValue();
    }
}
