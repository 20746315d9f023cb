package cz.paprsek.fx;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.fx.view.command.Command;
import cz.paprsek.fx.view.command.SelectionCommands;
import cz.paprsek.fx.view.find.HelpPane;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.look.MenuLook;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.shell.AddPalette;
import cz.paprsek.fx.view.texts.Shortcut;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.lesson.Lessons;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.geometry.Orientation;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.Separator;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.ToggleGroup;
import javafx.scene.control.ToolBar;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;
import org.kordamp.ikonli.materialdesign2.MaterialDesignB;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignF;
import org.kordamp.ikonli.materialdesign2.MaterialDesignI;
import org.kordamp.ikonli.materialdesign2.MaterialDesignK;
import org.kordamp.ikonli.materialdesign2.MaterialDesignM;
import org.kordamp.ikonli.materialdesign2.MaterialDesignR;
import org.kordamp.ikonli.materialdesign2.MaterialDesignU;

/** The menus and the toolbar: all commands, with their keys. */
final class Menus {
    private final Editor editor;
    private final Views views;
    private final AddPalette palette;
    private final Texts texts;
    private final FileActions files;
    private final SelectionCommands selection;
    private final Command open;
    private final Command save;
    private final Command undo;
    private final Command redo;
    private final Command fitAll;
    private final Command render;
    private final Command find;
    private final Consumer<HelpPane.Page> help;

    Menus(Editor editor, Views views, AddPalette palette, SelectionCommands selection, Runnable find, Consumer<HelpPane.Page> help) {
        this.editor = editor;
        this.views = views;
        this.palette = palette;
        this.texts = editor.texts();
        this.files = editor.files();
        EditorModel model = editor.model();
        this.selection = selection;
        this.help = help;
        this.find = command("edit-menu.find", find).keys("Shortcut+K").icon(MaterialDesignM.MAGNIFY);
        open = command("file.open", files::open).keys("Shortcut+O").icon(MaterialDesignF.FOLDER_OPEN_OUTLINE);
        save = command("file.save", files::save).keys("Shortcut+S").icon(MaterialDesignC.CONTENT_SAVE_OUTLINE);
        undo = history(command("edit-menu.undo", model::undo).keys("Shortcut+Z").icon(MaterialDesignU.UNDO), "undo", model.undoableProperty());
        redo = history(command("edit-menu.redo", model::redo).keys("Shortcut+Shift+Z").icon(MaterialDesignR.REDO), "redo", model.redoableProperty());
        fitAll = command("view-menu.fit-all", views::fitAll).keys("Shortcut+0").icon(MaterialDesignF.FIT_TO_PAGE_OUTLINE);
        render = command("render-menu.render", editor.renders()::render).keys("Shortcut+R").icon(MaterialDesignM.MOVIE_OPEN_OUTLINE);
    }

    MenuBar menuBar() {
        MenuBar bar = new MenuBar(fileMenu(), editMenu(), addMenu(), objectMenu(), viewMenu(), renderMenu(), teachMenu(), helpMenu());
        bar.setId("menu-bar");
        bar.getMenus().forEach(menu -> menu.addEventHandler(Menu.ON_SHOWING, event -> MenuLook.beforeOpening(menu, bar)));
        return bar;
    }

    ToolBar toolBar() {
        ToolBar bar = new ToolBar(
                open.button(), save.button(), new Separator(Orientation.VERTICAL), undo.button(), redo.button(), new Separator(Orientation.VERTICAL),
                fitAll.button(), snapButton(), new Separator(Orientation.VERTICAL), selection.soften().button(), views.cameras().focus().button(), render.button());
        bar.getItems().addAll(6, selection.forButtons().stream().map(Command::button).toList());
        bar.getItems().add(6 + selection.forButtons().size(), new Separator(Orientation.VERTICAL));
        bar.setId("tool-bar");
        return bar;
    }

    private Menu fileMenu() {
        Menu fresh = menu("file.templates");
        for (String template : Templates.NEW) {
            fresh.getItems().add(item(texts.of("template." + template), "template-" + template, () -> files.newFrom(template)));
        }
        Menu examples = menu("file.examples");
        for (String example : Templates.EXAMPLES) {
            examples.getItems().add(item(example, "example-" + example, () -> files.newFrom(example)));
        }
        Menu recent = menu("file.recent");
        // Filled when it opens: the list is another one after every file.
        recent.getItems().add(new MenuItem());
        recent.setOnShowing(event -> recent.getItems().setAll(recentItems()));
        return menu("menu.file", command("file.new", () -> files.newFrom("plain")).keys("Shortcut+N").icon(MaterialDesignF.FILE_OUTLINE).menuItem(),
                fresh, examples, open.menuItem(), recent, new SeparatorMenuItem(),
                save.menuItem(), command("file.save-as", files::saveAs).keys("Shortcut+Shift+S").menuItem(), command("file.export-pov", files::exportPov).menuItem(),
                command("file.library", editor.library()::show).keys("Shortcut+Shift+O").icon(MaterialDesignI.IMAGE_MULTIPLE_OUTLINE).menuItem(),
                command("file.revert", files::reload).disabledIf(noFile()).menuItem(), new SeparatorMenuItem(),
                command("file.quit", editor::quit).keys("Shortcut+Q").menuItem());
    }

