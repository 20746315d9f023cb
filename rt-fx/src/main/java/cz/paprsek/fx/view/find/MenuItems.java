package cz.paprsek.fx.view.find;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import javafx.event.Event;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.SeparatorMenuItem;

/** All that stands in menus, as things that are found by their names. */
public final class MenuItems {
    private MenuItems() {}

    public static List<Findable> of(List<Menu> menus) {
        List<Findable> found = new ArrayList<>();
        menus.forEach(menu -> collect(menu, name(menu), found));
        return found;
    }

    private static void collect(Menu menu, String where, List<Findable> found) {
        // Some are filled only when they are opened.
        Event.fireEvent(menu, new Event(Menu.ON_SHOWING));
        for (MenuItem item : menu.getItems()) {
            if (item instanceof Menu below) {
                collect(below, where + " › " + name(below), found);
            } else if (!(item instanceof SeparatorMenuItem) && !name(item).isEmpty()) {
                String keys = item.getAccelerator() == null ? "" : item.getAccelerator().getDisplayText();
                found.add(new Findable(name(item), where, keys, !item.isDisable(), () -> choose(item)));
            }
        }
    }

    /** As a click does it. */
    private static void choose(MenuItem item) {
        if (item instanceof CheckMenuItem check) {
            check.setSelected(!check.isSelected());
        } else if (item instanceof RadioMenuItem radio) {
            radio.setSelected(true);
        }
        item.fire();
    }

    private static String name(MenuItem item) {
        String text = Objects.requireNonNullElse(item.getText(), "");
        return item.isMnemonicParsing() ? text.replaceFirst("_", "") : text;
    }
}
