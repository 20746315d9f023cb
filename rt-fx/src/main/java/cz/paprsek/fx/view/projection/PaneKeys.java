package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.edit.Rounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.ScenePath;
import java.util.Set;
import javafx.scene.input.KeyEvent;

/** What the keys do in a projection: arrows move the selection by a step of the grid, with Shift by ten; + and − zoom, Home shows everything. */
final class PaneKeys {
    private static final double MANY = 10;

    private final ProjectionPane pane;

    PaneKeys(ProjectionPane pane) {
        this.pane = pane;
        pane.addEventHandler(KeyEvent.KEY_PRESSED, this::pressed);
    }

    private void pressed(KeyEvent event) {
        if (event.isShortcutDown() || event.isAltDown()) {
            return;
        }
        boolean known = true;
        switch (event.getCode()) {
            case LEFT -> nudge(-1, 0, event.isShiftDown());
            case RIGHT -> nudge(1, 0, event.isShiftDown());
            case UP -> nudge(0, 1, event.isShiftDown());
            case DOWN -> nudge(0, -1, event.isShiftDown());
            case PLUS, ADD, EQUALS -> pane.zoom(1.25);
            case MINUS, SUBTRACT -> pane.zoom(1 / 1.25);
            case HOME -> pane.fitAll();
            case F -> pane.fitSelection();
            default -> known = false;
        }
        if (known) {
            event.consume();
        }
    }

    private void nudge(double u, double v, boolean many) {
        Set<ScenePath> items = pane.movable();
        if (items.isEmpty() || pane.model().gesturingProperty().get()) {
            return;
        }
        double step = Rounds.step(pane.view().scale()) * (many ? MANY : 1);
        Vec3 by = pane.axes().vector(Rounds.toGrid(u * step, step), Rounds.toGrid(v * step, step));
        pane.edits().translate(items, by);
    }
}
