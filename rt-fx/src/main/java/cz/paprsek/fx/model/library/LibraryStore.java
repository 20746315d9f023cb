package cz.paprsek.fx.model.library;

import cz.paprsek.fx.model.file.FileStamp;
import cz.paprsek.io.Failures;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.xml.DatabaseFile;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.FutureTask;
import java.util.function.Consumer;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import org.jspecify.annotations.Nullable;

/**
 * Keeps a library and its file in step: every edit is written at once, and what others write comes in, scene by scene. Where both changed one
 * scene nothing is written, and {@link #refusalProperty} says so, until the edit is undone or {@link #reload} gives it up. For JavaFX's
 * thread; files are read and written on another.
 */
public final class LibraryStore {
    private final Library library;
    private final Executor background;
    private final Executor foreground;
    private final ReadOnlyStringWrapper refusal = new ReadOnlyStringWrapper("");
    private Optional<FileStamp> stamp = Optional.empty();
    private @Nullable Job job;

    /**
     * @param background runs one task after the other
     * @param foreground runs tasks on JavaFX's thread
     */
    public LibraryStore(Library library, Executor background, Executor foreground) {
        this.library = library;
        this.background = background;
        this.foreground = foreground;
        library.databaseProperty().subscribe(database -> writeIfUnsaved());
    }

    /** A file that is being read or written, and what is done with it then. */
    private record Job(FutureTask<DatabaseFile> work, Consumer<DatabaseFile> then, Consumer<String> failed) {}

    /** Why the last edits are not in the file; empty if they are, or soon will be. */
    public ReadOnlyStringProperty refusalProperty() {
        return refusal.getReadOnlyProperty();
    }

    /**
     * Opens a database, unless the one that is open has edits that its file refused.
     *
     * @param failed is told in a sentence what is wrong with the file
     */
    public void open(Path path, Consumer<String> failed) {
        if (!flush()) {
            failed.accept(refusal.get());
            return;
        }
        Optional<FileStamp> before = FileStamp.of(path);
        start(() -> DatabaseFile.open(path), opened -> opened(opened, before), failed);
    }

    /** Takes a database that was read by somebody else, unless it is open already. */
    public void opened(DatabaseFile opened) {
        if (library.path().equals(Optional.of(opened.path().toAbsolutePath()))) {
            checkDisk();
        } else if (flush()) {
            opened(opened, Optional.empty());
        }
    }

    /**
     * Begins a new database, which becomes a file at once.
     *
     * @param failed is told if there is such a file
     */
    public void create(Path path, Consumer<String> failed) {
        if (!flush()) {
            failed.accept(refusal.get());
        } else {
            start(() -> DatabaseFile.create(path).save(SceneDatabase.EMPTY), created -> opened(created, FileStamp.of(path)), failed);
        }
    }

    /** Takes in what others have changed in the file, if it is another one than was read or written last. */
    public void checkDisk() {
        Optional<FileStamp> now = library.path().flatMap(FileStamp::of);
        if (job == null && now.isPresent() && !now.equals(stamp)) {
            stamp = now;
            if (library.unsavedProperty().get()) {
                writeIfUnsaved();
            } else {
                library.path().ifPresent(path -> start(() -> DatabaseFile.open(path), this::merge, refusal::set));
            }
        }
    }

    /** Gives up what the file has refused, and reads it again. */
    public void reload() {
        library.path().ifPresent(path -> open(path, FileStamp.of(path)));
    }

    /** Tries once more to write what the file has refused. */
    public void retry() {
        writeIfUnsaved();
    }

    /** Waits until everything is in the file; whether it is. */
    public boolean flush() {
        Job pending = job;
        if (pending != null) {
            // Done here if it has not begun.
            pending.work().run();
            finish(pending);
        }
        while (library.unsavedProperty().get() && refusal.get().isEmpty()) {
            Job last = write();
            last.work().run();
            finish(last);
        }
        return !library.unsavedProperty().get();
    }

    private void open(Path path, Optional<FileStamp> before) {
        start(() -> DatabaseFile.open(path), opened -> opened(opened, before), refusal::set);
    }

    private void opened(DatabaseFile opened, Optional<FileStamp> known) {
        stamp = known;
        refusal.set("");
        library.open(opened);
    }

    private void writeIfUnsaved() {
        if (job == null && library.unsavedProperty().get()) {
            Job writing = write();
            background.execute(() -> run(writing));
        } else if (job == null) {
            refusal.set("");
        }
    }

    private Job write() {
        DatabaseFile file = library.file().orElseThrow();
        SceneDatabase content = library.database();
        // What was refused stays said while it is tried again, else the sentence and its button would flicker under the mouse.
        Job writing = new Job(new FutureTask<>(() -> file.save(content)), written -> {
            stamp = FileStamp.of(written.path());
            refusal.set("");
            library.saved(content, written);
        }, refusal::set);
        job = writing;
        return writing;
    }

    private void merge(DatabaseFile read) {
        library.saved(library.file().orElseThrow().database(), read);
    }

    private void start(Callable<DatabaseFile> work, Consumer<DatabaseFile> then, Consumer<String> failed) {
        Job started = new Job(new FutureTask<>(work), then, failed);
        job = started;
        background.execute(() -> run(started));
    }

    private void run(Job running) {
        running.work().run();
        foreground.execute(() -> finish(running));
    }

    /** Does what was to be done with the file; once, whoever comes first. */
    private void finish(Job done) {
        if (!done.equals(job)) {
            return;
        }
        try {
            DatabaseFile file = done.work().get();
            job = null;
            done.then().accept(file);
            writeIfUnsaved();
        } catch (ExecutionException e) {
            job = null;
            done.failed().accept(Failures.sentence(e.getCause() == null ? e : e.getCause()));
        } catch (IllegalArgumentException conflict) {
            refusal.set(String.valueOf(conflict.getMessage()));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
