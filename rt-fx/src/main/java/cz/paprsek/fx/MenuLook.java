package cz.paprsek.fx;

import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;

/**
 * Has a menu look as it will before JavaFX measures it: it finds the place of one that opens for the first time with the sizes of the theme alone, and moves one that
 * would be too high with these upwards, over the bar.
 */
final class MenuLook {
    private MenuLook() {}

    static void beforeOpening(Menu menu, MenuBar bar) {
        ContextMenu popup = menu.getItems().isEmpty() ? null : menu.getItems().get(0).getParentPopup();
        if (popup == null || popup.isShowing()) {
            return;
        }
        Scene scene = popup.getScene();
        scene.getStylesheets().setAll(bar.getScene().getStylesheets());
        for (Parent node = bar; node != null; node = node.getParent()) {
            scene.getStylesheets().addAll(node.getStylesheets());
        }
        scene.getRoot().applyCss();
    }
}
