package cz.paprsek.fx;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Mends;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.command.SelectionCommands;
import cz.paprsek.fx.view.command.UndoKeys;
import cz.paprsek.fx.view.find.Findable;
import cz.paprsek.fx.view.find.FinderPane;
import cz.paprsek.fx.view.find.HelpPane;
import cz.paprsek.fx.view.find.MenuItems;
import cz.paprsek.fx.view.find.SceneThings;
import cz.paprsek.fx.view.lesson.LessonPane;
import cz.paprsek.fx.view.sheet.PropertySheet;
import cz.paprsek.fx.view.shell.AddPalette;
import cz.paprsek.fx.view.shell.Columns;
import cz.paprsek.fx.view.shell.FocusOrder;
import cz.paprsek.fx.view.shell.MessageBar;
import cz.paprsek.fx.view.shell.ProblemList;
import cz.paprsek.fx.view.shell.StatusBar;
import cz.paprsek.fx.view.texts.Measures;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.fx.view.tree.ObjectTree;
import cz.paprsek.fx.view.welcome.WelcomePane;
import cz.paprsek.fx.view.xml.XmlPane;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.warning.SceneWarning;
import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.application.Platform;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.WeakChangeListener;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.MenuBar;
import javafx.scene.control.SplitPane;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.TransferMode;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import org.jspecify.annotations.Nullable;

/** What the window holds, in one language. */
final class MainWindow {
    private final BorderPane root = new BorderPane();
    private final StackPane whole;
    private final WelcomePane welcome;
    private final MenuBar menuBar;
    private final Editor editor;
    private final Views views;
    private final MessageBar messages;
    private final ProblemList problems;
    private final ProblemList warningList;
    private final StatusBar status = new StatusBar();
    private final SceneWatch watch;
    private List<SceneWarning> warnings = List.of();
    /** What the warnings are about. */
    private EditorState warned;
    private final Columns columns;
    /** Made when it is first opened: it takes a tenth of the start. */
    private Optional<XmlPane> xml = Optional.empty();
    private Optional<LessonPane> lesson = Optional.empty();
    /** Held here, because the editor, which outlives the window, holds it weakly. */
    private final ChangeListener<Object> showLesson = (property, old, now) -> showLesson();
    /** Held here likewise. */
    private final ChangeListener<Object> showXml = (property, old, now) -> showXml(true);
    /** Held here, because the model, which outlives the window, holds it weakly. */
    private final ChangeListener<EditorState> showSelection = (property, old, now) -> {
        showSelection();
        if (!old.locked().equals(now.locked())) {
            // What was said of a lock is no longer so.
            status.showMessage("");
        }
    };

    /** Held here likewise: what is opened by keys or dropped takes the welcome's place. */
    private final ChangeListener<Object> closeWelcome = (property, old, now) -> closeWelcome();

