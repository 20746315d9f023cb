package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.edit.Rounds;
import cz.paprsek.fx.view.section.SectionSkin;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.ScenePath;
import java.util.Optional;
import java.util.Set;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/**
 * What the keys do in a projection: arrows move the selection by a step of the grid, with Shift by ten, or the plane that solids are cut by if that is held or
 * nothing is selected; + and − zoom, Home shows everything.
 */
final class PaneKeys {
    private static final double MANY = 10;

    private final ProjectionPane pane;

    PaneKeys(ProjectionPane pane) {
        this.pane = pane;
        pane.addEventHandler(KeyEvent.KEY_PRESSED, this::pressed);
        pane.focusedProperty().addListener((property, old, now) -> pane.section().ifPresent(SectionSkin::letGo));
    }

    private void pressed(KeyEvent event) {
        if (event.isShortcutDown() || event.isAltDown() || event.isConsumed()) {
            return;
        }
        boolean known = true;
        if (pane.section().filter(skin -> cut(skin, event)).isPresent()) {
            event.consume();
            return;
        }
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

    /** Moves the plane across its line, leaves it there or puts it back; false if it has nothing to do with the key. */
    private boolean cut(SectionSkin skin, KeyEvent event) {
        Optional<SectionSkin.Line> line = skin.line(pane.axes().along());
        if (line.isEmpty() || !(skin.isHeld() || pane.model().selection().isEmpty())) {
            return false;
        }
        KeyCode key = event.getCode();
        double u = key == KeyCode.RIGHT ? 1 : key == KeyCode.LEFT ? -1 : 0;
        double v = key == KeyCode.UP ? 1 : key == KeyCode.DOWN ? -1 : 0;
        double way = line.get().axis().of(pane.axes().vector(u, v));
        if (way != 0) {
            if (!skin.isHeld()) {
                skin.take();
            }
            double step = Rounds.step(pane.view().scale());
            skin.moveTo(Rounds.toGrid(line.get().place() + way * step * (event.isShiftDown() ? MANY : 1), step));
            return true;
        }
        if (skin.isHeld() && key == KeyCode.ESCAPE) {
            skin.putBack();
            return true;
        }
        if (skin.isHeld() && key == KeyCode.ENTER) {
            skin.letGo();
            return true;
        }
        return false;
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
