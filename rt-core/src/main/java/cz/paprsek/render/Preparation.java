package cz.paprsek.render;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * The monitor as it is asked, by several threads, while a scene is prepared: an interrupt of the thread that waits for the scene counts as well, and what the
 * monitor throws ends the preparation like a wish to cancel, to be told in the end.
 */
final class Preparation implements RenderMonitor {
    private final RenderMonitor monitor;
    private final Thread waiting = Thread.currentThread();
    private volatile @Nullable Throwable fault;

    Preparation(RenderMonitor monitor) {
        this.monitor = Objects.requireNonNull(monitor, "monitor");
    }

    @Override
    public boolean cancelled() {
        try {
            return fault != null || waiting.isInterrupted() || monitor.cancelled();
        } catch (Throwable thrown) {
            // Not thrown on: the pool that prepares would hand on a copy of it.
            fault = thrown;
            return true;
        }
    }

    /** @throws IllegalStateException if the monitor has thrown something, with that as its cause */
    void throwFault() {
        Throwable thrown = fault;
        if (thrown != null) {
            throw new IllegalStateException("the monitor of a preparation failed: " + thrown, thrown);
        }
    }
}
