package cz.paprsek.fx.view.motion;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.motion.Clock;
import java.util.function.Consumer;
import javafx.animation.AnimationTimer;

/** Looks at one frame after the other, as fast as the film is; what cannot be shown in time is left out. Ends where something leads to rest. */
final class Player extends AnimationTimer {
    private final EditorModel model;
    private final Clock clock;
    private final Consumer<Boolean> onRuns;
    private boolean runs;
    private long begun;
    private int first;

    /** @param onRuns hears whether it runs, at each beginning and end */
    Player(EditorModel model, Clock clock, Consumer<Boolean> onRuns) {
        this.model = model;
        this.clock = clock;
        this.onRuns = onRuns;
    }

    boolean runs() {
        return runs;
    }

    @Override
    public void start() {
        begun = 0;
        runs = true;
        onRuns.accept(true);
        super.start();
    }

    @Override
    public void stop() {
        runs = false;
        onRuns.accept(false);
        super.stop();
    }

    @Override
    public void handle(long now) {
        boolean isAtRest = clock.secondsProperty().get().isEmpty();
        if (begun != 0 && isAtRest) {
            stop();
            return;
        }
        Clock.Span span = clock.span();
        if (begun == 0) {
            begun = now;
            boolean isWithin = clock.frame() >= span.from() && clock.frame() < span.to();
            first = isWithin ? clock.frame() - span.from() : 0;
        }
        long passed = (long) ((now - begun) * 1e-9 * model.scene().settings().fps());
        int frame = span.from() + (int) ((first + passed) % (span.to() - span.from() + 1));
        if (frame != clock.frame() || isAtRest) {
            clock.lookAtFrame(frame);
        }
    }
}
