package cz.paprsek.fx;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.ForeignFormat;
import cz.paprsek.format.MeshFiles;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.file.Document;
import cz.paprsek.fx.model.file.FileHead;
import cz.paprsek.fx.model.file.KeptText;
import cz.paprsek.fx.model.file.PovExport;
import cz.paprsek.fx.model.file.Recovery;
import cz.paprsek.fx.model.file.SceneSource;
import cz.paprsek.fx.model.file.Settings;
import cz.paprsek.fx.model.typing.Manuscript;
import cz.paprsek.fx.view.shell.MessageBar;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.io.Failures;
import cz.paprsek.lesson.Lesson;
import cz.paprsek.lesson.LessonException;
import cz.paprsek.lesson.Lessons;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.DatabaseConflictException;
import cz.paprsek.xml.DatabaseFile;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** New, open, save and reload. What is asked, and what goes wrong, is said here; the files themselves are the model's business. */
final class FileActions {
    /** Of more that POV-Ray shows otherwise, only how many things it is. */
    private static final int MOST_TOLD = 4;

    /** A scene with where it came from. */
    private record Loaded(SceneSource.Kept kept, Optional<Path> left, Optional<DatabaseFile> database) {}

    private final Document document;
    private final Settings settings;
    private final Recovery recovery;
    private final Autosave autosave;
    private final Dialogs dialogs;
    private final Notices notices;
    private final Supplier<Texts> texts;
    private final Consumer<DatabaseFile> onDatabase;
    private final Consumer<Lesson> onLesson;
    private final Manuscript manuscript;
    /** How often a file was not written because others have changed it, each time with a question. */
    private int refusals;

    /**
     * Those of an editor.
     *
     * @param onDatabase takes a database whose first scene was opened
     * @param onLesson begins a lesson, unless the user stays with what is unsaved
     */
    FileActions(Document document, Settings settings, Recovery recovery, Autosave autosave, Dialogs dialogs, Notices notices, Supplier<Texts> texts,
            Consumer<DatabaseFile> onDatabase, Consumer<Lesson> onLesson, Manuscript manuscript) {
        this.document = document;
        this.settings = settings;
        this.recovery = recovery;
        this.autosave = autosave;
        this.dialogs = dialogs;
        this.notices = notices;
        this.texts = texts;
        this.onDatabase = onDatabase;
        this.onLesson = onLesson;
        this.manuscript = manuscript;
    }

    /** Starts from a template or example. */
    void newFrom(String template) {
        if (mayLeave()) {
            begin(Templates.read(template), Templates.pictures());
        }
    }

    /** Starts from the scene of a lesson; false if the user stays with what is unsaved. What has become of the lesson before, in no file, is not asked for. */
    boolean newFromLesson(Scene scene, Assets assets, boolean isAfterLesson) {
        boolean may = (isAfterLesson && document.sourceProperty().get().isEmpty()) || mayLeave();
        if (may) {
            begin(scene, assets);
        }
        return may;
    }

    private void begin(Scene scene, Assets assets) {
        document.openedWithoutFile(scene, assets);
        notices.quiet();
        notices.say("");
    }

    /** Opens the lesson of a file, if it is one; else says what is wrong with it. */
    void openLesson() {
        dialogs.fileToOpen(settings.recent().stream().findFirst().map(Path::getParent)).ifPresent(this::openLesson);
    }

    private void openLesson(Path file) {
        Background.run("paprsek-lesson", () -> Lessons.read(file), onLesson, fault -> failed(file, fault));
    }

    void open() {
        Optional<Path> folder = document.sourceProperty().get().map(source -> source.file().getParent())
                .or(() -> settings.recent().stream().findFirst().map(Path::getParent));
        dialogs.fileToOpen(folder).ifPresent(this::open);
    }

