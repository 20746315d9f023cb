package cz.paprsek.fx.view.command;

import javafx.application.Platform;
import javafx.scene.Node;
import javafx.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Does something before the next frame is laid out, once, however often it is asked for until then: a mouse tells of more places than there are frames. */
public final class NextFrame {
    private final Node node;
    private final Runnable work;
    private final Runnable listener = this::now;
    private @Nullable Scene awaited;

    /** @param node in whose window the frame is */
    public NextFrame(Node node, Runnable work) {
        this.node = node;
        this.work = work;
    }

    public void ask() {
        if (awaited == null && node.getScene() != null) {
            awaited = node.getScene();
            awaited.addPreLayoutPulseListener(listener);
            Platform.requestNextPulse();
        }
    }

    /** Does at once what has been asked for, if anything has. */
    public void now() {
        if (awaited != null) {
            drop();
            work.run();
        }
    }

    /** Forgets what has been asked for. */
    public void drop() {
        if (awaited != null) {
            awaited.removePreLayoutPulseListener(listener);
            awaited = null;
        }
    }
}
