package cz.paprsek.fx.view.shell;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.edit.Adding;
import cz.paprsek.fx.model.edit.Examples;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.look.Icons;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.height.HeightField;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.css.PseudoClass;
import javafx.scene.control.Button;
import javafx.scene.control.MenuItem;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.FlowPane;
import org.kordamp.ikonli.javafx.FontIcon;

/**
 * Buttons and menu items that add every kind of object and lights, and that make one solid of several. By keyboard the buttons are one stop:
 * arrows walk among them, Enter or the space bar presses. A click leaves the keyboard where it is.
 */
public final class AddPalette extends FlowPane {
    private static final PseudoClass CURRENT = PseudoClass.getPseudoClass("current");

    /** A row of both: its name in ids, its text, its icon, when it makes sense, what it does. */
    private record Entry(String id, String text, String icon, BooleanBinding possible, Runnable action) {}

    private final List<Entry> adding = new ArrayList<>();
    private final List<Entry> combining = new ArrayList<>();
    private int current;

    /**
     * @param sight where new things are put, and how large: where the user looks
     * @param mesh asks for a file of triangles, and adds it
     * @param heights asks for a picture, and adds it as relief
     */
    public AddPalette(EditorModel model, Texts texts, Supplier<Sight> sight, Edits edits, Consumer<Sight> mesh, Consumer<Sight> heights) {
        setId("add-palette");
        getStyleClass().add("add-palette");
        getStylesheets().add(Objects.requireNonNull(AddPalette.class.getResource("palette.css")).toExternalForm());
        BooleanBinding always = Bindings.createBooleanBinding(() -> true);
        for (Shape kind : Examples.ofSize(1)) {
            adding.add(new Entry("add-" + kind.kind(), texts.kind(kind), Icons.of(kind), always, () -> {
                Sight now = sight.get();
                Examples.ofSize(now.size()).stream().filter(example -> example.getClass() == kind.getClass()).findFirst()
                        .ifPresent(example -> edits.add(example, now));
            }));
        }
        Mesh unread = Mesh.of("mesh");
        adding.add(new Entry("add-mesh", texts.of("palette.mesh", texts.kind(unread)), Icons.of(unread), always, () -> mesh.accept(sight.get())));
        HeightField relief = HeightField.of("picture", Vec3.ONE);
        adding.add(new Entry("add-height-field", texts.of("palette.height-field", texts.kind(relief)), Icons.of(relief), always, () -> heights.accept(sight.get())));
        for (Light kind : Adding.LIGHTS) {
            adding.add(new Entry("add-" + kind.kind(), texts.kind(kind), Icons.of(kind), always, () -> edits.add(kind, sight.get())));
        }
        BooleanBinding several = when(model, items -> Places.outermost(items).size() > 1);
        for (Csg.Operation operation : Csg.Operation.values()) {
            String word = operation.name().toLowerCase(Locale.ROOT);
            combining.add(new Entry("combine-" + word, texts.of("object." + word), Icons.of(word), several, () -> edits.combine(operation)));
        }
        BooleanBinding any = when(model, items -> !Places.bodies(items).isEmpty());
        combining.add(new Entry("dissolve", texts.of("object.dissolve"), Icons.DISSOLVE, any, edits::dissolve));
        adding.forEach(entry -> getChildren().add(button(entry, texts.of("palette.add", entry.text()))));
        combining.forEach(entry -> getChildren().add(button(entry, entry.text())));
        setFocusTraversable(true);
        addEventHandler(KeyEvent.KEY_PRESSED, this::pressed);
        focusedProperty().addListener((property, was, is) -> walk(0));
    }

    /** What is added, as a menu; what combines stands in the menu of objects. */
    public List<MenuItem> menuItems() {
        return adding.stream().map(AddPalette::menuItem).toList();
    }

    private void pressed(KeyEvent event) {
        if (event.isShortcutDown() || event.isAltDown()) {
            return;
        }
        switch (event.getCode()) {
            case LEFT -> walk(-1);
            case RIGHT -> walk(1);
            case UP -> walk(-perRow());
            case DOWN -> walk(perRow());
            case HOME -> walk(-getChildren().size());
            case END -> walk(getChildren().size());
            case ENTER, SPACE -> button(current).fire();
            default -> {
                return;
            }
        }
        event.consume();
    }

    /** Goes some buttons further, but not beyond the first and the last. */
    private void walk(int by) {
        current = Math.max(0, Math.min(getChildren().size() - 1, current + by));
        for (int i = 0; i < getChildren().size(); i++) {
            button(i).pseudoClassStateChanged(CURRENT, isFocused() && i == current);
        }
        setAccessibleText(button(current).getAccessibleText());
    }

    private int perRow() {
        double top = getChildren().get(0).getLayoutY();
        return (int) getChildren().stream().filter(button -> button.getLayoutY() == top).count();
    }

    private Button button(int index) {
        return (Button) getChildren().get(index);
    }

    private static BooleanBinding when(EditorModel model, Predicate<Set<ScenePath>> condition) {
        return Bindings.createBooleanBinding(() -> condition.test(model.selection()), model.selectionProperty());
    }

    private static Button button(Entry entry, String text) {
        Button button = new Button("", new FontIcon(entry.icon()));
        button.setId(entry.id());
        button.setAccessibleText(text);
        button.setTooltip(new Tooltip(text));
        button.getStyleClass().add("palette-button");
        button.disableProperty().bind(entry.possible().not());
        button.setFocusTraversable(false);
        button.setOnAction(event -> entry.action().run());
        return button;
    }

    private static MenuItem menuItem(Entry entry) {
        String text = entry.text().substring(0, 1).toUpperCase(Locale.ROOT) + entry.text().substring(1);
        MenuItem item = new MenuItem(text, new FontIcon(entry.icon()));
        item.setId("menu-" + entry.id());
        item.disableProperty().bind(entry.possible().not());
        item.setOnAction(event -> entry.action().run());
        return item;
    }
}
