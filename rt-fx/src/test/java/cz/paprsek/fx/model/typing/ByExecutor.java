package cz.paprsek.fx.model.typing;

import java.util.concurrent.Callable;
import java.util.concurrent.Executor;
import java.util.function.Consumer;

/** Does a manuscript's work where and when an executor says: at once, late, or on JavaFX's thread. */
public record ByExecutor(Executor executor) implements Manuscript.Worker {
    @Override
    public <T> void run(Callable<T> work, Consumer<T> done, Consumer<Throwable> failed) {
        executor.execute(() -> {
            T value;
            try {
                value = work.call();
            } catch (Exception e) {
                failed.accept(e);
                return;
            }
            done.accept(value);
        });
    }
}
