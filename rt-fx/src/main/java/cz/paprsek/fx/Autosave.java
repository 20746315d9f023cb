package cz.paprsek.fx;

import cz.paprsek.fx.model.file.Document;
import cz.paprsek.fx.model.file.KeptText;
import cz.paprsek.fx.model.file.Recovery;
import cz.paprsek.fx.model.file.SceneSource;
import cz.paprsek.fx.model.typing.Manuscript;
import cz.paprsek.fx.model.typing.Page;
import cz.paprsek.io.Failures;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.OriginalText;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import javafx.animation.KeyFrame;
import javafx.animation.Timeline;
import javafx.application.Platform;
import javafx.util.Duration;
import org.jspecify.annotations.Nullable;

/** Keeps a copy of what is unsaved every few seconds, while nothing is being dragged. */
final class Autosave {
    private static final Duration INTERVAL = Duration.seconds(15);

    private final Document document;
    private final Manuscript manuscript;
    private final Recovery recovery;
    private final Consumer<String> onFault;
    /** Copies are written and discarded one after the other. */
    private final Object copying = new Object();
    private final AtomicInteger discards = new AtomicInteger();
    private final ExecutorService writer = Executors.newSingleThreadExecutor(work -> {
        Thread thread = new Thread(work, "paprsek-autosave");
        thread.setDaemon(true);
        return thread;
    });
    private final Timeline timer = new Timeline(new KeyFrame(INTERVAL, event -> keepIfNew()));
    private @Nullable Scene kept;
    private Optional<OriginalText> keptTyped = Optional.empty();
    private Optional<String> keptText = Optional.empty();

    Autosave(Document document, Manuscript manuscript, Recovery recovery, Consumer<String> onFault) {
        this.document = document;
        this.manuscript = manuscript;
        this.recovery = recovery;
        this.onFault = onFault;
        document.model().unsavedProperty().addListener((property, old, now) -> {
            if (!now) {
                Platform.runLater(this::keepIfNew);
            }
        });
        timer.setCycleCount(Timeline.INDEFINITE);
        timer.play();
    }

    /** Keeps a copy now if there is something unsaved that no copy has; forgets the copy if there is nothing unsaved any more, because it has been undone. */
    void keepIfNew() {
        Scene scene = document.model().scene();
        Optional<OriginalText> typed = document.model().state().typed();
        Optional<String> written = Optional.of(manuscript.page()).filter(Page::isHeld).map(Page::text);
        boolean isUnsaved = document.model().unsavedProperty().get() || written.isPresent();
        if (writer.isShutdown() || document.model().gesturingProperty().get()) {
            return;
        }
        if (!isUnsaved && kept != null) {
            kept = null;
            discards.incrementAndGet();
            Optional<SceneSource> undone = document.sourceProperty().get();
            write(() -> recovery.discard(undone));
        }
        if (!isUnsaved || (scene.equals(kept) && typed.equals(keptTyped) && written.equals(keptText))) {
            return;
        }
        kept = scene;
        keptTyped = typed;
        keptText = written;
        Optional<SceneSource> source = document.sourceProperty().get();
        KeptText text = document.text();
        int before = discards.get();
        write(() -> {
            if (before == discards.get()) {
                recovery.keep(source, scene, text);
                recovery.keepText(source, written);
            }
        });
    }

    @FunctionalInterface
    private interface Work {
        void run() throws IOException;
    }

    private void write(Work work) {
        writer.execute(() -> {
            try {
                synchronized (copying) {
                    work.run();
                }
            } catch (IOException | IllegalArgumentException e) {
                Platform.runLater(() -> onFault.accept(Failures.sentence(e)));
            }
        });
    }

    /**
     * Forgets the copy of a scene, because it was saved or given up. What is still unsaved, such as a text with mistakes, is kept anew.
     *
     * @throws IOException if it cannot be deleted
     */
    void discard(Optional<SceneSource> source) throws IOException {
        kept = null;
        discards.incrementAndGet();
        synchronized (copying) {
            recovery.discard(source);
        }
    }

    void stop() {
        timer.stop();
        writer.shutdown();
    }
}
