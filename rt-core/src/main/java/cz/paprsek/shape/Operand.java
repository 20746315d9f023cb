package cz.paprsek.shape;

import cz.paprsek.material.Inherited;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Vec3;
import java.util.Objects;

/**
 * One solid of a CSG operation, placed in the space of the operation.
 *
 * @param name free text for people; empty for none, unique among its siblings otherwise
 */
public record Operand(String name, Solid solid, Placement placement, MaterialSource material) {
    public Operand {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(solid, "solid");
        Objects.requireNonNull(placement, "placement");
        Objects.requireNonNull(material, "material");
    }


    public static Operand of(Solid solid) {
        return new Operand("", solid, Placement.NONE, Inherited.INHERITED);
    }

    public Operand named(String value) {
        return new Operand(value, solid, placement, material);
    }

    public Operand at(double x, double y, double z) {
        return placed(placement.withPosition(new Vec3(x, y, z)));
    }

    public Operand rotated(double x, double y, double z) {
        return placed(placement.withRotation(new Vec3(x, y, z)));
    }

    public Operand scaled(double x, double y, double z) {
        return placed(placement.withScale(new Vec3(x, y, z)));
    }

    public Operand placed(Placement value) {
        return new Operand(name, solid, value, material);
    }

    public Operand madeOf(MaterialSource value) {
        return new Operand(name, solid, placement, value);
    }
}
