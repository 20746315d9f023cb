package cz.paprsek.fx.view.command;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.ScenePath;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.collections.ObservableList;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.layout.Region;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignI;
import org.kordamp.ikonli.materialdesign2.MaterialDesignV;

/** Through which camera the user looks, and what can be done with it: the same words in the menu and in the title of the picture. */
public final class CameraCommands {
    private static final double LONGEST_NAME = 150;

    private final EditorModel model;
    private final Texts texts;
    private final List<Command> commands;
    private final Command focus;

    /** @param focus asks for a click on what shall be sharp */
    public CameraCommands(Edits edits, Runnable focus) {
        this.model = edits.model();
        this.texts = edits.texts();
        BooleanBinding isFirst = Bindings.createBooleanBinding(() -> model.state().eye() == 0, model.stateProperty());
        BooleanBinding isOnly = Bindings.createBooleanBinding(() -> model.scene().cameras().size() == 1, model.stateProperty());
        commands = List.of(
                Command.of("view-menu.next-camera", texts, () -> model.look((model.state().eye() + 1) % model.scene().cameras().size())).keys("Shortcut+Alt+K").disabledIf(isOnly),
                Command.of("view-menu.new-camera", texts, edits::addCamera).keys("Shortcut+Shift+K"),
                Command.of("view-menu.turntable", texts, edits::turnCamera),
                Command.of("view-menu.first-camera", texts, () -> edits.makeFirst(model.state().eye())).disabledIf(isFirst),
                Command.of("view-menu.remove-camera", texts, () -> edits.removeCamera(model.state().eye())).disabledIf(isOnly));
        this.focus = Command.of("view-menu.focus", texts, focus).keys("Shortcut+Shift+F").icon(MaterialDesignI.IMAGE_FILTER_CENTER_FOCUS);
    }

    /** A menu with the cameras there are when it opens. */
    public Menu menu() {
        Menu menu = new Menu(texts.of("view-menu.cameras"));
        menu.setId("view-menu-cameras");
        menu.setMnemonicParsing(true);
        List<MenuItem> below = below(Command::menuItem);
        menu.getItems().setAll(below);
        menu.setOnShowing(event -> fill(menu.getItems(), below));
        return menu;
    }

    /** What asks for a click on what shall be sharp. */
    public Command focus() {
        return focus;
    }

    /** A button that tells which camera is looked through, with the same menu. */
    public MenuButton chooser() {
        MenuButton button = new MenuButton("", new FontIcon(MaterialDesignV.VIDEO_OUTLINE));
        button.setId("camera-chooser");
        button.getStyleClass().add("view-button");
        button.setFocusTraversable(false);
        button.setMnemonicParsing(false);
        button.setMaxWidth(LONGEST_NAME);
        button.setMinWidth(Region.USE_COMPUTED_SIZE);
        Hint.of(button).set(texts.of("view.camera-chooser"));
        button.setAccessibleText(texts.of("view.camera-chooser"));
        button.textProperty().bind(Bindings.createStringBinding(() -> name(model.state().eye()), model.stateProperty()));
        // Keys belong to the menu: here they would take its place.
        List<MenuItem> below = below(command -> {
            MenuItem item = command.menuItem();
            item.setAccelerator(null);
            item.setId("chooser-" + item.getId());
            return item;
        });
        button.getItems().setAll(below);
        button.setOnShowing(event -> fill(button.getItems(), below));
        return button;
    }

    private interface Making {
        MenuItem item(Command command);
    }

    private List<MenuItem> below(Making making) {
        List<MenuItem> items = new ArrayList<>();
        items.add(new SeparatorMenuItem());
        commands.forEach(command -> items.add(making.item(command)));
        items.add(new SeparatorMenuItem());
        items.add(making.item(focus));
        return items;
    }

    private void fill(ObservableList<MenuItem> items, List<MenuItem> below) {
        Stream<MenuItem> cameras = IntStream.range(0, model.scene().cameras().size()).mapToObj(this::item);
        items.setAll(Stream.concat(cameras, below.stream()).toList());
    }

    private MenuItem item(int camera) {
        RadioMenuItem item = new RadioMenuItem(name(camera));
        item.setId("camera-" + camera);
        item.setMnemonicParsing(false);
        item.setSelected(camera == model.state().eye());
        item.setOnAction(chosen -> model.look(camera));
        return item;
    }

    private String name(int camera) {
        return PathNames.of(model.scene(), ScenePath.camera(camera), texts);
    }
}
