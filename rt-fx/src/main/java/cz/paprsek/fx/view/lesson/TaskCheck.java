package cz.paprsek.fx.view.lesson;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.view.library.Worker;
import cz.paprsek.lesson.Task;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.scene.Scene;
import java.io.UncheckedIOException;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import javafx.animation.PauseTransition;
import javafx.application.Platform;
import javafx.util.Duration;

/** Looks whether a task is done in the scene as it is now, on a thread of its own; what has been overtaken by another change is given up. */
final class TaskCheck {
    private static final Duration REST = Duration.millis(150);

    private final ExecutorService worker = Worker.named("lesson-task");
    private final PauseTransition rest = new PauseTransition(REST);
    /** Counts what has been asked. */
    private final AtomicInteger turn = new AtomicInteger();

    /** How a task stands. */
    enum State { DONE, OPEN, OTHER_SCENE }

    /** Waits until the scene has been at rest for a moment, so that a drag does not look at each step. */
    void look(Task task, Scene scene, Assets assets, Consumer<State> told) {
        int mine = turn.incrementAndGet();
        rest.setOnFinished(event -> worker.execute(() -> work(mine, task, scene, assets, told)));
        rest.playFromStart();
    }

    private void work(int mine, Task task, Scene scene, Assets assets, Consumer<State> told) {
        RenderMonitor whileWanted = new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return turn.get() != mine;
            }
        };
        try {
            boolean isDone = task.isDone(scene, assets, whileWanted);
            tell(mine, isDone ? State.DONE : State.OPEN, told);
        } catch (CancellationException overtaken) {
            // The next look is under way.
        } catch (UncheckedIOException | IllegalStateException | IllegalArgumentException notToBeSeen) {
            // The picture of the camera says what is wrong with the scene; a task is not done in what cannot be seen.
            tell(mine, State.OPEN, told);
        }
    }

    private void tell(int mine, State state, Consumer<State> told) {
        Platform.runLater(() -> {
            if (turn.get() == mine) {
                told.accept(state);
            }
        });
    }

    /** Gives up what has been asked, if it has not been told yet. */
    void cancel() {
        turn.incrementAndGet();
        rest.stop();
    }

    void close() {
        cancel();
        worker.shutdown();
    }
}
