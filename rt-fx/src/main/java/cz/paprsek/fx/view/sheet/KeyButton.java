package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.model.motion.Keys;
import cz.paprsek.fx.model.motion.Keys.KeyAt;
import cz.paprsek.fx.model.property.Keyed;
import cz.paprsek.fx.model.property.Property;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Scene;
import cz.paprsek.text.Numbers;
import java.util.Optional;
import java.util.OptionalInt;
import javafx.css.PseudoClass;
import javafx.event.ActionEvent;
import javafx.scene.control.Button;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.TextField;
import javafx.scene.control.Tooltip;
import javafx.scene.input.ContextMenuEvent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignR;

/** Sets a key of an attribute from its row: by a diamond while the timeline is there, which is coloured if the attribute has keys, and full if it has one at the time; by Alt+K; and by the menu of the row. */
final class KeyButton {
    private static final PseudoClass ANIMATED = PseudoClass.getPseudoClass("animated");

    private final Clock clock;
    private final Texts texts;
    private final Property property;
    private final PropertyEdit edit;
    private final SheetRow row;
    private final Button button = new Button();
    private final FontIcon icon = new FontIcon(MaterialDesignR.RHOMBUS_OUTLINE);
    private Optional<Keyed> keyed = Optional.empty();
    private Optional<Object> knownAt = Optional.empty();

    KeyButton(Clock clock, Texts texts, Property property, PropertyEdit edit, SheetRow row) {
        this.clock = clock;
        this.texts = texts;
        this.property = property;
        this.edit = edit;
        this.row = row;
        button.setId(String.join("-", property.path()) + "-key");
        button.setGraphic(icon);
        button.getStyleClass().addAll("small-button", "key-button");
        button.setTooltip(new Tooltip());
        // Whoever types goes on typing.
        button.setFocusTraversable(false);
        button.setOnAction(event -> set());
        row.addEventFilter(KeyEvent.KEY_PRESSED, this::pressed);
        row.addEventHandler(ContextMenuEvent.CONTEXT_MENU_REQUESTED, this::menu);
        row.mark(button);
    }

    private void pressed(KeyEvent event) {
        if (event.getCode() == KeyCode.K && event.isAltDown() && !event.isShortcutDown() && !event.isShiftDown()) {
            set();
            event.consume();
        }
    }

    /** Shows whether there can be a key, and whether there is. */
    void show(Scene scene) {
        boolean isThere = clock.openProperty().get() && keyed(scene).isPresent();
        button.setVisible(isThere);
        button.setManaged(isThere);
        if (isThere) {
            icon.setIconCode(key(scene).isPresent() ? MaterialDesignR.RHOMBUS : MaterialDesignR.RHOMBUS_OUTLINE);
            button.pseudoClassStateChanged(ANIMATED, animation(scene).isPresent());
            String text = text("sheet.key");
            button.getTooltip().setText(text + " (Alt+K)");
            button.setAccessibleText(text);
        }
    }

    /** What the property is of may become another thing: that of a name. */
    private Optional<Keyed> keyed(Scene scene) {
        Optional<Object> now = Optional.of(property.target().spot(scene));
        if (!now.equals(knownAt)) {
            knownAt = now;
            keyed = Keyed.of(property, scene);
        }
        return keyed.filter(one -> animation(scene).stream().allMatch(at -> scene.animations().get(at).path().isBlank()));
    }

    private OptionalInt animation(Scene scene) {
        return keyed.map(one -> Keys.of(scene, one.place(), one.attribute())).orElse(OptionalInt.empty());
    }

    private Optional<KeyAt> key(Scene scene) {
        OptionalInt animation = animation(scene);
        return animation.isEmpty() ? Optional.empty() : Keys.at(scene, animation.getAsInt(), clock.keyTime());
    }

    private String text(String key) {
        return texts.of(key, texts.number(Numbers.text(Math.rint(clock.keyTime() * 1000) / 1000)));
    }

    private void menu(ContextMenuEvent event) {
        if (keyed(edit.scene()).isEmpty()) {
            return;
        }
        MenuItem set = new MenuItem(text("sheet.key"), new FontIcon(MaterialDesignR.RHOMBUS));
        set.setId("sheet-key-set");
        set.setOnAction(chosen -> set());
        MenuItem remove = new MenuItem(text("sheet.key-remove"), new FontIcon(MaterialDesignR.RHOMBUS_OUTLINE));
        remove.setId("sheet-key-remove");
        remove.setDisable(key(edit.scene()).isEmpty());
        remove.setOnAction(chosen -> edit.change(scene -> key(scene).map(at -> Keys.removed(scene, at)).orElse(scene)));
        new ContextMenu(set, remove).show(row, event.getScreenX(), event.getScreenY());
        event.consume();
    }

    /** With the value of the field, also if that has just been typed. */
    private void set() {
        double time = clock.keyTime();
        boolean isLookedAt = clock.secondsProperty().get().isPresent();
        if (row.getScene() != null && row.getScene().getFocusOwner() instanceof TextField field && row.holds(field)) {
            field.fireEvent(new ActionEvent());
        }
        if (keyed(edit.scene()).isEmpty() || row.isRefused()) {
            return;
        }
        Keyed one = keyed.orElseThrow();
        boolean isSet = edit.change(scene -> Keys.added(scene, one.place(), one.attribute(), time, one.value(scene).orElseThrow()));
        if (isSet && (isLookedAt || time > 0)) {
            clock.look(time);
        }
    }
}
