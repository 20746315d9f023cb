package cz.paprsek.fx.view.tree;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.item.Bodies;
import cz.paprsek.fx.model.item.Item;
import cz.paprsek.fx.model.item.Items;
import cz.paprsek.fx.view.command.Commands;
import cz.paprsek.fx.view.look.Icons;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.shape.Csg;
import java.util.Locale;
import java.util.Set;
import javafx.scene.Node;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import org.kordamp.ikonli.javafx.FontIcon;

/** What can be done with what is selected. */
final class TreeMenu {
    private final ContextMenu menu = new ContextMenu();

    TreeMenu(EditorModel model, Texts texts, Commands commands, TreeState state) {
        Set<Item> items = model.selection();
        boolean hidden = !items.isEmpty() && model.state().hidden().containsAll(items);
        boolean locked = !items.isEmpty() && model.state().locked().containsAll(items);
        boolean any = !items.isEmpty();
        boolean movable = !Items.bodies(items).isEmpty() || !Items.lights(items).isEmpty();
        int bodies = Items.outermost(items).size();
        boolean operation = Items.bodies(items).stream()
                .anyMatch(at -> Bodies.find(model.scene(), at).filter(body -> body.shape() instanceof Csg).isPresent());
        add("menu-rename", texts.of("menu.rename"), "mdi2f-form-textbox", items.size() == 1 && movable,
                () -> items.forEach(state::rename));
        add("menu-duplicate", texts.of("menu.duplicate"), "mdi2c-content-duplicate", movable, commands::duplicate);
        add("menu-delete", texts.of("menu.delete"), "mdi2d-delete-outline", movable, commands::delete);
        menu.getItems().add(new SeparatorMenuItem());
        add("menu-hide", texts.of(hidden ? "menu.show" : "menu.hide"), hidden ? "mdi2e-eye-outline" : "mdi2e-eye-off-outline", any,
                () -> commands.hide(items, !hidden));
        add("menu-lock", texts.of(locked ? "menu.unlock" : "menu.lock"),
                locked ? "mdi2l-lock-open-variant-outline" : "mdi2l-lock-outline", any, () -> commands.lock(items, !locked));
        menu.getItems().add(new SeparatorMenuItem());
        for (Csg.Operation kind : Csg.Operation.values()) {
            String word = kind.name().toLowerCase(Locale.ROOT);
            add("menu-" + word, texts.of("combine." + word), Icons.of(word), bodies > 1, () -> commands.combine(kind));
        }
        add("menu-dissolve", texts.of("menu.dissolve"), Icons.DISSOLVE, operation, commands::dissolve);
    }

    void show(Node owner, double screenX, double screenY) {
        menu.setAutoHide(true);
        menu.show(owner, screenX, screenY);
    }

    private void add(String id, String text, String icon, boolean possible, Runnable action) {
        MenuItem item = new MenuItem(text, new FontIcon(icon));
        item.setId(id);
        item.setDisable(!possible);
        item.setOnAction(event -> action.run());
        menu.getItems().add(item);
    }
}
