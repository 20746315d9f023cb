package cz.paprsek.shape;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Placement.Pivot;
import java.util.Objects;

/**
 * One solid of a CSG operation, placed in the space of the operation.
 *
 * @param name free text for people; empty for none, unique among its siblings otherwise
 * @param pivot what hands turn and scale it about; pictures do not depend on it
 * @param hidden whether it is left out, as if the operation did not have it
 */
public record Operand(String name, Solid solid, Placement placement, Pivot pivot, boolean hidden, MaterialSource material) {
    public Operand {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(solid, "solid");
        Objects.requireNonNull(placement, "placement");
        Objects.requireNonNull(pivot, "pivot");
        Objects.requireNonNull(material, "material");
    }

    /** One that is seen, and turned about its middle. */
    public Operand(String name, Solid solid, Placement placement, MaterialSource material) {
        this(name, solid, placement, Placement.MIDDLE, false, material);
    }

    public static Operand of(Solid solid) {
        return new Operand("", solid, Placement.NONE, Inherited.INHERITED);
    }

    public Operand named(String value) {
        return new Operand(value, solid, placement, pivot, hidden, material);
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
        return new Operand(name, solid, value, pivot, hidden, material);
    }

    /** The same of another solid. */
    public Operand withSolid(Solid value) {
        return new Operand(name, value, placement, pivot, hidden, material);
    }

    public Operand madeOf(MaterialSource value) {
        return new Operand(name, solid, placement, pivot, hidden, value);
    }
}