    /** Opens a file; if something is wrong with it, says what, and stays with the scene there is. One of another program becomes a scene that is not saved; a lesson begins. */
    void open(Path file) {
        String name = String.valueOf(file.getFileName());
        Optional<ForeignFormat> foreign = ForeignFormat.ofName(name);
        FileHead head = FileHead.of(file);
        if (foreign.isEmpty() && head.isOther()) {
            notices.problems("", List.of());
            notices.say(texts.get().of("file.other", name, ForeignFormat.meshes()));
        } else if (foreign.isEmpty() && head.isLesson()) {
            openLesson(file);
        } else if (mayLeave()) {
            if (foreign.isPresent()) {
                bring(file, name, foreign.get());
            } else {
                load(() -> read(file), file);
            }
        }
    }

    private void bring(Path file, String name, ForeignFormat format) {
        notices.say(texts.get().of("file.opening", name));
        Assets assets = Assets.beside(file);
        Background.run("paprsek-open", () -> SceneMeshes.brought(name, format, assets), read -> {
            forgetCopy();
            document.brought(read.scene(), assets);
            notices.quiet();
            notices.say(String.join("; ", Stream.concat(Stream.of(texts.get().of("file.opened", name)), read.notes().stream().map(texts.get()::sentence)).toList()));
        }, fault -> failed(file, fault));
    }

    /** Opens a scene that is kept in a database, as it was read from there. */
    void open(SceneSource source, Scene scene) {
        if (mayLeave()) {
            load(() -> new Loaded(new SceneSource.Kept(source, scene, KeptText.NONE), recovery.left(Optional.of(source)), Optional.empty()), source.file());
        }
    }

    /** Takes note that the scene that is edited is kept in a database from now on, under that name. */
    void kept(SceneSource source, Scene scene) {
        Optional<SceneSource> before = document.sourceProperty().get();
        document.model().edit(Label.of(Label.Edit.RENAME, scene.name()), old -> scene);
        document.kept(source, scene);
        try {
            autosave.discard(before);
        } catch (IOException e) {
            notices.wrong(Failures.sentence(e));
        }
    }

    private void load(Callable<Loaded> reading, Path file) {
        notices.say(texts.get().of("file.opening", file.getFileName()));
        Background.run("paprsek-open", reading, this::opened, fault -> failed(file, fault));
    }

    /** Reads a scene, or a database and its first scene. */
    private Loaded read(Path file) throws IOException, SceneFileException {
        if (!SceneFiles.isDatabase(file)) {
            SceneSource source = SceneSource.file(file);
            SceneSource.Kept kept = source.read();
            return new Loaded(new SceneSource.Kept(source, withMeshes(kept.scene(), file), kept.text()), recovery.left(Optional.of(source)), Optional.empty());
        }
        DatabaseFile database = DatabaseFile.open(file);
        Scene first = database.database().scenes().stream().findFirst()
                .orElseThrow(() -> new IOException(file + ": there is no scene in this database"));
        SceneSource source = SceneSource.inDatabase(file, first.name());
        return new Loaded(new SceneSource.Kept(source, first, KeptText.of(database)), recovery.left(Optional.of(source)), Optional.of(database));
    }

    /** With the triangles of meshes. What is wrong with them is told by the picture. */
    private static Scene withMeshes(Scene scene, Path file) {
        return SceneMeshes.drawable(MeshFiles.read(scene, Assets.beside(file), (place, problem) -> {}));
    }

    private void opened(Loaded loaded) {
        forgetCopy();
        SceneSource source = loaded.kept().source();
        document.opened(loaded.kept());
        settings.addRecent(source.file());
        notices.quiet();
        notices.say(texts.get().of("file.opened", source.title()));
        loaded.left().ifPresent(copy -> offer(Optional.of(source), copy));
        loaded.database().ifPresent(onDatabase);
    }

    private void failed(Path file, Throwable fault) {
        if (fault instanceof SceneFileException wrong) {
            notices.say("");
            notices.problems(texts.get().of("file.problems", file.getFileName(), wrong.problems().size()), wrong.problems());
        } else if (fault instanceof LessonException wrong) {
            notices.problems(texts.get().of("lesson.problems", file.getFileName(), wrong.problems().size()), wrong.problems());
        } else if (fault instanceof IOException unreadable) {
            notices.problems("", List.of());
            notices.wrong(Failures.sentence(file.toString(), unreadable));
        } else {
            notices.say("");
            dialogs.fault(fault, this::saveAs);
        }
    }

