package cz.paprsek.fx.view.tree;

import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.List;
import java.util.Optional;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/** The tree by keyboard: arrows, Shift for ranges, left and right for operations, F2 for names, letters to find. */
final class TreeKeys {
    private static final int PAGE = 12;

    private final ObjectTree tree;
    private final TreeSelection selection;
    private final TreeState state;
    private final Edits edits;
    private final TextField find;

    TreeKeys(ObjectTree tree, TreeSelection selection, TreeState state, Edits edits, TextField find) {
        this.tree = tree;
        this.selection = selection;
        this.state = state;
        this.edits = edits;
        this.find = find;
    }

    void attach(ListView<TreeRow> list) {
        list.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (!(event.getTarget() instanceof TextField) && (pressed(event) || isForFind(event))) {
                event.consume();
            }
        });
        list.addEventHandler(KeyEvent.KEY_TYPED, event -> {
            String typed = event.getCharacter();
            if (!(event.getTarget() instanceof TextField) && !event.isShortcutDown() && !event.isAltDown()
                    && typed.length() == 1 && typed.charAt(0) > ' ' && typed.charAt(0) != KeyEvent.CHAR_UNDEFINED.charAt(0)
                    && typed.charAt(0) != 127) {
                find.requestFocus();
                find.setText(typed);
                find.end();
                event.consume();
            }
        });
    }

    /** Letters are looked for, and switch nothing on in the views. */
    private static boolean isForFind(KeyEvent event) {
        return event.getCode().isLetterKey() && !event.isShortcutDown() && !event.isAltDown();
    }

    private boolean pressed(KeyEvent event) {
        List<TreeRow> rows = tree.rows();
        int lead = selection.lead(rows);
        KeyCode code = event.getCode();
        if (code == KeyCode.A && event.isShortcutDown()) {
            selection.all(rows);
            return true;
        }
        if (event.isShortcutDown() || event.isAltDown()) {
            return false;
        }
        switch (code) {
            case UP -> go(rows, lead - 1, event);
            case DOWN -> go(rows, lead + 1, event);
            case PAGE_UP -> go(rows, lead - PAGE, event);
            case PAGE_DOWN -> go(rows, lead + PAGE, event);
            case HOME -> go(rows, 0, event);
            case END -> go(rows, rows.size() - 1, event);
            case LEFT -> left(rows, lead);
            case RIGHT -> right(rows, lead, event);
            case F2 -> {
                if (lead >= 0) {
                    state.rename(rows.get(lead).item());
                }
            }
            case DELETE, BACK_SPACE -> edits.delete();
            case ESCAPE -> {
                boolean dragging = state.dropProperty().get().isPresent();
                state.setDrop(Optional.empty());
                return dragging;
            }
            default -> {
                return false;
            }
        }
        return true;
    }

    private void go(List<TreeRow> rows, int index, KeyEvent event) {
        if (rows.isEmpty()) {
            return;
        }
        int to = Math.max(0, Math.min(rows.size() - 1, index));
        if (event.isShiftDown()) {
            selection.extend(rows, rows.get(to));
        } else {
            selection.only(rows.get(to));
        }
        tree.scrollTo(to);
    }

    /** Closes an operation, or goes to the one around. */
    private void left(List<TreeRow> rows, int lead) {
        if (lead < 0) {
            return;
        }
        TreeRow row = rows.get(lead);
        if (row.expanded()) {
            tree.expand(row, false);
        } else if (row.item() instanceof BodyAt at && at.depth() > 0) {
            rows.stream().filter(other -> other.item().equals(at.parent())).findFirst().ifPresent(selection::only);
        }
    }

    /** Opens an operation, or goes to what is in it. */
    private void right(List<TreeRow> rows, int lead, KeyEvent event) {
        if (lead >= 0 && rows.get(lead).operation()) {
            if (rows.get(lead).expanded()) {
                go(rows, lead + 1, event);
            } else {
                tree.expand(rows.get(lead), true);
            }
        }
    }
}
