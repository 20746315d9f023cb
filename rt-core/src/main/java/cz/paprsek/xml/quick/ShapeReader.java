package cz.paprsek.xml.quick;

import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Placement.Pivot;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.copied.Recent;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Reads the elements of objects and operands. */
final class ShapeReader {
    private final Markup markup;
    private final double[] room;
    private final MaterialReader materials;
    /** Copies of one definition are one: as many as there are need no room for each. */
    private final Recent recent = new Recent();
    /** Of the shape read last: mostly there are many of a kind in a row. */
    private int latest;

    /** @param room for three numbers */
    ShapeReader(Markup markup, double[] room, MaterialReader materials) {
        this.markup = markup;
        this.room = room;
        this.materials = materials;
    }

    /** The object whose start tag is at hand. */
    SceneObject object(int depth) throws IOException {
        ShapeForm form = form();
        Object[] values = form.tag().read(markup, room);
        Inside inside = inside(form, depth);
        return new SceneObject((String) values[0], shape(form, values, inside), placement(values), pivot(values), (boolean) values[3], material(values, inside));
    }

    private Operand operand(int depth) throws IOException {
        ShapeForm form = form();
        Unusual.unless(form.isSolid());
        Object[] values = form.tag().read(markup, room);
        Inside inside = inside(form, depth);
        Shape solid = shape(form, values, inside);
        return new Operand((String) values[0], (Solid) solid, placement(values), pivot(values), (boolean) values[3], material(values, inside));
    }

    private Shape shape(ShapeForm form, Object[] values, Inside inside) {
        Shape shape = form.maker().make(values, inside.operands);
        return shape instanceof Csg csg ? recent.only(csg) : shape;
    }

    private ShapeForm form() {
        List<ShapeForm> all = ShapeForm.ALL;
        for (int i = 0; i < all.size(); i++) {
            int candidate = (latest + i) % all.size();
            if (all.get(candidate).name().isAtHand(markup)) {
                latest = candidate;
                return all.get(candidate);
            }
        }
        throw new Unusual();
    }

    private static Placement placement(Object[] values) {
        return ShapeForm.PLACEMENT.isStandard(values, ShapeForm.PLACEMENT_AT) ? Placement.NONE
                : ShapeForm.PLACEMENT.make(values, ShapeForm.PLACEMENT_AT);
    }

    private static Pivot pivot(Object[] values) {
        return values[2] == Slot.NONE ? Placement.MIDDLE : new Placement.Point((Vec3) values[2]);
    }

    private static MaterialSource material(Object[] values, Inside inside) {
        boolean hasName = values[1] != Slot.NONE;
        Unusual.unless(!hasName || inside.material == null);
        return inside.material != null ? inside.material : hasName ? new MaterialName((String) values[1]) : Inherited.INHERITED;
    }

    /** What an object has inside. */
    private record Inside(@Nullable MaterialSource material, List<Operand> operands) {
        static final Inside NOTHING = new Inside(null, List.of());
    }

    /** A material first, if any, and then the operands of an operation. */
    private Inside inside(ShapeForm form, int depth) throws IOException {
        if (!markup.hasContent(depth)) {
            return Inside.NOTHING;
        }
        MaterialSource material = null;
        List<Operand> operands = new ArrayList<>();
        while (markup.nextTag()) {
            if (markup.isNamed(MaterialReader.ELEMENT)) {
                Unusual.unless(material == null && operands.isEmpty());
                MaterialReader.Named own = materials.read(depth + 1);
                Unusual.unless(own.name().isEmpty());
                material = own.material();
            } else {
                Unusual.unless(form.isOperation());
                operands.add(operand(depth + 1));
            }
        }
        form.name().end(markup);
        return new Inside(material, operands);
    }
}
