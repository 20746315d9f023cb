package cz.paprsek.fx;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.file.Document;
import cz.paprsek.fx.model.file.Recovery;
import cz.paprsek.fx.model.file.SceneSource;
import cz.paprsek.fx.model.file.Settings;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.model.typing.Manuscript;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.command.FileFinder;
import cz.paprsek.fx.view.explain.TreeChooser;
import cz.paprsek.fx.view.lesson.LessonDesk;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.manual.ManualWindow;
import cz.paprsek.fx.view.shell.MessageBar;
import cz.paprsek.fx.view.texts.BuiltInWords;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.lesson.Lesson;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.DatabaseFile;
import cz.paprsek.xml.Problem;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import javafx.animation.KeyFrame;
import javafx.animation.Timeline;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.value.ObservableValue;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;
import javafx.util.Duration;
import org.jspecify.annotations.Nullable;

/** One open editor: what lives as long as its stage does, while the window's content is made anew for each language. */
final class Editor implements Notices {
    private static final Duration LOOK_AT_DISK = Duration.seconds(2);

    private static final double LEAST_WIDTH = 800;
    private static final double LEAST_HEIGHT = 500;

    private final Stage stage;
    private final EditorModel model = new EditorModel(Scene.EMPTY);
    private final Clock clock = new Clock(model);
    private final Document document = new Document(model);
    private final Manuscript manuscript = new Manuscript(model, () -> document.text().original(), new Manuscript.Worker() {
        @Override
        public <T> void run(Callable<T> work, Consumer<T> done, Consumer<Throwable> failed) {
            Background.run("paprsek-text", work, done, failed);
        }
    });
    private final Settings settings;
    private final FileActions files;
    private final Autosave autosave;
    private final Dialogs dialogs;
    private final RenderWindow renders;
    private final LibraryWindow library;
    private final MistakesWindow mistakes;
    private final PresenterWindow presenter;
    private final LessonDesk lessons;
    private final ManualWindow manual;
    private final BuiltInWords builtIn;
    private final ObjectProperty<Theme> theme;
    private final ObjectProperty<Texts> texts;
    private final BooleanProperty snapping = new SimpleBooleanProperty(true);
    private final BooleanProperty proportional = new SimpleBooleanProperty(true);
    private final Timeline disk = new Timeline(new KeyFrame(LOOK_AT_DISK, event -> lookAtDisk()));
    private @Nullable MainWindow window;
    private boolean started;
    private boolean inFault;
    private boolean picturesOffered;

    /**
     * @param folder where settings, and copies of scenes without a file, are kept
     * @param system the system's language, for as long as the user has chosen none
     * @param asking makes the dialogs
     */
    Editor(Stage stage, Path folder, Locale system, DialogMaker asking) {
        this.stage = stage;
        this.settings = new Settings(folder, this::wrong);
        this.theme = new SimpleObjectProperty<>(settings.get("theme").filter("DARK"::equals).isPresent() ? Theme.DARK : Theme.LIGHT);
        this.texts = new SimpleObjectProperty<>(Texts.in(settings.get("language").map(Locale::forLanguageTag).orElse(system)));
        this.builtIn = new BuiltInWords(texts::get);
        this.dialogs = asking.make(stage, texts::get);
        Recovery recovery = new Recovery(folder);
        this.autosave = new Autosave(document, manuscript, recovery, this::wrong);
        this.files = new FileActions(document, settings, recovery, autosave, dialogs, this, texts::get, this::showLibrary, this::begin, manuscript);
        this.renders = new RenderWindow(this, dialogs, folder);
        this.library = new LibraryWindow(this, document, dialogs);
        this.mistakes = new MistakesWindow(this);
        this.presenter = new PresenterWindow(this);
        this.lessons = new LessonDesk(model, files::newFromLesson);
        this.manual = new ManualWindow(texts::get, theme::get, open -> WindowPlace.keep(open, settings, "window.manual", () -> Sizes.opened(open, 1120, 760, Optional.empty())));
        stage.setScene(new javafx.scene.Scene(new javafx.scene.layout.StackPane(), 1280, 800));
        stage.setMinWidth(LEAST_WIDTH);
        stage.setMinHeight(LEAST_HEIGHT);
        texts.addListener((property, old, now) -> build());
        theme.addListener((property, old, now) -> {
            now.applyTo(stage.getScene());
            settings.set("theme", now.name());
        });
        model.unsavedProperty().addListener((property, old, now) -> showTitle());
        manuscript.heldProperty().addListener((property, old, now) -> showTitle());
        document.sourceProperty().addListener((property, old, now) -> showTitle());
        stage.focusedProperty().addListener((property, old, now) -> lookAtDisk());
        stage.setOnCloseRequest(this::closing);
        disk.setCycleCount(Timeline.INDEFINITE);
        disk.play();
        build();
    }

    /** Makes dialogs for a window. */
    @FunctionalInterface
    interface DialogMaker {
        Dialogs make(Stage owner, java.util.function.Supplier<Texts> texts);
    }

    EditorModel model() {
        return model;
    }

    /** Which time of the scene is looked at. */
    Clock clock() {
        return clock;
    }

    /** The text of the scene, to be written in. */
    Manuscript manuscript() {
        return manuscript;
    }

    Document document() {
        return document;
    }

    FileFinder fileFinder() {
        return new SceneFolder(document, dialogs, texts());
    }

