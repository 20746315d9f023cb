package cz.paprsek.scene;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Require;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import java.util.List;
import java.util.Locale;
import java.util.Objects;

/** What objects and operands have in common, so that they are edited alike. */
public record Body(String name, Shape shape, Placement placement, MaterialSource material) {
    public Body {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(shape, "shape");
        Objects.requireNonNull(placement, "placement");
        Objects.requireNonNull(material, "material");
    }

    public static Body of(SceneObject object) {
        return new Body(object.name(), object.shape(), object.placement(), object.material());
    }

    public static Body of(Operand operand) {
        return new Body(operand.name(), operand.solid(), operand.placement(), operand.material());
    }

    public SceneObject toObject() {
        return new SceneObject(name, shape, placement, material);
    }

    /** @throws IllegalArgumentException if the shape has no inside */
    public Operand toOperand() {
        Require.that(shape instanceof Solid, "a " + shape.getClass().getSimpleName().toLowerCase(Locale.ROOT)
                + " has no inside and cannot be combined with others");
        return new Operand(name, (Solid) shape, placement, material);
    }

    /** The operands; none if this is not an operation. */
    public List<Operand> operands() {
        return shape instanceof Csg csg ? csg.operands() : List.of();
    }

    public Body named(String value) {
        return new Body(value, shape, placement, material);
    }

    public Body withShape(Shape value) {
        return new Body(name, value, placement, material);
    }

    public Body placed(Placement value) {
        return new Body(name, shape, value, material);
    }

    public Body madeOf(MaterialSource value) {
        return new Body(name, shape, placement, value);
    }
}
