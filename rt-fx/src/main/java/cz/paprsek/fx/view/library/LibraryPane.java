package cz.paprsek.fx.view.library;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.model.library.Library;
import cz.paprsek.fx.model.library.LibraryRows;
import cz.paprsek.fx.model.library.LibraryStore;
import cz.paprsek.fx.view.command.UndoKeys;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Failures;
import cz.paprsek.query.SceneTables;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.stream.Stream;
import javafx.application.Platform;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.geometry.Orientation;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.Separator;
import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextField;
import javafx.scene.control.ToolBar;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import javafx.stage.Window;
import javafx.util.StringConverter;
import javafx.util.Subscription;

/** The library: the scenes of a database as pictures, and everything in them as tables; searched by what is typed above. */
public final class LibraryPane extends BorderPane implements AutoCloseable {
    private final Library library;
    private final LibraryStore store;
    private final Texts texts;
    private final LibraryFiles files;
    private final Thumbnails thumbnails;
    private final ExecutorService searcher = Worker.named("library-search");
    private final LibraryMessages messages;
    private final SceneSelection selection = new SceneSelection();
    private final LibraryActions actions;
    private final LibraryRows<Scene> scenes;
    private final SceneGrid grid;
    private final SceneDetails details;
    private final TextField search = new TextField();
    private final Label problem = new Label();
    private final Label count = new Label();
    private final TablePane table;
    private final ChoiceBox<String> choice = new ChoiceBox<>();
    private final TabPane tabs;
    private final Subscription subscription;

    /** A library beside an editor: scenes go from one into the other. */
    public LibraryPane(Library library, LibraryStore store, Desk desk, Texts texts, LibraryFiles files) {
        this.library = library;
        thumbnails = new Thumbnails(() -> library.path().map(Assets::beside).orElseGet(Assets::none));
        this.store = store;
        this.texts = texts;
        messages = new LibraryMessages(texts);
        this.files = files;
        actions = new LibraryActions(library, store, selection, desk, texts, files, messages);
        scenes = new LibraryRows<>(library, SceneTables.scenes(), (column, value) -> "", searcher, Platform::runLater);
        scenes.filterProperty().bind(search.textProperty());
        grid = new SceneGrid(thumbnails, selection, desk::open);
        details = new SceneDetails(library, selection, texts, messages, actions);
        table = new TablePane(library, searcher, search.textProperty(), texts, problem, this::placeholder, desk::open,
                rows -> count.setText(texts.of("library.rows", rows)));
        tabs = new TabPane(tab("library.scenes", scenesTab()), tab("library.tables", tablesTab()));
        tabs.setId("library-tabs");
        subscription = Subscription.combine(
                scenes.rowsProperty().subscribe(this::show),
                library.fileProperty().subscribe(file -> {
                    grid.setPlaceholder(placeholder());
                    table.sayWhy();
                }),
                tabs.getSelectionModel().selectedIndexProperty().subscribe(index -> showTab()));
        setId("library");
        getStylesheets().add(String.valueOf(LibraryPane.class.getResource("library.css")));
        setTop(new VBox(toolBar(), problem, refusal()));
        setCenter(tabs);
        setBottom(statusBar());
        UndoKeys.reach(actions::undo, actions::redo, this);
        addEventFilter(KeyEvent.KEY_PRESSED, this::searchKey);
        grid.addEventHandler(KeyEvent.KEY_PRESSED, this::gridKey);
    }

    /** What is open, for the title of a window. */
    public String title() {
        return library.path().map(path -> path.getFileName() + " – ").orElse("") + texts.of("library.title");
    }

    @Override
    public void close() {
        subscription.unsubscribe();
        scenes.close();
        table.close();
        thumbnails.close();
        searcher.shutdown();
    }

    private ToolBar toolBar() {
        Button keep = LibraryActions.button(texts, "library.add", actions::keep);
        Hint.of(keep).set(texts.of("library.add-hint"));
        keep.disableProperty().bind(noFile());
        Button undo = step("library.undo", "edit-menu.undo-what", library.undoableProperty(), actions::undo);
        Button redo = step("library.redo", "edit-menu.redo-what", library.redoableProperty(), actions::redo);
        search.setId("library-filter");
        search.setPromptText(texts.of("library.filter"));
        Hint.of(search).set(texts.of("library.filter-hint"));
        HBox.setHgrow(search, Priority.ALWAYS);
        problem.setId("library-problem");
        problem.setWrapText(true);
        problem.getStyleClass().add("refusal");
        problem.managedProperty().bind(problem.textProperty().isNotEmpty());
        problem.visibleProperty().bind(problem.managedProperty());
        ToolBar bar = new ToolBar(LibraryActions.button(texts, "library.open", () -> actions.open(window())),
                LibraryActions.button(texts, "library.create", () -> actions.create(window())), new Separator(Orientation.VERTICAL), keep,
                new Separator(Orientation.VERTICAL), undo, redo, new Separator(Orientation.VERTICAL), search);
        bar.getItems().forEach(item -> HBox.setHgrow(item, item == search ? Priority.ALWAYS : Priority.NEVER));
        return bar;
    }

    /** A button of the history, which says what it would do. */
    private Button step(String key, String what, ReadOnlyObjectProperty<Optional<cz.paprsek.fx.model.Label>> step, Runnable action) {
        Button button = LibraryActions.button(texts, key, action);
        button.disableProperty().bind(Bindings.createBooleanBinding(() -> step.get().isEmpty(), step));
        Hint.of(button).bind(Bindings.createStringBinding(() -> step.get().map(label -> texts.of(what, texts.edit(label))).orElse(""), step));
        return button;
    }