    /** Offers what an earlier process left that has not been saved. */
    void offerUntitled() {
        Background.run("paprsek-recovery", () -> recovery.left(Optional.empty()),
                left -> left.ifPresent(copy -> offer(Optional.empty(), copy)), fault -> failed(recovery.place(Optional.empty()), fault));
    }

    private void offer(Optional<SceneSource> source, Path copy) {
        notices.ask(source.map(known -> texts.get().of("recovery.of", known.title())).orElseGet(() -> texts.get().of("recovery.untitled")), List.of(
                new MessageBar.Choice("recovery-restore", texts.get().of("recovery.restore"), () -> restore(source, copy)),
                new MessageBar.Choice("recovery-discard", texts.get().of("recovery.discard"), () -> delete(copy))));
    }

    private void restore(Optional<SceneSource> source, Path copy) {
        Background.run("paprsek-restore", () -> Map.entry(Recovery.read(copy), Recovery.textBeside(copy)), left -> {
            document.recovered(source, left.getKey());
            left.getValue().ifPresent(written -> {
                manuscript.restore(written);
                notices.say(texts.get().of("xml.restored"));
            });
            delete(copy);
        }, fault -> failed(copy, fault));
    }

    private void delete(Path copy) {
        try {
            Recovery.delete(copy);
        } catch (IOException e) {
            notices.wrong(Failures.sentence(copy.toString(), e));
        }
    }

    /** Saves where the scene is kept, or asks where; false if it was not saved. */
    boolean save() {
        return document.sourceProperty().get().map(this::save).orElseGet(this::saveAs);
    }

    boolean saveAs() {
        Optional<Path> suggestion = document.sourceProperty().get().map(SceneSource::file).or(() -> Optional.of(Path.of(fileName())));
        Optional<Path> chosen = dialogs.fileToSave(suggestion);
        if (chosen.isEmpty()) {
            return false;
        }
        try {
            if (Files.exists(chosen.get()) && SceneFiles.isDatabase(chosen.get())) {
                notices.say(texts.get().of("file.is-database", chosen.get().getFileName()));
                return false;
            }
        } catch (IOException unreadable) {
            notices.wrong(Failures.sentence(chosen.get().toString(), unreadable));
            return false;
        }
        return save(SceneSource.file(chosen.get()));
    }

    /** Asks where, and writes the scene for POV-Ray. */
    void exportPov() {
        Optional<Path> own = document.sourceProperty().get().map(SceneSource::file);
        String name = fileName().replaceFirst("xml$", "pov");
        dialogs.povToSave(own.map(file -> file.resolveSibling(name)).orElse(Path.of(name))).filter(file -> isSettled("xml.export-without", () -> exportPov(file))).ifPresent(this::exportPov);
    }

    private void exportPov(Path target) {
        Scene scene = document.model().scene();
        Assets assets = document.model().assets();
        Background.run("paprsek-export", () -> PovExport.write(scene, assets, target), differences -> exported(target.getFileName(), differences),
                fault -> failed(target, fault));
    }

    private void exported(Path name, List<String> differences) {
        notices.quiet();
        notices.say(differences.isEmpty() ? texts.get().of("file.exported", name) : "");
        if (!differences.isEmpty()) {
            String first = differences.stream().limit(MOST_TOLD).map(texts.get()::sentence).collect(Collectors.joining("; "));
            int more = differences.size() - MOST_TOLD;
            notices.ask(texts.get().of("file.exported-but", name, more > 0 ? first + "; " + texts.get().of("file.exported-more", more) : first), List.of());
        }
    }

    private boolean save(SceneSource source) {
        return isSettled("xml.save-without", () -> write(source)) && write(source);
    }

    /** What is written in the scene's text belongs to it; if that is not valid, nothing is written before the user has said so. */
    private boolean isSettled(String without, Runnable anyway) {
        if (manuscript.flush()) {
            return true;
        }
        manuscript.page().problems().stream().findFirst().ifPresent(problem -> notices.ask(
                texts.get().of("xml.held", problem.line(), texts.get().sentence(problem.message())), List.of(
                        new MessageBar.Choice("xml-go-there", texts.get().of("xml.go-there"), manuscript::point),
                        new MessageBar.Choice("xml-save-without", texts.get().of(without), anyway))));
        return false;
    }

