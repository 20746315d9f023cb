package cz.paprsek.scene;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Require;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Placement.Pivot;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.copied.Repeated;
import java.util.List;
import java.util.Locale;
import java.util.Objects;

/** What objects and operands have in common, so that they are edited alike. */
public record Body(String name, Shape shape, Placement placement, Pivot pivot, boolean hidden, MaterialSource material) {
    public Body {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(shape, "shape");
        Objects.requireNonNull(placement, "placement");
        Objects.requireNonNull(pivot, "pivot");
        Objects.requireNonNull(material, "material");
    }

    /** One that is seen, and turned about its middle. */
    public Body(String name, Shape shape, Placement placement, MaterialSource material) {
        this(name, shape, placement, Placement.MIDDLE, false, material);
    }

    public static Body of(SceneObject object) {
        return new Body(object.name(), object.shape(), object.placement(), object.pivot(), object.hidden(), object.material());
    }

    public static Body of(Operand operand) {
        return new Body(operand.name(), operand.solid(), operand.placement(), operand.pivot(), operand.hidden(), operand.material());
    }

    public SceneObject toObject() {
        return new SceneObject(name, shape, placement, pivot, hidden, material);
    }

    /** @throws IllegalArgumentException if the shape has no inside */
    public Operand toOperand() {
        Require.that(shape instanceof Solid, "a " + shape.getClass().getSimpleName().toLowerCase(Locale.ROOT)
                + " has no inside and cannot be combined with others");
        return new Operand(name, (Solid) shape, placement, pivot, hidden, material);
    }

    /** The operands; none if this is not an operation. */
    public List<Operand> operands() {
        return shape instanceof Csg csg ? csg.operands() : List.of();
    }

    /** How many primitives it is made of, or some number that is not below {@code most}: so it is soon told of whatever nest. */
    public long primitives(long most) {
        return shape instanceof Csg csg ? Repeated.primitives(csg, most) : 1;
    }

    public Body named(String value) {
        return new Body(value, shape, placement, pivot, hidden, material);
    }

    public Body withShape(Shape value) {
        return new Body(name, value, placement, pivot, hidden, material);
    }

    public Body placed(Placement value) {
        return new Body(name, shape, value, pivot, hidden, material);
    }

    public Body turnedAbout(Pivot value) {
        return new Body(name, shape, placement, value, hidden, material);
    }

    public Body hidden(boolean value) {
        return new Body(name, shape, placement, pivot, value, material);
    }

    public Body madeOf(MaterialSource value) {
        return new Body(name, shape, placement, pivot, hidden, value);
    }
}
