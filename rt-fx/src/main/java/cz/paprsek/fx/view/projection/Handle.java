package cz.paprsek.fx.view.projection;

import java.util.List;
import java.util.Optional;
import javafx.scene.Cursor;

/** What is grabbed to resize or turn the selection: four corners, four sides, and one above for turning. */
enum Handle {
    TOP_LEFT(-1, 1, Cursor.NW_RESIZE), TOP(0, 1, Cursor.N_RESIZE), TOP_RIGHT(1, 1, Cursor.NE_RESIZE), RIGHT(1, 0, Cursor.E_RESIZE),
    BOTTOM_RIGHT(1, -1, Cursor.SE_RESIZE), BOTTOM(0, -1, Cursor.S_RESIZE), BOTTOM_LEFT(-1, -1, Cursor.SW_RESIZE),
    LEFT(-1, 0, Cursor.W_RESIZE), TURN(0, 1, Cursor.HAND);

    /** Between the selection and its handles, pixels. */
    private static final double AIR = 7;
    /** From the top to the handle for turning, pixels. */
    private static final double STALK = 20;
    /** How near the mouse must come, pixels. */
    private static final double REACH = 6;

    private final int alongU;
    private final int alongV;
    private final String cursor;

    Handle(int alongU, int alongV, Cursor cursor) {
        this.alongU = alongU;
        this.alongV = alongV;
        this.cursor = cursor.toString();
    }

    /** −1, 0 or 1: which side of the box it moves. */
    int alongU() {
        return alongU;
    }

    /** −1, 0 or 1: which side of the box it moves. */
    int alongV() {
        return alongV;
    }

    Cursor cursor() {
        return Cursor.cursor(cursor);
    }

    double x(Viewport view, Box box) {
        return (view.x(box.minU()) + view.x(box.maxU())) / 2 + alongU * ((view.x(box.maxU()) - view.x(box.minU())) / 2 + AIR);
    }

    double y(Viewport view, Box box) {
        double middle = (view.y(box.minV()) + view.y(box.maxV())) / 2 - alongV * ((view.y(box.minV()) - view.y(box.maxV())) / 2 + AIR);
        return this == TURN ? middle - STALK : middle;
    }

    /** The handle of a selection's box at a point of the pane. */
    static Optional<Handle> at(Viewport view, Box box, double x, double y) {
        return box.isEmpty() ? Optional.empty()
                : List.of(values()).stream().filter(h -> Math.max(Math.abs(h.x(view, box) - x), Math.abs(h.y(view, box) - y)) <= REACH).findFirst();
    }
}
