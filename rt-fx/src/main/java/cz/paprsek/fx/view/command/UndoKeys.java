package cz.paprsek.fx.view.command;

import cz.paprsek.fx.model.EditorModel;
import javafx.scene.Node;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;

/** Lets the keys of undo and redo reach the editor's history from within a text field, which would otherwise keep them to itself. */
public final class UndoKeys {
    private static final KeyCombination UNDO = new KeyCodeCombination(KeyCode.Z, KeyCombination.SHORTCUT_DOWN);
    private static final KeyCombination REDO =
            new KeyCodeCombination(KeyCode.Z, KeyCombination.SHORTCUT_DOWN, KeyCombination.SHIFT_DOWN);
    private static final KeyCombination REDO_TOO = new KeyCodeCombination(KeyCode.Y, KeyCombination.SHORTCUT_DOWN);

    private UndoKeys() {}

    /** Makes the keys work in a node and all within it. */
    public static void reach(EditorModel model, Node node) {
        reach(model::undo, model::redo, node);
    }

    /** As {@link #reach(EditorModel, Node)}, for another history. */
    public static void reach(Runnable undo, Runnable redo, Node node) {
        node.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (UNDO.match(event)) {
                undo.run();
                event.consume();
            } else if (REDO.match(event) || REDO_TOO.match(event)) {
                redo.run();
                event.consume();
            }
        });
    }
}