    MainWindow(Editor editor) {
        this.editor = editor;
        EditorModel model = editor.model();
        warned = model.state();
        Texts texts = editor.texts();
        Edits edits = new Edits(model, texts);
        edits.refusalProperty().addListener((property, old, now) -> status.showMessage(now));
        SelectionCommands commands = new SelectionCommands(edits);
        views = new Views(editor, commands);
        messages = new MessageBar(texts.of("window.close-message"));
        problems = new ProblemList("problem", texts.of("window.close-message"), texts::sentence);
        warningList = new ProblemList("warning", texts.of("window.close-message"), texts::sentence);
        ObjectTree tree = new ObjectTree(model, texts, commands);
        PropertySheet sheet = new PropertySheet(model, texts, editor.proportional(), editor.fileFinder(), editor.clock());
        sheet.offerPipette(commands.pipette());
        root.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE && views.giveUp()) {
                event.consume();
            }
        });
        SceneMeshes meshes = editor.meshes(edits);
        AddPalette palette = new AddPalette(model, texts, views::sight, edits, meshes::choose, meshes::chooseHeights);
        views.acceptThings(palette, editor.snapping());
        FinderPane finder = new FinderPane(() -> findable(edits), texts.of("find.prompt"), texts.of("find.nothing"));
        HelpPane help = new HelpPane(texts, () -> MenuItems.of(menuBar().getMenus()));
        Menus menus = new Menus(editor, views, palette, commands, finder::open, help::open);
        menuBar = menus.menuBar();
        welcome = new WelcomePane(texts);
        model.openingsProperty().addListener(new WeakChangeListener<>(closeWelcome));
        whole = new StackPane(root, welcome, finder, help);
        commands.setOnRename(tree::rename);
        VBox.setVgrow(tree, Priority.ALWAYS);
        VBox left = new VBox(palette, tree);
        left.setMinWidth(120);
        // Three numbers beside each other, none of them cut off.
        sheet.setMinWidth(290);
        SplitPane.setResizableWithParent(left, false);
        SplitPane.setResizableWithParent(sheet, false);
        columns = new Columns(left, views.root(), sheet);
        views.explaining().onProperty().addListener((property, old, now) -> columns.explain(now ? Optional.of(views.explaining().pane()) : Optional.empty()));
        editor.lessons().currentProperty().addListener(new WeakChangeListener<>(showLesson));
        showLesson();
        editor.manuscript().openProperty().addListener(new WeakChangeListener<>(showXml));
        showXml(false);
        root.addEventHandler(KeyEvent.KEY_PRESSED, views.explaining()::key);
        root.addEventHandler(KeyEvent.KEY_PRESSED, this::closeProblems);
        whole.setId("main-window");
        whole.getStylesheets().add(String.valueOf(MainWindow.class.getResource("editor.css")));
        root.setTop(new VBox(menuBar, menus.toolBar(), messages));
        root.setCenter(columns.root());
        root.setBottom(new VBox(problems, warningList, status));
        status.followRender(editor.renders().statusProperty());
        UndoKeys.reach(() -> {
            if (xml.filter(XmlPane::undo).isEmpty()) {
                model.undo();
            }
        }, () -> {
            if (xml.filter(XmlPane::redo).isEmpty()) {
                model.redo();
            }
        }, root);
        sheet.setOnFieldGone(views::takeKeys);
        new FocusOrder(List.of(views::grid, views::timeline, () -> tree, () -> palette, columns::text, columns::last, columns::lesson, () -> problems, () -> warningList), views::takeKeys).reach(root);
        views.setOnPointed(status::showCursor, texts);
        model.stateProperty().addListener(new WeakChangeListener<>(showSelection));
        showSelection();
        acceptFiles(edits, meshes);
        status.setOnWarnings(() -> {
            if (warningList.isVisible()) {
                warningList.hide();
            } else {
                listWarnings();
            }
        });
        watch = new SceneWatch(model, this::warned);
    }

    /** All that can be done, selected, given or opened. */
    private List<Findable> findable(Edits edits) {
        List<Findable> all = new ArrayList<>(MenuItems.of(menuBar().getMenus()));
        all.addAll(SceneThings.of(edits));
        return all;
    }

    private MenuBar menuBar() {
        return menuBar;
    }

    Parent root() {
        return whole;
    }

    MessageBar messages() {
        return messages;
    }

    ProblemList problems() {
        return problems;
    }

    StatusBar status() {
        return status;
    }

    void welcome() {
        Welcome.open(welcome, editor);
    }

    private void closeWelcome() {
        welcome.close();
    }

    boolean isPictureComplete() {
        return views.isPictureComplete();
    }

    private void warned(List<SceneWarning> found) {
        warnings = found;
        warned = editor.model().state();
        status.showWarnings(found.isEmpty() ? "" : editor.texts().of("warnings.count", found.size()));
        if (found.isEmpty()) {
            warningList.hide();
        } else if (warningList.isVisible()) {
            listWarnings();
        }
    }

    private void listWarnings() {
        Texts texts = editor.texts();
        warningList.showEntries(texts.of("warnings.title"), warnings.stream()
                .map(warning -> new ProblemList.Entry(texts.sentence(warning.message()), () -> warning.place().ifPresent(this::goTo), () -> mend(warning))).toList());
    }

    private Optional<ProblemList.Mend> mend(SceneWarning warning) {
        EditorModel model = editor.model();
        return mended(model.state(), warning).map(mend -> new ProblemList.Mend(editor.texts().of(mend.key()), () ->
                model.editState(Label.of(Label.Edit.CHANGE, editor.texts().of(mend.key())), state -> mended(state, warning).map(Mends.Mended::result).orElse(state))));
    }

    /** Empty as soon as the scene is another one than that of the warning, whose place may lead to something else then. */
    private Optional<Mends.Mended> mended(EditorState state, SceneWarning warning) {
        return state.eye() == warned.eye() && state.scene().equals(warned.scene()) ? Mends.of(state, warning) : Optional.empty();
    }

    /** Selects what a warning is about; named materials stand in the sheet where nothing is selected. */
    private void goTo(ScenePath place) {
        if (place instanceof ScenePath.MaterialAt) {
            editor.model().select();
        } else {
            editor.model().select(place);
        }
    }

    private void showLesson() {
        lesson.ifPresent(LessonPane::close);
        if (editor.lessons().currentProperty().get().isPresent()) {
            // A lesson asks for numbers before it shows them: an explanation of the one before would have them already.
            views.explaining().onProperty().set(false);
        }
        lesson = editor.lessons().currentProperty().get().map(held -> new LessonPane(held, editor.lessons(), editor.model(), editor.texts(), views.explaining()::explain));
        columns.teach(lesson.map(pane -> pane));
    }

    private void showXml(boolean takesKeys) {
        boolean isOpen = editor.manuscript().openProperty().get();
        if (isOpen && xml.isEmpty()) {
            xml = Optional.of(new XmlPane(editor.manuscript(), editor.model(), editor.texts()));
        }
        columns.write(xml.filter(pane -> isOpen).map(pane -> pane));
        if (takesKeys) {
            Platform.runLater(() -> xml.filter(pane -> isOpen).ifPresentOrElse(XmlPane::takeKeys, views::takeKeys));
        }
    }

    void close() {
        welcome.close();
        lesson.ifPresent(LessonPane::close);
        watch.close();
        views.close();
    }

    /** Escape that nobody else has had. */
    private void closeProblems(KeyEvent event) {
        if (event.getCode() == KeyCode.ESCAPE && !event.isConsumed() && problems.isVisible()) {
            problems.hide();
            event.consume();
        }
    }

    private void showSelection() {
        EditorModel model = editor.model();
        status.showSelection(Measures.of(model.state(), editor.texts()));
    }

    /**
     * Opens a file that is dropped anywhere on the window; one of triangles that is dropped on a view becomes part of the scene. Adds what is dropped as text: a
     * scene or material out of the library.
     */
    private void acceptFiles(Edits edits, SceneMeshes meshes) {
        whole.setOnDragOver(event -> {
            if (event.getDragboard().hasFiles() || event.getDragboard().hasString()) {
                event.acceptTransferModes(TransferMode.COPY);
            }
        });
        whole.setOnDragDropped(event -> {
            List<File> files = event.getDragboard().getFiles();
            if (event.getDragboard().hasFiles() && !files.isEmpty()) {
                List<Path> paths = files.stream().map(File::toPath).toList();
                Node on = event.getPickResult().getIntersectedNode();
                // The program that files come from waits for the end of this event, and is not to wait for a question to be answered.
                Platform.runLater(() -> dropped(paths, on, meshes));
                event.setDropCompleted(true);
            } else if (event.getDragboard().hasString()) {
                edits.paste(event.getDragboard().getString());
                event.setDropCompleted(true);
            }
        });
    }

    /** On the views all meshes are added, and a scene among them is passed over; elsewhere the first file takes the place of all. The welcome would hide what is said. */
    private void dropped(List<Path> files, @Nullable Node on, SceneMeshes meshes) {
        closeWelcome();
        Node node = on;
        while (node != null && node != views.root()) {
            node = node.getParent();
        }
        if (node != null && files.stream().anyMatch(SceneMeshes::isMesh)) {
            meshes.bring(files, views.sight());
        } else {
            editor.files().open(files.get(0));
        }
    }
}
