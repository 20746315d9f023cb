package cz.paprsek.render.denoise;

import cz.paprsek.render.work.Desk;
import cz.paprsek.render.work.Workers;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** Something that is done with every tile of a picture, each by itself, so that it does not matter who does it and when. */
final class Stage implements Workers.Work {
    private final int columns;
    private final int tiles;
    private final Supplier<? extends Step> maker;
    private final BooleanSupplier stop;
    private final AtomicInteger next = new AtomicInteger();
    private volatile boolean stopped;
    private @Nullable Throwable fault;

    /** What one worker does with a tile. */
    interface Step {
        void at(int left, int top);
    }

    private Stage(int width, int height, Supplier<? extends Step> maker, BooleanSupplier stop) {
        columns = (width + Window.WIDTH - 1) / Window.WIDTH;
        tiles = columns * ((height + Window.HEIGHT - 1) / Window.HEIGHT);
        this.maker = maker;
        this.stop = stop;
    }

    /**
     * Does it; false if the calling thread was interrupted, or all is to stop.
     *
     * @param picture whose tiles
     * @param maker of a worker's scratch
     */
    static boolean run(Workers workers, int threads, Noisy picture, Supplier<? extends Step> maker, BooleanSupplier stop) {
        Stage stage = new Stage(picture.width, picture.height, maker, stop);
        boolean undisturbed = workers.run(Math.min(threads, stage.tiles), stage);
        if (!undisturbed) {
            Thread.currentThread().interrupt();
        }
        stage.throwFault();
        return undisturbed && !stop.getAsBoolean();
    }

    private synchronized void throwFault() {
        if (fault instanceof Error error) {
            throw error;
        } else if (fault instanceof RuntimeException exception) {
            throw exception;
        }
    }

    @Override
    public void at(Desk desk) {
        try {
            Step step = maker.get();
            for (int i = next.getAndIncrement(); i < tiles && !stopped && !stop.getAsBoolean(); i = next.getAndIncrement()) {
                step.at(i % columns * Window.WIDTH, i / columns * Window.HEIGHT);
            }
        } catch (Throwable thrown) {
            fail(thrown);
        }
    }

    @Override
    public void cancel() {
        stopped = true;
    }

    @Override
    public synchronized void fail(Throwable thrown) {
        stopped = true;
        fault = fault == null ? thrown : fault;
    }
}
