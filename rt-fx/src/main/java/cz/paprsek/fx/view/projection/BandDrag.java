package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.scene.ScenePath;
import java.util.LinkedHashSet;
import java.util.Set;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** Selects all that lies wholly within a rubber band. */
final class BandDrag implements Drag {
    private final EditorModel model;
    private final Picker picker;
    private final Viewport view;
    private final Set<ScenePath> before;
    private final Color color;
    private final double startX;
    private final double startY;
    private double x;
    private double y;

    /** @param before what was selected and stays so */
    BandDrag(EditorModel model, Picker picker, Viewport view, Set<ScenePath> before, Color color, double startX, double startY) {
        this.model = model;
        this.picker = picker;
        this.view = view;
        this.before = before;
        this.color = color;
        this.startX = startX;
        this.startY = startY;
        this.x = startX;
        this.y = startY;
    }

    @Override
    public void to(double toX, double toY, Keys keys) {
        x = toX;
        y = toY;
        Set<ScenePath> selected = new LinkedHashSet<>(before);
        selected.addAll(picker.within(model.state(), Box.of(view.u(startX), view.v(startY), view.u(x), view.v(y))));
        model.select(selected);
    }

    @Override
    public void end() {}

    @Override
    public void cancel() {
        model.select(before);
    }

    @Override
    public void draw(GraphicsContext g) {
        g.setFill(color.deriveColor(0, 1, 1, 0.12));
        g.fillRect(Math.min(x, startX), Math.min(y, startY), Math.abs(x - startX), Math.abs(y - startY));
        g.setStroke(color);
        g.strokeRect(Math.min(x, startX) + 0.5, Math.min(y, startY) + 0.5, Math.abs(x - startX), Math.abs(y - startY));
    }
}
