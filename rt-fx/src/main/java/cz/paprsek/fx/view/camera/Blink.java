package cz.paprsek.fx.view.camera;

import cz.paprsek.scene.ScenePath;
import java.util.Set;
import javafx.animation.Animation;
import javafx.animation.KeyFrame;
import javafx.animation.Timeline;
import javafx.util.Duration;

/** Has things be away and there again, a few times. */
final class Blink {
    private static final Duration TIME = Duration.millis(450);
    private static final int TIMES = 3;

    private final Timeline timeline = new Timeline();
    private final Runnable onChanged;
    private Set<ScenePath> without = Set.of();

    /** @param onChanged is told when other things are away */
    Blink(Runnable onChanged) {
        this.onChanged = onChanged;
        timeline.setCycleCount(TIMES);
    }

    void start(Set<ScenePath> items) {
        timeline.stop();
        timeline.getKeyFrames().setAll(new KeyFrame(Duration.ZERO, event -> leaveOut(items)), new KeyFrame(TIME, event -> leaveOut(Set.of())), new KeyFrame(TIME.multiply(2)));
        timeline.playFromStart();
    }

    boolean isRunning() {
        return timeline.getStatus() == Animation.Status.RUNNING;
    }

    /** All is there again, if anything was away. */
    void end() {
        if (isRunning()) {
            stop();
            leaveOut(Set.of());
        }
    }

    /** Tells nobody any more. */
    void stop() {
        timeline.stop();
    }

    /** What is away now. */
    Set<ScenePath> without() {
        return without;
    }

    private void leaveOut(Set<ScenePath> items) {
        without = items;
        onChanged.run();
    }
}
