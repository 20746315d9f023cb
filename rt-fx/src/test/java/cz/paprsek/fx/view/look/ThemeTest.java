package cz.paprsek.fx.view.look;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.view.dialog.ColorBox;
import cz.paprsek.fx.view.texts.Texts;
import java.util.List;
import java.util.Locale;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuItem;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.paint.Color;
import javafx.stage.PopupWindow;
import javafx.stage.Window;
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

    @Test
    void thePaletteOfColoursDoesSo() {
        ColorBox box = Gui.on(() -> new ColorBox(Texts.in(Locale.ENGLISH)));
        try (Gui gui = Gui.show(() -> new StackPane(box), 300, 200)) {
            gui.act(() -> Theme.DARK.applyTo(box.getScene(), false));
            gui.act(() -> {
                box.setValue(Color.rgb(240, 236, 226));
                box.show();
            });
            gui.pulse();
            assertThat(Gui.on(() -> List.copyOf(Window.getWindows()).stream().filter(PopupWindow.class::isInstance)
                    .mapToDouble(window -> window.getWidth() - ((Region) window.getScene().lookup(".color-palette")).getWidth()).sum())).isZero();
            gui.act(box::hide);
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
