package cz.paprsek.fx.view.projection;

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

    /** Draws what helps meanwhile. */
    default void draw(GraphicsContext g) {}
}
