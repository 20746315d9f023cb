package cz.paprsek.fx.view.texts;

import java.util.function.BooleanSupplier;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;

/** A click into a field for a number takes all of it, so that what is typed then takes its place; a second click goes between its digits. */
public final class FirstClick {
    private final TextField field;
    private final BooleanSupplier isWanted;
    /** By mouse or keys since the field has the keyboard, which may have come to it without either. */
    private boolean isTouched;
    private boolean isFirst;

    private FirstClick(TextField field, BooleanSupplier isWanted) {
        this.field = field;
        this.isWanted = isWanted;
    }

    /** @param isWanted whether what stands in the field now is likely to be typed anew */
    public static void takesAll(TextField field, BooleanSupplier isWanted) {
        FirstClick click = new FirstClick(field, isWanted);
        field.focusedProperty().addListener((property, was, is) -> click.isTouched &= is);
        field.addEventFilter(KeyEvent.KEY_TYPED, event -> click.isTouched = true);
        field.addEventFilter(MouseEvent.MOUSE_PRESSED, event -> {
            click.isFirst = event.getButton() == MouseButton.PRIMARY && !click.isTouched;
            click.isTouched = true;
        });
        field.addEventHandler(MouseEvent.MOUSE_RELEASED, event -> click.released());
    }

    private void released() {
        // What was dragged over is what is meant.
        if (isFirst && field.getSelection().getLength() == 0 && isWanted.getAsBoolean()) {
            field.selectAll();
        }
        isFirst = false;
    }
}
