package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.property.Property;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import javafx.scene.Node;
import javafx.scene.layout.HBox;

/** Three numbers beside each other, each with the letter of its axis, by which it can be dragged. */
final class VectorEditor implements PropertyEditor {
    private static final List<String> AXES = List.of("x", "y", "z");
    private static final Map<String, Function<Vec3, Double>> PARTS = Map.of("x", Vec3::x, "y", Vec3::y, "z", Vec3::z);

    private final HBox box = new HBox();
    private final List<NumberField> fields = new ArrayList<>();
    private final Property property;

    /** @param linked whether the three are to stay in proportion for now */
    VectorEditor(Property property, PropertyEdit edit, Texts texts, BooleanSupplier linked) {
        this.property = property;
        box.getStyleClass().add("vector-editor");
        for (String axis : AXES) {
            Property part = property.part(axis);
            NumberField field = new NumberField(part, edit, texts, (scene, change) ->
                    linked.getAsBoolean() ? inProportion(property, scene, axis, change) : part.change(scene, change));
            box.getChildren().add(field.behind(axis, axis));
            fields.add(field);
        }
    }

    @Override
    public Node node() {
        return box;
    }

    @Override
    public void show(Scene scene) {
        // Of very many things that have it in common it is read once, not three times.
        Optional<Object> common = property.read(scene);
        for (int i = 0; i < AXES.size(); i++) {
            NumberField field = fields.get(i);
            Function<Vec3, Double> part = PARTS.getOrDefault(AXES.get(i), Vec3::x);
            common.ifPresentOrElse(vector -> field.show(scene, Optional.of(part.apply((Vec3) vector))), () -> field.show(scene));
        }
    }

    private static Scene inProportion(Property property, Scene scene, String axis, UnaryOperator<Object> change) {
        return property.change(scene, old -> {
            Vec3 vector = (Vec3) old;
            double part = PARTS.getOrDefault(axis, Vec3::x).apply(vector);
            double fresh = (Double) change.apply(part);
            return new Vec3(
                    axis.equals("x") ? fresh : scaled(vector.x(), fresh, part),
                    axis.equals("y") ? fresh : scaled(vector.y(), fresh, part),
                    axis.equals("z") ? fresh : scaled(vector.z(), fresh, part));
        });
    }

    /** Equal parts stay equal to the last digit. */
    private static double scaled(double other, double fresh, double part) {
        return other == part ? fresh : other * (fresh / part);
    }
}
