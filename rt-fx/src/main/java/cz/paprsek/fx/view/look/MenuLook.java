package cz.paprsek.fx.view.look;

import java.util.ArrayList;
import java.util.List;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;

/**
 * Has a menu look as it will before JavaFX measures it: it finds the place of one that opens for the first time with the sizes of the theme alone, and moves one that
 * would be too high with these upwards, over the bar.
 */
public final class MenuLook {
    private MenuLook() {}

    /** To be called each time before a menu of a bar is shown. */
    public static void beforeOpening(Menu menu, MenuBar bar) {
        ContextMenu popup = menu.getItems().isEmpty() ? null : menu.getItems().get(0).getParentPopup();
        if (popup == null || popup.isShowing()) {
            return;
        }
        Scene scene = popup.getScene();
        List<String> sheets = new ArrayList<>(bar.getScene().getStylesheets());
        for (Parent node = bar; node != null; node = node.getParent()) {
            sheets.addAll(node.getStylesheets());
        }
        // All would be styled anew.
        if (!scene.getStylesheets().equals(sheets)) {
            scene.getStylesheets().setAll(sheets);
        }
        scene.getRoot().applyCss();
    }
}