    /** Shown while the file refuses what was changed here. */
    private HBox refusal() {
        Label sentence = new Label();
        sentence.setId("library-refusal");
        sentence.setWrapText(true);
        sentence.setMaxWidth(Double.MAX_VALUE);
        sentence.textProperty().bind(store.refusalProperty().map(texts::sentence));
        HBox.setHgrow(sentence, Priority.ALWAYS);
        HBox bar = new HBox(sentence, LibraryActions.button(texts, "library.reload", store::reload));
        bar.getStyleClass().add("refusal-bar");
        bar.managedProperty().bind(store.refusalProperty().isNotEmpty());
        bar.visibleProperty().bind(bar.managedProperty());
        return bar;
    }

    private Node scenesTab() {
        BorderPane pane = new BorderPane(grid);
        pane.setRight(details);
        return pane;
    }

    private Node tablesTab() {
        choice.setId("library-table");
        TableWords words = new TableWords(texts);
        choice.setConverter(new StringConverter<>() {
            @Override
            public String toString(String name) {
                return name == null ? "" : words.table(name);
            }

            @Override
            public String fromString(String text) {
                return text;
            }
        });
        choice.getItems().addAll(SceneTables.all().stream().map(relation -> relation.table().name()).toList());
        choice.setValue("object");
        choice.setOnAction(event -> showTab());
        Label hint = new Label(texts.of("library.table-hint"));
        hint.getStyleClass().add("hint");
        hint.setWrapText(true);
        HBox above = new HBox(choice, LibraryActions.button(texts, "library.export", this::export), hint);
        above.getStyleClass().add("table-tools");
        BorderPane pane = new BorderPane(table);
        pane.setTop(above);
        return pane;
    }

    private Tab tab(String key, Node content) {
        Tab tab = new Tab(texts.of(key), content);
        tab.setClosable(false);
        return tab;
    }

    private HBox statusBar() {
        Label message = new Label();
        message.setId("library-message");
        message.setMaxWidth(Double.MAX_VALUE);
        message.textProperty().bind(messages.textProperty());
        HBox.setHgrow(message, Priority.ALWAYS);
        count.setId("library-count");
        count.setMinWidth(USE_PREF_SIZE);
        HBox bar = new HBox(message, count);
        bar.getStyleClass().add("status-bar");
        return bar;
    }

    /** Each table has columns of its own: the filter is understood for what is in front. */
    private void showTab() {
        if (isShowingScenes()) {
            table.close();
            problem.textProperty().bind(scenes.problemProperty().map(texts::sentence));
            show(scenes.rows());
        } else {
            table.show(choice.getValue());
        }
    }

    private void show(List<Scene> found) {
        grid.show(found);
        grid.setPlaceholder(placeholder());
        if (isShowingScenes()) {
            count.setText(texts.of("library.count", found.size(), library.database().size()));
        }
    }

    private boolean isShowingScenes() {
        return tabs.getSelectionModel().getSelectedIndex() <= 0;
    }

    private Label placeholder() {
        Label label = new Label(texts.of(library.file().isEmpty() ? "library.none" : library.database().size() == 0 ? "library.empty" : "library.no-match"));
        label.setWrapText(true);
        return label;
    }

    private void searchKey(KeyEvent event) {
        if (event.getCode() == KeyCode.F && event.isShortcutDown()) {
            search.requestFocus();
            search.selectAll();
            event.consume();
        } else if (event.getCode() == KeyCode.ESCAPE && search.isFocused()) {
            search.clear();
            grid.requestFocus();
            event.consume();
        }
    }

    private void gridKey(KeyEvent event) {
        if (event.getCode() == KeyCode.DELETE) {
            actions.deleteSelected();
        } else if (event.getCode() == KeyCode.F2) {
            details.rename();
        } else if (event.getCode() == KeyCode.D && event.isShortcutDown()) {
            actions.duplicateSelected();
        } else {
            return;
        }
        event.consume();
    }

    private void export() {
        files.toExport(window(), choice.getValue()).ifPresent(path -> {
            messages.say(texts.of("library.busy"));
            // After what is being searched and sorted, if anything is.
            searcher.execute(() -> Platform.runLater(() -> export(path)));
        });
    }

    private void export(Path path) {
        Stream<String> lines = String.valueOf(path.getFileName()).endsWith(".json") ? table.json() : table.csv();
        searcher.execute(() -> {
            String outcome = write(path, lines);
            Platform.runLater(() -> messages.say(outcome));
        });
    }

    /** What to say of it. */
    private String write(Path path, Stream<String> lines) {
        try {
            AtomicFile.write(path, out -> write(out, lines.iterator()));
            return texts.of("library.saved", path);
        } catch (IOException e) {
            return texts.sentence(Failures.sentence(path.toString(), e));
        }
    }

    private static void write(OutputStream out, Iterator<String> lines) throws IOException {
        while (lines.hasNext()) {
            out.write(lines.next().getBytes(StandardCharsets.UTF_8));
        }
    }

    private BooleanBinding noFile() {
        return Bindings.createBooleanBinding(() -> library.file().isEmpty(), library.fileProperty());
    }

    private Window window() {
        return getScene().getWindow();
    }
}
