package cz.paprsek.fx.view.library;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/** Threads that do one task after the other, and do not keep the program alive. */
public final class Worker {
    private Worker() {}

    /** A thread of that name. */
    public static ExecutorService named(String name) {
        return Executors.newSingleThreadExecutor(task -> {
            Thread thread = new Thread(task, name);
            thread.setDaemon(true);
            return thread;
        });
    }
}
