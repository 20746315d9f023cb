package cz.paprsek.fx.view.look;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuItem;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import org.junit.jupiter.api.Test;

class ThemeTest {
    /** What is beside a menu in its window is the shadow, which is white where no window can be seen through. */
    @Test
    void aMenuFillsItsWindowWhereNothingCanBeSeenThrough() {
        StackPane pane = Gui.on(() -> new StackPane());
        try (Gui gui = Gui.show(() -> pane, 300, 200)) {
            assertThat(beside(gui, pane, true)).as("its shadow").isGreaterThan(4);
            assertThat(beside(gui, pane, false)).isZero();
        }
    }

    /** Pixels of a menu's window to the left and right of the menu. */
    private static double beside(Gui gui, StackPane pane, boolean isTransparent) {
        ContextMenu menu = Gui.on(() -> new ContextMenu(new MenuItem("here")));
        gui.act(() -> {
            Theme.DARK.applyTo(pane.getScene(), isTransparent);
            menu.show(pane, 20, 20);
        });
        gui.until("the menu is open", menu::isShowing);
        gui.pulse();
        double beside = Gui.on(() -> menu.getWidth() - ((Region) menu.getSkin().getNode()).getWidth());
        gui.act(menu::hide);
        return beside;
    }
}
