package cz.paprsek.fx.view.tree;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javafx.scene.Node;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.PickResult;
import org.jspecify.annotations.Nullable;

/** The tree by mouse: clicks select, open, hide and lock, on the icon of a camera look through it; drags reorder and regroup. */
final class TreeMouse {
    private static final double THRESHOLD = 4;

    private final ObjectTree tree;
    private final TreeSelection selection;
    private final TreeState state;
    private final Edits edits;
    private final EditorModel model;
    private @Nullable TreeRow pressed;
    private boolean dragging;
    private double pressedY;

    TreeMouse(ObjectTree tree, TreeSelection selection, TreeState state, Edits edits, EditorModel model) {
        this.tree = tree;
        this.selection = selection;
        this.state = state;
        this.edits = edits;
        this.model = model;
    }

    void attach(ListView<TreeRow> list) {
        list.addEventFilter(MouseEvent.MOUSE_PRESSED, event -> cell(event).ifPresent(cell -> {
            list.requestFocus();
            press(event, cell);
            event.consume();
        }));
        list.addEventFilter(MouseEvent.MOUSE_DRAGGED, event -> {
            if (pressed != null) {
                drag(event, list);
                event.consume();
            }
        });
        list.addEventFilter(MouseEvent.MOUSE_RELEASED, event -> {
            if (pressed != null) {
                release(event);
                event.consume();
            }
        });
    }

    private void press(MouseEvent event, RowCell cell) {
        TreeRow row = cell.getItem();
        if (event.getButton() == MouseButton.SECONDARY) {
            if (!selection.contains(row)) {
                selection.only(row);
            }
        } else if (event.getButton() != MouseButton.PRIMARY) {
            return;
        } else if (isOn(event, "row-arrow") && row.operation()) {
            tree.expand(row, !row.expanded());
        } else if (isOn(event, "row-eye")) {
            edits.hide(affected(row), !model.state().hidden().contains(row.item()));
        } else if (isOn(event, "row-lock")) {
            edits.lock(affected(row), !model.state().locked().contains(row.item()));
        } else if (isOn(event, "row-icon") && row.item() instanceof CameraAt camera && event.getClickCount() == 1) {
            selection.only(row);
            model.look(camera.index());
        } else if (event.getClickCount() == 2) {
            state.rename(row.item());
        } else {
            pressed = row;
            pressedY = event.getSceneY();
            dragging = false;
            if (event.isShiftDown()) {
                selection.extend(tree.rows(), row);
            } else if (event.isShortcutDown()) {
                selection.toggle(row);
            } else if (!selection.contains(row)) {
                selection.only(row);
            }
        }
    }

    private void drag(MouseEvent event, ListView<TreeRow> list) {
        dragging |= Math.abs(event.getSceneY() - pressedY) > THRESHOLD;
        if (dragging) {
            state.setDrop(cell(event).flatMap(cell ->
                    Drop.at(cell.getItem(), cell.sceneToLocal(event.getSceneX(), event.getSceneY()).getY() / cell.getHeight(), dragged())));
            double y = list.sceneToLocal(event.getSceneX(), event.getSceneY()).getY();
            if (y < list.getFixedCellSize() || y > list.getHeight() - list.getFixedCellSize()) {
                cell(event).ifPresent(cell -> tree.scrollTo(cell.getIndex()));
            }
        }
    }

    private void release(MouseEvent event) {
        TreeRow row = pressed;
        pressed = null;
        Optional<Drop> drop = state.dropProperty().get();
        if (dragging) {
            drop.ifPresent(this::drop);
        } else if (row != null && !event.isShiftDown() && !event.isShortcutDown()) {
            // Only now, for a press may also be the beginning of a drag of all that is selected.
            selection.only(row);
        }
        state.setDrop(Optional.empty());
    }

    private void drop(Drop drop) {
        Set<ScenePath> items = model.selection();
        if (drop.row().item() instanceof LightAt) {
            Places.lights(items).stream().findFirst().ifPresent(light -> edits.moveLight(light, drop.index(0)));
        } else {
            int operands = drop.row().item() instanceof BodyAt at
                    ? at.find(model.scene()).map(body -> body.operands().size()).orElse(0) : 0;
            edits.move(items, drop.parent(), drop.index(operands));
        }
    }

    private List<TreeRow> dragged() {
        return tree.rows().stream().filter(selection::contains).toList();
    }

    /** A click on the eye or lock of one of several that are selected is for all of them. */
    private Set<ScenePath> affected(TreeRow row) {
        return selection.contains(row) ? model.selection() : Set.of(row.item());
    }

    /** The line under the mouse. */
    static Optional<TreeRow> row(PickResult pick) {
        return cell(pick).map(RowCell::getItem);
    }

    private static Optional<RowCell> cell(MouseEvent event) {
        return cell(event.getPickResult());
    }

    private static Optional<RowCell> cell(PickResult pick) {
        for (Node node = pick.getIntersectedNode(); node != null; node = node.getParent()) {
            if (node instanceof TextField) {
                return Optional.empty();
            }
            if (node instanceof RowCell cell) {
                return cell.isEmpty() ? Optional.empty() : Optional.of(cell);
            }
        }
        return Optional.empty();
    }

    private static boolean isOn(MouseEvent event, String styleClass) {
        for (Node node = event.getPickResult().getIntersectedNode(); node != null; node = node.getParent()) {
            if (node.getStyleClass().contains(styleClass)) {
                return true;
            }
        }
        return false;
    }
}
