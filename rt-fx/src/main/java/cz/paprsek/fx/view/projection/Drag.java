package cz.paprsek.fx.view.projection;

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
}
