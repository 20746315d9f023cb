package cz.paprsek.fx.view.dialog;

import cz.paprsek.fx.view.dialog.Tint.Part;
import cz.paprsek.fx.view.render.fields.CheckedField;
import cz.paprsek.fx.view.render.fields.FormGrid;
import cz.paprsek.fx.view.render.fields.HexField;
import cz.paprsek.fx.view.texts.Texts;
import java.util.ArrayList;
import java.util.List;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.HBox;
import javafx.scene.paint.Color;
import javafx.scene.shape.Rectangle;

/**
 * A colour by hue, saturation and brightness, by red, green and blue as files have them, and by its number of six digits: a strip and a field for each, all in step.
 * Below is what it was beside what it is.
 */
final class ColorForm extends GridPane {
    private static final double WIDTH = 132;
    private static final double HEIGHT = 40;
    private static final double REFUSAL = 40;

    private final List<ColorStrip> strips = new ArrayList<>();
    private final HexField hex;
    private final Rectangle shown = ColorStrip.bordered(WIDTH, HEIGHT);
    private final BooleanBinding refused;
    private final Tint first;
    private Tint tint;
    private boolean showing;
    private boolean typing;

    ColorForm(Color start, Texts texts) {
        first = Tint.of(start);
        tint = first;
        getStyleClass().add("color-form");
        getStylesheets().add(String.valueOf(ColorForm.class.getResource("dialog.css")));
        for (Part part : Part.values()) {
            ColorStrip strip = new ColorStrip(part, texts, number -> change(tint.sought(part, number)), number -> change(tint.with(part, number)));
            strips.add(strip);
            Label label = new Label(texts.of(part.key()));
            label.setLabelFor(strip.field());
            label.setMinWidth(USE_PREF_SIZE);
            addRow(strips.size() - 1, label, strip.strip(), strip.field(), new Label(part == Part.HUE ? "°" : part.most() == 100 ? "%" : ""));
        }
        hex = new HexField("color-hex", texts.of("color.hex"), texts.of("color.hex.hint"));
        hex.textProperty().addListener((property, old, now) -> {
            if (!showing && hex.validProperty().get()) {
                typing = true;
                change(tint.shown(hex.get()));
                typing = false;
            }
        });
        hex.setMaxWidth(WIDTH);
        Rectangle before = ColorStrip.bordered(WIDTH, HEIGHT);
        before.setFill(start);
        shown.setId("color-shown");
        int row = Part.values().length;
        Label name = new Label(texts.of("color.hex"));
        name.setLabelFor(hex);
        addRow(row, name, hex);
        Label both = new Label(texts.of("color.shown"));
        both.setMinWidth(USE_PREF_SIZE);
        addRow(row + 1, both, new HBox(before, shown));
        List<CheckedField> fields = new ArrayList<>(strips.stream().map(ColorStrip::field).toList());
        fields.add(hex);
        ObservableValue<String> wanted = FormGrid.refusal(fields);
        Label refusal = new Label();
        refusal.setId("color-refusal");
        refusal.getStyleClass().add("field-refusal");
        refusal.textProperty().bind(wanted);
        refusal.setWrapText(true);
        // Room for two lines from the beginning: windows do not grow when something is told. Nor is it as wide as what it says.
        refusal.setPrefWidth(WIDTH);
        refusal.setMaxWidth(Double.MAX_VALUE);
        refusal.setMinHeight(REFUSAL);
        refusal.setAlignment(Pos.TOP_LEFT);
        add(refusal, 0, row + 2, 4, 1);
        refused = Bindings.createBooleanBinding(() -> !wanted.getValue().isEmpty(), wanted);
        for (CheckedField field : fields) {
            field.focusedProperty().addListener((property, was, is) -> {
                // What has been left half typed counts for nothing.
                if (!is && !field.validProperty().get()) {
                    show();
                }
            });
        }
        show();
    }

    /** What has been chosen. */
    Color color() {
        return tint.color();
    }

    /** Whether that is another colour than at first. */
    boolean isChanged() {
        return !tint.equals(first);
    }

    /** Whether there is something in a field that is no number of a colour. */
    BooleanBinding refused() {
        return refused;
    }

    /** Takes the keyboard, at the first strip. */
    void takeKeys() {
        strips.get(0).takeKeys();
    }

    private void change(Tint now) {
        tint = now;
        show();
    }

    private void show() {
        showing = true;
        strips.forEach(strip -> strip.show(tint));
        shown.setFill(color());
        if (!typing) {
            hex.set(color());
        }
        showing = false;
    }
}
