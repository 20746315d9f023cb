package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.scene.ScenePath;
import java.util.Locale;
import java.util.Set;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** Moves items in the plane of the projection. */
final class MoveDrag extends Drag.Changing {
    private final Set<ScenePath> items;
    private final Box box;
    private final double referenceU;
    private final double referenceV;
    private final Snapping snapping;
    private final Color guideColor;
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
        super(gesture, axes, view, snaps, startX, startY);
        this.items = items;
        this.box = box;
        this.referenceU = reference.minU();
        this.referenceV = reference.minV();
        this.snapping = snapping;
        this.guideColor = guideColor;
    }

    @Override
    public void to(double x, double y, Keys keys) {
        double du = byU(x);
        double dv = byV(y);
        boolean onlyV = keys.straight() && Math.abs(du) < Math.abs(dv);
        boolean onlyU = keys.straight() && !onlyV;
        guideU = Double.NaN;
        guideV = Double.NaN;
        if (snaps(keys)) {
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
    public String figures(Locale locale) {
        return axes.right().letter() + " " + view.signed(axes.worldU(byU), locale) + "   "
                + axes.up().letter() + " " + view.signed(axes.worldV(byV), locale);
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
