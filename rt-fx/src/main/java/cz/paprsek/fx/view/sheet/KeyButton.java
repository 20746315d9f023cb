package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.model.motion.Keys;
import cz.paprsek.fx.model.motion.Keys.KeyAt;
import cz.paprsek.fx.model.property.Keyed;
import cz.paprsek.fx.model.property.Property;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe.Parameter;
import cz.paprsek.text.Numbers;
import java.util.Optional;
import java.util.OptionalInt;
import javafx.css.PseudoClass;
import javafx.event.ActionEvent;
import javafx.scene.control.Button;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.TextField;
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
    private final Subject subject;
    private final PropertyEdit edit;
    private final SheetRow row;
    private final Button button = new Button();
    private final FontIcon icon = new FontIcon(MaterialDesignR.RHOMBUS_OUTLINE);

    /** What gets keys. */
    private interface Subject {
        /** Whether it can have any. */
        boolean isKeyed(Scene scene);

        /** The index of its animation. */
        OptionalInt animation(Scene scene);

        /** With a key that has its value as it is written. */
        Scene added(Scene scene, double time);
    }

    /** A property. */
    private static final class OfProperty implements Subject {
        private final Property property;
        private Optional<Keyed> keyed = Optional.empty();
        private Optional<Object> knownAt = Optional.empty();

        OfProperty(Property property) {
            this.property = property;
        }

        @Override
        public boolean isKeyed(Scene scene) {
            // What it is of may become another thing: that of a name.
            Optional<Object> now = Optional.of(property.target().spot(scene));
            if (!now.equals(knownAt)) {
                knownAt = now;
                keyed = Keyed.of(property, scene);
            }
            return keyed.isPresent();
        }

        @Override
        public OptionalInt animation(Scene scene) {
            return keyed.map(one -> Keys.of(scene, one.place(), one.attribute())).orElse(OptionalInt.empty());
        }

        @Override
        public Scene added(Scene scene, double time) {
            Keyed one = keyed.orElseThrow();
            return Keys.added(scene, one.place(), one.attribute(), time, one.value(scene).orElseThrow());
        }
    }

    /** A parameter, by its name. */
    private record OfParameter(String name) implements Subject {
        private Optional<Parameter> in(Scene scene) {
            return scene.recipe().parameters().stream().filter(one -> one.name().equals(name) && one.number().isPresent()).findFirst();
        }

        @Override
        public boolean isKeyed(Scene scene) {
            return in(scene).isPresent();
        }

        @Override
        public OptionalInt animation(Scene scene) {
            return Keys.of(scene, name);
        }

        @Override
        public Scene added(Scene scene, double time) {
            return Keys.added(scene, name, time, in(scene).orElseThrow().value());
        }
    }

    static KeyButton of(Property property, Clock clock, Texts texts, PropertyEdit edit, SheetRow row) {
        return new KeyButton(clock, texts, new OfProperty(property), String.join("-", property.path()), edit, row);
    }

    static KeyButton ofParameter(String name, Clock clock, Texts texts, PropertyEdit edit, SheetRow row) {
        return new KeyButton(clock, texts, new OfParameter(name), "parameter-" + name, edit, row);
    }

    private KeyButton(Clock clock, Texts texts, Subject subject, String id, PropertyEdit edit, SheetRow row) {
        this.clock = clock;
        this.texts = texts;
        this.subject = subject;
        this.edit = edit;
        this.row = row;
        button.setId(id + "-key");
        button.setGraphic(icon);
        button.getStyleClass().addAll("small-button", "key-button");
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
        boolean isThere = clock.openProperty().get() && isKeyed(scene);
        button.setVisible(isThere);
        button.setManaged(isThere);
        if (isThere) {
            icon.setIconCode(key(scene).isPresent() ? MaterialDesignR.RHOMBUS : MaterialDesignR.RHOMBUS_OUTLINE);
            button.pseudoClassStateChanged(ANIMATED, subject.animation(scene).isPresent());
            String text = text("sheet.key");
            Hint.of(button).set(text + " (Alt+K)");
            button.setAccessibleText(text);
        }
    }

    /** Not of what goes along a curve, whose keys are shares of that. */
    private boolean isKeyed(Scene scene) {
        return subject.isKeyed(scene) && subject.animation(scene).stream().allMatch(at -> scene.animations().get(at).path().isBlank());
    }

    private Optional<KeyAt> key(Scene scene) {
        OptionalInt animation = subject.animation(scene);
        return animation.isEmpty() ? Optional.empty() : Keys.at(scene, animation.getAsInt(), clock.keyTime());
    }

    private String text(String key) {
        return texts.of(key, texts.number(Numbers.text(Math.rint(clock.keyTime() * 1000) / 1000)));
    }

    private void menu(ContextMenuEvent event) {
        if (!isKeyed(edit.scene())) {
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
        if (!isKeyed(edit.scene()) || row.isRefused()) {
            return;
        }
        boolean isSet = edit.change(scene -> subject.added(scene, time));
        if (isSet && (isLookedAt || time > 0)) {
            clock.look(time);
        }
    }
}
