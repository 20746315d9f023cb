package cz.paprsek.xml.quick;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Text;
import cz.paprsek.shape.height.HeightField;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * The element of a kind of shape.
 *
 * @param tag the attributes of every object, then those of the shape
 * @param isOperation whether there are operands inside
 */
record ShapeForm(Name name, TagForm tag, boolean isSolid, boolean isOperation, Maker maker) {
    static final RecordForm<Placement> PLACEMENT = new RecordForm<>(Placement.class);
    /** Where the attributes of the placement begin, after name, material, pivot and whether it is hidden. */
    static final int PLACEMENT_AT = 4;
    private static final int MEASURES_AT = PLACEMENT_AT + PLACEMENT.slots().size();
    private static final List<Slot> OF_ALL = Stream.concat(
            Stream.of(Slot.optional("name", ValueForm.TEXT, Slot.NONE), Slot.optional("material", ValueForm.TEXT, Slot.NONE),
                    Slot.optional("pivot", ValueForm.VECTOR, Slot.NONE), Slot.optional("hidden", ValueForm.FLAG, false)),
            PLACEMENT.slots().stream()).toList();

    /** All there are. */
    static final List<ShapeForm> ALL = ElementTable.of(Shape.class).flatMap(ShapeForm::of).toList();

    /** Makes a shape of the values of a tag and the operands inside. */
    interface Maker {
        Shape make(Object[] values, List<Operand> operands);
    }

    private static Stream<ShapeForm> of(Class<? extends Record> type) {
        if (type == Csg.class) {
            return Arrays.stream(Csg.Operation.values()).map(operation ->
                    of(Described.word(operation), List.of(), true, true, (values, operands) -> new Csg(operation, operands)));
        }
        RecordForm<? extends Record> shape = new RecordForm<>(type);
        Object unread = type == Text.class ? Text.Content.UNREAD : type == HeightField.class ? HeightField.Content.UNREAD : Mesh.Content.UNREAD;
        return Stream.of(of(ElementTable.name(type), shape.slots(), Solid.class.isAssignableFrom(type), false,
                (values, operands) -> (Shape) shape.make(values, MEASURES_AT, unread)));
    }

    private static ShapeForm of(String name, List<Slot> measures, boolean isSolid, boolean isOperation, Maker maker) {
        return new ShapeForm(new Name(name), new TagForm(OF_ALL, measures), isSolid, isOperation, maker);
    }
}
