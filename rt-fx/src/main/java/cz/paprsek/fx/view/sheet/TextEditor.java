package cz.paprsek.fx.view.sheet;

import cz.paprsek.scene.Scene;
import java.util.function.BiFunction;
import java.util.function.Function;
import javafx.scene.Node;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/** A line of text, taken over with Enter or on leaving the field, given back with Escape. */
final class TextEditor implements PropertyEditor {
    private final TextField field = new TextField();
    private final PropertyEdit edit;
    private final Function<Scene, String> read;
    private final BiFunction<Scene, String, Scene> write;
    private String shown = "";

    TextEditor(String id, PropertyEdit edit, Function<Scene, String> read, BiFunction<Scene, String, Scene> write) {
        this.edit = edit;
        this.read = read;
        this.write = write;
        field.setId(id);
        field.setMinWidth(0);
        field.setOnAction(event -> enter());
        field.focusedProperty().addListener((focus, was, is) -> {
            if (!is) {
                enter();
            }
        });
        field.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE && !field.getText().equals(shown)) {
                field.setText(shown);
                edit.forgive();
                event.consume();
            }
        });
    }

    @Override
    public Node node() {
        return field;
    }

    @Override
    public void show(Scene scene) {
        String now = read.apply(scene);
        if (!now.equals(shown)) {
            shown = now;
            field.setText(now);
        }
    }

    private void enter() {
        String text = field.getText();
        if (!text.equals(shown)) {
            // Taken to be shown already, for the change itself leads back here when the sheet is made anew.
            String before = shown;
            shown = text;
            if (!edit.change(scene -> write.apply(scene, text))) {
                shown = before;
            }
        }
    }
}
