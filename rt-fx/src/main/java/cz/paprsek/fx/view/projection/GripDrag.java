package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.edit.Rounds;
import cz.paprsek.fx.view.projection.Grips.Grip;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import java.util.Locale;

/** Pulls what a light or camera is grabbed by. */
final class GripDrag extends Drag.Changing {
    /** Angles of a hand are of this coarseness, so that they can be read; and with Ctrl held. */
    private static final double DEGREES = 0.5;
    private static final double FINE_DEGREES = 0.1;
    /** Steps of a free hand in one of the grid: less than a pixel each. */
    private static final double FINE = 20;

    private final Grip grip;
    private final Texts texts;
    private String figures = "";

    GripDrag(Gesture gesture, Grip grip, Axes axes, Viewport view, Texts texts, boolean snaps, double startX, double startY) {
        super(gesture, axes, view, snaps, startX, startY);
        this.grip = grip;
        this.texts = texts;
    }

    @Override
    public void to(double x, double y, Keys keys) {
        double byU = byU(x);
        double byV = byV(y);
        boolean snap = snaps(keys);
        double step = Rounds.step(view.scale());
        if (grip instanceof Grip.Dial dial) {
            double value = dial.at(dial.place().plus(axes.vector(byU, byV)), dial.isAngle() ? keys.free() ? FINE_DEGREES : DEGREES : snap ? step : step / FINE);
            gesture.preview(scene -> dial.changed().apply(scene, value));
            figures = texts.of(dial.text(), dial.isAngle() ? String.format(texts.locale(), "%.1f°", value) : view.text(value, texts.locale()));
        } else if (grip instanceof Grip.Count count) {
            int many = count.at(axes.vector(byU, byV));
            gesture.preview(scene -> count.changed().apply(scene, many));
            figures = texts.of("figure.count", many);
        } else if (grip instanceof Grip.Aim aim) {
            double u = axes.u(aim.place());
            double v = axes.v(aim.place());
            Vec3 point = aim.place().plus(axes.vector(snap ? Rounds.toGrid(u + byU, step) - u : byU, snap ? Rounds.toGrid(v + byV, step) - v : byV));
            // Looking along an up of its own, or at itself, a camera has no view, which is refused: the last one stays until the mouse has moved on.
            gesture.preview(scene -> aim.turned().apply(scene, point));
        }
    }

    @Override
    public String figures(Locale locale) {
        return figures;
    }
}
