package cz.paprsek.fx.view.shell;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.contact.Dropping;
import cz.paprsek.fx.model.edit.Adding;
import cz.paprsek.fx.model.edit.Examples;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.look.Hint;
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
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javafx.application.Platform;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.MenuItem;
import javafx.scene.input.ClipboardContent;
import javafx.scene.input.DataFormat;
import javafx.scene.input.DragEvent;
import javafx.scene.input.Dragboard;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.TransferMode;
import javafx.scene.layout.FlowPane;
import org.kordamp.ikonli.javafx.FontIcon;

/**
 * Buttons and menu items that add every kind of object and lights, and that make one solid of several. By keyboard the buttons are one stop:
 * arrows walk among them, Enter or the space bar presses. A click leaves the keyboard where it is. What is added can be dragged into a view.
 */
public final class AddPalette extends FlowPane {
    private static final PseudoClass CURRENT = PseudoClass.getPseudoClass("current");

    /** What is dragged, by the id of its button. */
    private static final DataFormat DRAGGED = new DataFormat("application/x-paprsek-kind");

    /** A row of both: its name in ids, its text, its icon, when it makes sense, what it does, and what it does where it is dropped. */
    private record Entry(String id, String text, String icon, BooleanBinding possible, Runnable action, Consumer<Place> put) {}

    /**
     * Where something is dropped.
     *
     * @param sight the point, and how large it is to be there
     * @param side the normal of the surface that it is put on, of length 1; 0 if the point is its middle
     */
    public record Place(Sight sight, Vec3 side) {}

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
            }, at -> Examples.ofSize(at.sight().size()).stream().filter(example -> example.getClass() == kind.getClass()).findFirst()
                    .ifPresent(example -> put(edits, example, texts.kind(example), at))));
        }
        Mesh unread = Mesh.of("mesh");
        adding.add(new Entry("add-mesh", texts.of("palette.mesh", texts.kind(unread)), Icons.of(unread), always, () -> mesh.accept(sight.get()), at -> mesh.accept(at.sight())));
        HeightField relief = HeightField.of("picture", Vec3.ONE);
        adding.add(new Entry("add-height-field", texts.of("palette.height-field", texts.kind(relief)), Icons.of(relief), always, () -> heights.accept(sight.get()), at -> heights.accept(at.sight())));
        for (Light kind : Adding.LIGHTS) {
            adding.add(new Entry("add-" + kind.kind(), texts.kind(kind), Icons.of(kind), always, () -> edits.add(kind, sight.get()), at -> put(edits, kind, texts.kind(kind), at)));
        }
        BooleanBinding several = when(model, items -> Places.outermost(items).size() > 1);
        for (Csg.Operation operation : Csg.Operation.values()) {
            String word = operation.name().toLowerCase(Locale.ROOT);
            combining.add(new Entry("combine-" + word, texts.of("object." + word), Icons.of(word), several, () -> edits.combine(operation), at -> {}));
        }
        BooleanBinding any = when(model, items -> !Places.bodies(items).isEmpty());
        combining.add(new Entry("dissolve", texts.of("object.dissolve"), Icons.DISSOLVE, any, edits::dissolve, at -> {}));
        adding.forEach(entry -> getChildren().add(draggable(entry, button(entry, texts.of("palette.add", entry.text())))));
        combining.forEach(entry -> getChildren().add(button(entry, entry.text())));
        setFocusTraversable(true);
        addEventHandler(KeyEvent.KEY_PRESSED, this::pressed);
        focusedProperty().addListener((property, was, is) -> walk(0));
    }

    /** What is added, as a menu; what combines stands in the menu of objects. */
    public List<MenuItem> menuItems() {
        return adding.stream().map(AddPalette::menuItem).toList();
    }

    /**
     * Takes what is dragged out of the palette over a view.
     *
     * @param place where that is at the mouse
     */
    public void dropOn(Node view, Function<DragEvent, Place> place) {
        view.addEventHandler(DragEvent.DRAG_OVER, event -> {
            if (dragged(event).isPresent()) {
                event.acceptTransferModes(TransferMode.COPY);
                event.consume();
            }
        });
        view.addEventHandler(DragEvent.DRAG_DROPPED, event -> dragged(event).ifPresent(entry -> {
            Place at = place.apply(event);
            // What asks for a file is not to hold up the end of the drag.
            Platform.runLater(() -> entry.put().accept(at));
            event.setDropCompleted(true);
            event.consume();
        }));
    }

    private Optional<Entry> dragged(DragEvent event) {
        return event.getDragboard().hasContent(DRAGGED) ? entry(String.valueOf(event.getDragboard().getContent(DRAGGED))) : Optional.empty();
    }

    private Optional<Entry> entry(String id) {
        return adding.stream().filter(entry -> entry.id().equals(id)).findFirst();
    }

    /** Puts what a button adds somewhere, as a drag does. */
    void put(String id, Place at) {
        entry(id).ifPresent(entry -> entry.put().accept(at));
    }

    private static Button draggable(Entry entry, Button button) {
        button.setOnDragDetected(event -> {
            Dragboard board = button.startDragAndDrop(TransferMode.COPY);
            ClipboardContent content = new ClipboardContent();
            content.put(DRAGGED, entry.id());
            board.setContent(content);
            board.setDragView(button.snapshot(null, null));
            event.consume();
        });
        return button;
    }

    /** A body, in one step with its fall. */
    private static void put(Edits edits, Shape shape, String name, Place at) {
        put(edits, name, state -> Dropping.body(state, shape, name, at.sight(), at.side()));
    }

    /** A light where it is dropped; not on, but before what is there. */
    private static void put(Edits edits, Light light, String name, Place at) {
        put(edits, name, state -> Dropping.light(state, light, name, at.sight(), at.side()));
    }

    private static void put(Edits edits, String name, UnaryOperator<EditorState> change) {
        edits.attempt(() -> edits.model().editState(Label.of(Label.Edit.ADD, name), change));
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
        Hint.of(button).set(text);
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
