package cz.paprsek.fx;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.scene.Scene;
import cz.paprsek.warning.SceneWarning;
import cz.paprsek.warning.SceneWarnings;
import java.util.List;
import java.util.function.Consumer;
import javafx.animation.PauseTransition;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.WeakChangeListener;
import javafx.concurrent.Task;
import javafx.util.Duration;

/** Looks in the background, whenever the scene has come to rest, for what in it is hardly meant: as seen by the camera that is looked through. */
final class SceneWatch {
    private static final Duration REST = Duration.millis(700);

    private final EditorModel model;
    private final Consumer<List<SceneWarning>> listener;
    private final PauseTransition rest = new PauseTransition(REST);
    /** Held here, because the model, which outlives the window, holds it weakly. */
    private final ChangeListener<EditorState> onState = (property, old, now) -> changed(old, now);
    private final ChangeListener<EditorState> weak = new WeakChangeListener<>(onState);
    private boolean busy;

    /** @param listener is told on JavaFX's thread */
    SceneWatch(EditorModel model, Consumer<List<SceneWarning>> listener) {
        this.model = model;
        this.listener = listener;
        rest.setOnFinished(event -> look());
        model.stateProperty().addListener(weak);
        rest.playFromStart();
    }

    private void changed(EditorState old, EditorState now) {
        if (old.eye() != now.eye() || !old.scene().equals(now.scene())) {
            rest.playFromStart();
        }
    }

    private void look() {
        if (busy) {
            // Begun again when that has ended.
            return;
        }
        busy = true;
        Scene scene = model.state().seen();
        Task<List<SceneWarning>> task = new Task<>() {
            @Override
            protected List<SceneWarning> call() {
                return SceneWarnings.of(scene).stream().filter(warning -> !warning.isNote()).toList();
            }
        };
        task.setOnSucceeded(event -> {
            busy = false;
            if (scene.equals(model.state().seen())) {
                listener.accept(task.getValue());
            } else {
                rest.playFromStart();
            }
        });
        task.setOnFailed(event -> {
            busy = false;
            throw new IllegalStateException("a scene could not be checked", task.getException());
        });
        Thread thread = new Thread(task, "paprsek-warnings");
        thread.setDaemon(true);
        thread.start();
    }

    /** Looks no more. */
    void close() {
        model.stateProperty().removeListener(weak);
        rest.stop();
    }
}