    private List<MenuItem> recentItems() {
        List<Path> recent = editor.settings().recent();
        if (recent.isEmpty()) {
            MenuItem none = new MenuItem(texts.of("file.recent.none"));
            none.setDisable(true);
            return List.of(none);
        }
        return recent.stream().map(path -> item(path.toString(), "recent", () -> files.open(path))).toList();
    }

    private Menu editMenu() {
        CheckMenuItem snap = new CheckMenuItem(texts.of("edit-menu.snap"));
        snap.setId("edit-menu-snap");
        snap.setAccelerator(Shortcut.of("Shortcut+Shift+M"));
        snap.selectedProperty().bindBidirectional(editor.snapping());
        Menu menu = menu("menu.edit", undo.menuItem(), redo.menuItem(), new SeparatorMenuItem());
        menu.getItems().addAll(selection.editItems());
        menu.getItems().add(new SeparatorMenuItem());
        menu.getItems().addAll(selection.selectingItems());
        menu.getItems().addAll(find.menuItem(), new SeparatorMenuItem(), snap);
        return menu;
    }

    private Menu addMenu() {
        Menu menu = menu("menu.add");
        menu.getItems().setAll(palette.menuItems());
        return menu;
    }

    private Menu objectMenu() {
        Menu menu = menu("menu.object");
        menu.getItems().addAll(selection.objectItems());
        return menu;
    }

    private Menu viewMenu() {
        Menu theme = menu("view-menu.theme");
        choices(theme, List.of(Theme.values()), value -> texts.of("theme." + value.name().toLowerCase(Locale.ROOT)),
                value -> value == editor.theme().get(), value -> editor.theme().set(value));
        Menu language = menu("view-menu.language");
        choices(language, Texts.LANGUAGES, value -> value.getDisplayLanguage(value), value -> value.equals(texts.locale()), editor::setLanguage);
        CheckMenuItem explain = new CheckMenuItem(texts.of("view-menu.explain"));
        explain.setId("view-menu-explain");
        explain.setAccelerator(Shortcut.of("Shortcut+E"));
        explain.selectedProperty().bindBidirectional(views.explaining().onProperty());
        CheckMenuItem free = new CheckMenuItem(texts.of("view-menu.free"));
        free.setId("view-menu-free");
        free.setAccelerator(Shortcut.of("Shortcut+5"));
        free.selectedProperty().bindBidirectional(views.freeShownProperty());
        Menu look = menu("free.menu");
        look.getItems().setAll(views.freeItems());
        Menu cut = menu("cut.menu", command("cut.x", () -> views.cut(Axis.X)).menuItem(), command("cut.y", () -> views.cut(Axis.Y)).menuItem(),
                command("cut.z", () -> views.cut(Axis.Z)).keys("Shortcut+Shift+C").menuItem(), new SeparatorMenuItem(),
                command("cut.more", () -> views.moveCut(-0.05)).keys("Shortcut+Page Down").menuItem(), command("cut.less", () -> views.moveCut(0.05)).keys("Shortcut+Page Up").menuItem(),
                command("cut.whole", views::whole).keys("Shortcut+Shift+W").menuItem());
        CheckMenuItem timeline = new CheckMenuItem(texts.of("view-menu.timeline"));
        timeline.setId("view-menu-timeline");
        timeline.setAccelerator(Shortcut.of("Shortcut+Shift+T"));
        timeline.selectedProperty().bindBidirectional(editor.clock().openProperty());
        CheckMenuItem xml = new CheckMenuItem(texts.of("view-menu.xml"));
        xml.setId("view-menu-xml");
        xml.setAccelerator(Shortcut.of("Shortcut+Shift+X"));
        xml.selectedProperty().bindBidirectional(editor.manuscript().openProperty());
        return menu("menu.view",
                maximize("view-menu.top", 0, "Shortcut+1"), maximize("view-menu.camera", 1, "Shortcut+2"),
                maximize("view-menu.front", 2, "Shortcut+3"), maximize("view-menu.right", 3, "Shortcut+4"), free, look, cut, new SeparatorMenuItem(),
                command("view-menu.zoom-in", () -> views.zoom(pane -> pane.zoom(1.25))).keys("Shortcut+Plus").menuItem(),
                command("view-menu.zoom-out", () -> views.zoom(pane -> pane.zoom(0.8))).keys("Shortcut+Minus").menuItem(), fitAll.menuItem(),
                command("view-menu.fit-selection", views::fitSelection).keys("Shortcut+Shift+0").menuItem(), new SeparatorMenuItem(), xml, timeline, explain,
                command("view-menu.present", views::present).keys("Shortcut+Shift+E").menuItem(),
                views.cameras().menu(), new SeparatorMenuItem(), theme, language);
    }

