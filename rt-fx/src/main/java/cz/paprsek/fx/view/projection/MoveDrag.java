package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.scene.ScenePath;
import java.util.Locale;
import java.util.Set;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** Moves items in the plane of the projection. */
final class MoveDrag implements Drag {
    private final Gesture gesture;
    private final Set<ScenePath> items;
    private final Axes axes;
    private final Viewport view;
    private final Box box;
    private final double referenceU;
    private final double referenceV;
    private final Snapping snapping;
    private final boolean snaps;
    private final Color guideColor;
    private final double startX;
    private final double startY;
    private double guideU = Double.NaN;
    private double guideV = Double.NaN;
    private double byU;
    private double byV;

    /**
     * @param box around the items
     * @param reference what is put on the grid: the position of a single item, a corner of several
     */
    MoveDrag(Gesture gesture, Set<ScenePath> items, Axes axes, Viewport view, Box box, Box reference, Snapping snapping, boolean snaps,
            Color guideColor, double startX, double startY) {
        this.gesture = gesture;
        this.items = items;
        this.axes = axes;
        this.view = view;
        this.box = box;
        this.referenceU = reference.minU();
        this.referenceV = reference.minV();
        this.snapping = snapping;
        this.snaps = snaps;
        this.guideColor = guideColor;
        this.startX = startX;
        this.startY = startY;
    }

    @Override
    public void to(double x, double y, Keys keys) {
        boolean onlyV = keys.straight() && Math.abs(x - startX) < Math.abs(y - startY);
        boolean onlyU = keys.straight() && !onlyV;
        double du = (x - startX) / view.scale();
        double dv = (startY - y) / view.scale();
        guideU = Double.NaN;
        guideV = Double.NaN;
        if (snaps && !keys.free()) {
            Snapping.Move alongU = snapping.alongU(box, du, referenceU, view);
            Snapping.Move alongV = snapping.alongV(box, dv, referenceV, view);
            du = alongU.by();
            dv = alongV.by();
            guideU = onlyV ? Double.NaN : alongU.guide();
            guideV = onlyU ? Double.NaN : alongV.guide();
        }
        byU = onlyV ? 0 : du;
        byV = onlyU ? 0 : dv;
        gesture.preview(scene -> Moves.translated(scene, items, axes.vector(byU, byV)));
    }

    @Override
    public void end() {
        gesture.commit();
    }

    @Override
    public void cancel() {
        gesture.cancel();
    }

    @Override
    public String figures(Locale locale) {
        return axes.right().letter() + " " + Lengths.signed(axes.worldU(byU), view, locale) + "   "
                + axes.up().letter() + " " + Lengths.signed(axes.worldV(byV), view, locale);
    }

    @Override
    public void draw(GraphicsContext g) {
        g.setStroke(guideColor);
        g.setLineDashes(4, 4);
        if (!Double.isNaN(guideU)) {
            g.strokeLine(view.x(guideU), 0, view.x(guideU), view.height());
        }
        if (!Double.isNaN(guideV)) {
            g.strokeLine(0, view.y(guideV), view.width(), view.y(guideV));
        }
        g.setLineDashes();
    }
}