    private boolean write(SceneSource source) {
        Optional<SceneSource> before = document.sourceProperty().get();
        try {
            document.save(source);
            autosave.discard(before);
        } catch (IOException | SceneFileException | IllegalArgumentException e) {
            List<MessageBar.Choice> choices = new ArrayList<>();
            choices.add(new MessageBar.Choice("save-elsewhere", texts.get().of("file.save-elsewhere"), this::saveAs));
            if (e instanceof DatabaseConflictException && before.equals(Optional.of(source))) {
                refusals++;
                document.noticeDisk();
                choices.add(new MessageBar.Choice("disk-reload", texts.get().of("file.reload"), this::reload));
                choices.add(new MessageBar.Choice("disk-keep", texts.get().of("file.keep"), () -> Background.run("paprsek-reload", source::read,
                        document::noticeDisk, fault -> failed(source.file(), fault))));
            }
            notices.ask(texts.get().of("file.not-saved", source.title(), texts.get().sentence(Failures.sentence(e))), choices);
            return false;
        }
        settings.addRecent(source.file());
        notices.quiet();
        notices.say(texts.get().of("file.saved", source.title()));
        return true;
    }

    /** Looks whether the file was changed by somebody else: takes it over if nothing is unsaved here, else asks. */
    void checkDisk() {
        if (document.hasChangedOnDisk()) {
            document.noticeDisk();
            int before = refusals;
            document.sourceProperty().get().ifPresent(source -> Background.run("paprsek-reload", source::read,
                    read -> changedOnDisk(read, before), fault -> failed(source.file(), fault)));
        }
    }

    /** In a database, only other scenes may have changed. If a save has been refused since it was looked at, that has been asked about. */
    private void changedOnDisk(SceneSource.Kept read, int refusalsBefore) {
        if (refusals != refusalsBefore || document.knows(read) || !document.sourceProperty().get().equals(Optional.of(read.source()))) {
            return;
        }
        if (document.model().unsavedProperty().get()) {
            String title = document.sourceProperty().get().map(SceneSource::title).orElse("");
            notices.ask(texts.get().of("file.changed", title), List.of(
                    new MessageBar.Choice("disk-reload", texts.get().of("file.reload"), this::reload),
                    new MessageBar.Choice("disk-keep", texts.get().of("file.keep"), () -> document.noticeDisk(read))));
        } else {
            reloaded(read);
        }
    }

    /** Takes over what is on disk, as a step that can be undone. */
    void reload() {
        document.sourceProperty().get().ifPresent(source -> Background.run("paprsek-reload", source::read,
                this::reloaded, fault -> failed(source.file(), fault)));
    }

    private void reloaded(SceneSource.Kept read) {
        document.reloaded(Label.of(Label.Edit.RELOAD, read.source().title()), read);
        notices.quiet();
        notices.say(texts.get().of("file.reloaded", read.source().title()));
    }

    /** Whether this scene may be left: nothing is unsaved, or the user saves it or gives it up. */
    boolean mayLeave() {
        if (!document.model().unsavedProperty().get() && !manuscript.heldProperty().get()) {
            return true;
        }
        String title = document.sourceProperty().get().map(SceneSource::title).orElseGet(() -> texts.get().of("window.untitled"));
        boolean may = switch (dialogs.aboutUnsaved(title)) {
            case SAVE -> save();
            case DISCARD -> true;
            case STAY -> false;
        };
        if (may) {
            forgetCopy();
        }
        return may;
    }

    private void forgetCopy() {
        try {
            autosave.discard(document.sourceProperty().get());
        } catch (IOException e) {
            notices.wrong(Failures.sentence(e));
        }
    }

    private String fileName() {
        String name = document.model().scene().name().replaceAll("[^\\p{L}\\p{N}._-]+", "-");
        return (name.isBlank() || name.equals("-") ? "scene" : name) + ".xml";
    }
}
