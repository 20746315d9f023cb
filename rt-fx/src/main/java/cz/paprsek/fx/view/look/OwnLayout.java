package cz.paprsek.fx.view.look;

import javafx.scene.Parent;

/** Of what is laid out anew by itself, since its size stays: without all that is around. */
public final class OwnLayout {
    private OwnLayout() {}

    /** Whether JavaFX finds its way to it: it stops below what has been asked for a layout in the middle of one around it, and is not laid out before it is asked as a whole. */
    public static boolean suffices(Parent node) {
        Parent around = node.getParent();
        while (around != null && !around.isNeedsLayout()) {
            around = around.getParent();
        }
        return around == null;
    }
}
