package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.ScenePath;
import java.util.Locale;
import java.util.Set;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** Turns items about the axis that points at the viewer, through a pivot. */
final class TurnDrag extends Drag.Placing {
    private static final double SNAP_DEGREES = 15;
    /** Angles of a free hand are of this coarseness, so that they can be read. */
    private static final double FREE_DEGREES = 0.5;

    private final Vec3 pivot;
    private final Color color;
    private final double startAngle;
    private double degrees;
    private double mouseX;
    private double mouseY;

    TurnDrag(Gesture gesture, Set<ScenePath> items, Axes axes, Viewport view, Vec3 pivot, boolean snaps, Color color, double startX, double startY) {
        super(gesture, items, axes, view, snaps, startX, startY);
        this.pivot = pivot;
        this.color = color;
        this.startAngle = angle(startX, startY);
        this.mouseX = startX;
        this.mouseY = startY;
    }

    @Override
    public void to(double x, double y, Keys keys) {
        mouseX = x;
        mouseY = y;
        double grain = snaps(keys) ? SNAP_DEGREES : FREE_DEGREES;
        double turned = Math.toDegrees(angle(x, y) - startAngle);
        degrees = Math.IEEEremainder(Math.rint(turned / grain) * grain, 360);
        preview((scene, placed) -> degrees == 0 ? scene : Moves.rotated(scene, placed, pivot, axes.rotation(degrees)));
    }

    private double angle(double x, double y) {
        return Math.atan2(view.y(axes.v(pivot)) - y, x - view.x(axes.u(pivot)));
    }

    @Override
    public String figures(Locale locale) {
        return String.format(locale, "%.1f°", degrees + 0.0);
    }

    @Override
    public void draw(GraphicsContext g) {
        g.setStroke(color);
        g.strokeLine(view.x(axes.u(pivot)), view.y(axes.v(pivot)), mouseX, mouseY);
    }
}
