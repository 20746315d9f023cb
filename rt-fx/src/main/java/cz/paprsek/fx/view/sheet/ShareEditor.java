package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.property.Property;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Scene;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Optional;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Slider;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;

/** A number from 0 to 1 as a slider and a field. */
final class ShareEditor implements PropertyEditor {
    private final HBox box = new HBox();
    private final Slider slider = new Slider(0, 1, 0);
    private final Property property;
    private final PropertyEdit edit;
    private final NumberField field;
    private boolean showing;
    private boolean pressed;

    ShareEditor(Property property, PropertyEdit edit, Texts texts) {
        this.property = property;
        this.edit = edit;
        field = new NumberField(property, edit, texts);
        field.setPrefColumnCount(4);
        slider.setId(String.join("-", property.path()) + "-slider");
        slider.setBlockIncrement(property.trait().step());
        slider.setMinWidth(60);
        HBox.setHgrow(slider, Priority.ALWAYS);
        box.setAlignment(Pos.CENTER_LEFT);
        box.getStyleClass().add("share-editor");
        box.getChildren().addAll(slider, field);
        slider.addEventFilter(MouseEvent.MOUSE_PRESSED, event -> {
            pressed = true;
            edit.begin();
        });
        slider.addEventHandler(MouseEvent.MOUSE_RELEASED, event -> {
            pressed = false;
            edit.commit();
            show(edit.scene());
        });
        slider.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE && edit.isOpen()) {
                edit.cancel();
                event.consume();
            }
        });
        slider.addEventHandler(KeyEvent.KEY_RELEASED, event -> edit.commit());
        slider.focusedProperty().addListener((focus, was, is) -> {
            if (!is) {
                edit.commit();
            }
        });
        slider.valueProperty().addListener((value, was, is) -> slid(is.doubleValue()));
    }

    @Override
    public Node node() {
        return box;
    }

    NumberField field() {
        return field;
    }

    @Override
    public void show(Scene scene) {
        field.show(scene);
        showing = true;
        Optional<Object> common = property.read(scene);
        common.ifPresent(value -> slider.setValue((Double) value));
        // Several that differ have no one place on the slider.
        slider.setOpacity(common.isPresent() ? 1 : 0.4);
        showing = false;
    }

    private void slid(double value) {
        if (!showing && (edit.isOpen() || !pressed)) {
            if (!edit.isOpen()) {
                edit.begin();
            }
            double rounded = new BigDecimal(value).setScale(2, RoundingMode.HALF_EVEN).doubleValue();
            edit.preview(scene -> property.write(scene, rounded));
        }
    }
}
