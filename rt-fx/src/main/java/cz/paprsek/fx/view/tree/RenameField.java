package cz.paprsek.fx.view.tree;

import java.util.Optional;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/** Takes the place of a name while it is changed: Enter or leaving keeps the new one, Escape the old one. */
final class RenameField extends TextField {
    private final TreeState tree;
    private boolean active;

    RenameField(TreeState tree) {
        this.tree = tree;
        setId("tree-rename");
        setOnAction(event -> end(Optional.of(getText().strip())));
        addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                end(Optional.empty());
                event.consume();
            }
        });
        focusedProperty().addListener((focus, was, is) -> {
            if (!is) {
                end(Optional.of(getText().strip()));
            }
        });
    }

    void begin(TreeRow row) {
        setText(row.named() ? row.text() : "");
        setPromptText(row.text());
        active = true;
        requestFocus();
        selectAll();
    }

    private void end(Optional<String> name) {
        if (active) {
            active = false;
            tree.endRename(name);
        }
    }
}