    private Menu renderMenu() {
        return menu("menu.render", render.menuItem(), command("render-menu.ask", editor.renders()::ask).keys("Shortcut+Alt+R").menuItem(),
                command("render-menu.region", this::drawRegion).keys("Shortcut+Shift+N").menuItem(), command("render.region.clear", () -> editor.renders().setRegion(Optional.empty())).disabledIf(noRegion()).menuItem(),
                command("render-menu.pictures", editor.renders()::open).keys("Shortcut+P").menuItem(),
                command("render-menu.mistakes", editor.mistakes()::show).menuItem());
    }

    private void drawRegion() {
        views.drawRegion();
        editor.say(texts.of("view.region-drag"));
    }

    private BooleanBinding noRegion() {
        return Bindings.createBooleanBinding(() -> editor.renders().framing().getValue().part().isEmpty(), editor.renders().framing());
    }

    private Menu teachMenu() {
        Menu menu = menu("menu.teach", command("teach.lessons", editor.lessons()::toggle).keys("Shortcut+T").menuItem(), new SeparatorMenuItem());
        Lessons.NAMES.forEach(name -> menu.getItems().add(item((Lessons.NAMES.indexOf(name) + 1) + ". " + texts.of("lesson." + name), "lesson-" + name, () -> editor.lessons().open(name))));
        menu.getItems().addAll(new SeparatorMenuItem(), command("teach.open", files::openLesson).menuItem());
        return menu;
    }

    private Menu helpMenu() {
        return menu("menu.help", command("help-menu.welcome", editor::welcome).menuItem(),
                command("help-menu.tour", () -> editor.lessons().open(Lessons.tour())).menuItem(),
                command("help-menu.manual", editor.manual()::show).keys("Shift+F1").icon(MaterialDesignB.BOOK_OPEN_OUTLINE).menuItem(), new SeparatorMenuItem(),
                command("help-menu.keys", () -> help.accept(HelpPane.Page.KEYS)).keys("F1").icon(MaterialDesignK.KEYBOARD_OUTLINE).menuItem(),
                command("help-menu.glossary", () -> help.accept(HelpPane.Page.GLOSSARY)).icon(MaterialDesignA.ALPHABETICAL_VARIANT).menuItem());
    }

    private MenuItem maximize(String key, int view, String keys) {
        return command(key, () -> views.toggle(views.titled().get(view))).keys(keys).menuItem();
    }

    private ToggleButton snapButton() {
        ToggleButton button = new ToggleButton("", new FontIcon(MaterialDesignM.MAGNET));
        button.setId("snap-button");
        Hint.of(button).set(texts.of("edit-menu.snap"));
        button.setAccessibleText(texts.of("edit-menu.snap"));
        button.setFocusTraversable(false);
        button.selectedProperty().bindBidirectional(editor.snapping());
        return button;
    }

    private interface Naming<T> {
        String name(T value);
    }

    private static <T> void choices(
            Menu menu, List<T> values, Naming<T> naming, java.util.function.Predicate<T> current, Consumer<T> action) {
        ToggleGroup group = new ToggleGroup();
        for (T value : values) {
            RadioMenuItem item = new RadioMenuItem(naming.name(value));
            item.setId(menu.getId() + "-" + value.toString().toLowerCase(Locale.ROOT));
            item.setToggleGroup(group);
            item.setSelected(current.test(value));
            item.setOnAction(event -> action.accept(value));
            menu.getItems().add(item);
        }
    }

    private Command command(String key, Runnable action) {
        return Command.of(key, texts, action);
    }

    /** "Undo Move sphere", as long as there is something to undo. */
    private Command history(Command command, String what, ReadOnlyObjectProperty<Optional<Label>> label) {
        return command
                .called(Bindings.createStringBinding(
                        () -> label.get().map(l -> texts.of("edit-menu." + what + "-what", texts.edit(l))).orElse(texts.of("edit-menu." + what)), label))
                .disabledIf(Bindings.createBooleanBinding(() -> label.get().isEmpty(), label));
    }

    private BooleanBinding noFile() {
        return Bindings.createBooleanBinding(() -> editor.document().sourceProperty().get().isEmpty(), editor.document().sourceProperty());
    }

    private Menu menu(String key, MenuItem... items) {
        Menu menu = new Menu(texts.of(key), null, items);
        menu.setMnemonicParsing(true);
        menu.setId(key.replace('.', '-'));
        return menu;
    }

    private static MenuItem item(String text, String id, Runnable action) {
        MenuItem item = new MenuItem(text);
        item.setId(id);
        item.setMnemonicParsing(false);
        item.setOnAction(event -> action.run());
        return item;
    }
}
