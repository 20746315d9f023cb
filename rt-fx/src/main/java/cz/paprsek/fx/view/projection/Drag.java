package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.Gesture;
import java.util.Locale;
import javafx.scene.canvas.GraphicsContext;

/** What a pressed mouse button does until it is released. */
interface Drag {
    /**
     * Keys held meanwhile.
     *
     * @param free Ctrl: no snapping
     * @param straight Shift: along one axis only, or alike in both
     */
    record Keys(boolean free, boolean straight) {}

    /** The mouse is at a point of the pane, pixels. */
    void to(double x, double y, Keys keys);

    /** The button is released. */
    void end();

    /** Escape: all as it was before. */
    void cancel();

    /** How far or how large by now, in words; empty for nothing to say. */
    default String figures(Locale locale) {
        return "";
    }

    /** Draws what helps meanwhile. */
    default void draw(GraphicsContext g) {}

    /** One that changes the scene: what it does is seen meanwhile, kept at the end, and taken back by Escape. */
    abstract class Changing implements Drag {
        final Gesture gesture;
        final Axes axes;
        final Viewport view;
        private final boolean snaps;
        private final double startX;
        private final double startY;

        Changing(Gesture gesture, Axes axes, Viewport view, boolean snaps, double startX, double startY) {
            this.gesture = gesture;
            this.axes = axes;
            this.view = view;
            this.snaps = snaps;
            this.startX = startX;
            this.startY = startY;
        }

        /** How far the mouse is from where it was pressed, to the right, in scene units. */
        final double byU(double x) {
            return (x - startX) / view.scale();
        }

        /** Likewise upwards. */
        final double byV(double y) {
            return (startY - y) / view.scale();
        }

        final boolean snaps(Keys keys) {
            return snaps && !keys.free();
        }

        @Override
        public final void end() {
            gesture.commit();
        }

        @Override
        public final void cancel() {
            gesture.cancel();
        }
    }
}