    /** What brings meshes into the scene, by the edits of a window. */
    SceneMeshes meshes(Edits edits) {
        return new SceneMeshes(document, dialogs, this, texts(), edits);
    }

    FileActions files() {
        return files;
    }

    Settings settings() {
        return settings;
    }

    /** The theme for what lives shorter than the editor, whose listeners are not held by it. To be held by whoever asks. */
    ObservableValue<Theme> followTheme() {
        ObjectProperty<Theme> follower = new SimpleObjectProperty<>();
        follower.bind(theme);
        return follower;
    }

    ObjectProperty<Theme> theme() {
        return theme;
    }

    Texts texts() {
        return texts.get();
    }

    BooleanProperty snapping() {
        return snapping;
    }

    /** Whether the three factors of a scale stay in proportion: the chain. */
    BooleanProperty proportional() {
        return proportional;
    }

    Stage stage() {
        return stage;
    }

    /** Whether the live picture shows the scene in full quality. */
    boolean isPictureComplete() {
        return window != null && window.isPictureComplete();
    }

    TreeChooser treeChooser() {
        return dialogs.treeChooser(texts());
    }

    RenderWindow renders() {
        return renders;
    }

    LibraryWindow library() {
        return library;
    }

    MistakesWindow mistakes() {
        return mistakes;
    }

    PresenterWindow presenter() {
        return presenter;
    }

    LessonDesk lessons() {
        return lessons;
    }

    ManualWindow manual() {
        return manual;
    }

    /** Shows where to begin. */
    void welcome() {
        if (window != null) {
            window.welcome();
        }
    }

    /** Changes the language of the window, now and for later. */
    void setLanguage(Locale language) {
        settings.set("language", language.toLanguageTag());
        texts.set(Texts.in(language));
    }

    private void begin(Lesson lesson) {
        lessons.open(lesson);
    }

    /** Opens what the program was started for: a file, else the given scene without one. */
    void start(Optional<Path> file, Scene otherwise) {
        document.openedWithoutFile(otherwise, Templates.pictures());
        file.ifPresent(files::open);
        files.offerUntitled();
        started = true;
    }

    /** Closes the window unless the user stays because of what is unsaved. */
    void quit() {
        WindowEvent request = new WindowEvent(stage, WindowEvent.WINDOW_CLOSE_REQUEST);
        stage.fireEvent(request);
        if (!request.isConsumed()) {
            stage.close();
        }
    }

    /** Ends all that runs, without asking. */
    void close() {
        autosave.stop();
        disk.stop();
        renders.close();
        library.close();
        mistakes.close();
        presenter.close();
        manual.close();
        builtIn.close();
        if (window != null) {
            window.close();
        }
    }

    /** A fault of the program: the scene is kept at once, and the user told. A picture that is missing or damaged is none, and told in a line. */
    void fault(Throwable fault) {
        if (fault instanceof UncheckedIOException unreadable) {
            wrong(String.valueOf(unreadable.getMessage()));
            return;
        }
        if (inFault) {
            return;
        }
        inFault = true;
        try {
            autosave.keepIfNew();
            dialogs.fault(fault, files::saveAs);
        } finally {
            inFault = false;
        }
    }

    @Override
    public void say(String sentence) {
        if (window != null) {
            window.status().showMessage(sentence);
        }
    }

    @Override
    public void wrong(String english) {
        if (window != null) {
            say(texts().sentence(english));
        }
    }

    /** Takes back what was said, if nothing else has been since. */
    void unsay(String sentence) {
        if (window != null) {
            window.status().endMessage(sentence);
        }
    }

    @Override
    public void ask(String sentence, List<MessageBar.Choice> choices) {
        if (window != null) {
            window.messages().show(sentence, choices);
        }
    }

    @Override
    public void problems(String header, List<Problem> problems) {
        if (window != null) {
            if (problems.isEmpty()) {
                window.problems().hide();
            } else {
                window.problems().show(header, problems);
            }
        }
    }

    @Override
    public void quiet() {
        if (window != null) {
            window.messages().hide();
            window.problems().hide();
        }
    }

    private void build() {
        if (window != null) {
            window.close();
        }
        MainWindow fresh = new MainWindow(this);
        window = fresh;
        theme.get().mark(fresh.root());
        stage.getScene().setRoot(fresh.root());
        theme.get().applyTo(stage.getScene());
        library.fill();
        mistakes.fill();
        presenter.translate();
        renders.translate();
        manual.translate();
        showTitle();
    }

    private void showLibrary(DatabaseFile opened) {
        library.show(opened);
    }

    private void showTitle() {
        String name = document.sourceProperty().get().map(SceneSource::title).orElseGet(() -> texts().of("window.untitled"));
        stage.setTitle((model.unsavedProperty().get() || manuscript.heldProperty().get() ? "● " : "") + name + " – Paprsek");
    }

    private void lookAtDisk() {
        if (started && !picturesOffered && window != null && !window.messages().isVisible()) {
            // After what else is asked at the start.
            picturesOffered = true;
            renders.offerLeft();
        }
        if (!model.gesturingProperty().get()) {
            files.checkDisk();
            library.checkDisk();
        }
    }

    private void closing(WindowEvent event) {
        if (files.mayLeave() && library.mayLeave()) {
            close();
        } else {
            event.consume();
        }
    }
}
