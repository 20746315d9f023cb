package cz.paprsek.render;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.image.Layers;
import cz.paprsek.render.RenderResult.Outcome;
import cz.paprsek.render.work.Workers;
import cz.paprsek.scene.Scene;
import cz.paprsek.tree.Kernel;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;

/** Renders scenes to images. The same scene gives the same image, to the last bit, for any number of threads. */
public final class Renderer implements AutoCloseable {
    private final Workers workers;

    private Renderer(Workers workers) {
        this.workers = workers;
    }

    /**
     * A renderer of many pictures, one after the other, such as ever finer ones of scenes that are being edited: its threads are kept from one to the
     * next, and end when it is closed. For one caller at a time: to others, {@link #next} throws an {@link IllegalStateException}, as it does once it is closed.
     *
     * @param threads what the threads are called; they are numbered
     */
    public static Renderer keeping(String threads) {
        return new Renderer(new Workers(Objects.requireNonNull(threads, "threads")));
    }

    /** The next picture, as by {@link #render(RenderScene, RenderOptions, RenderMonitor)}. */
    public RenderResult next(RenderScene scene, RenderOptions options, RenderMonitor monitor) {
        return render(scene, options, monitor, TileStore.NONE, workers);
    }

    /** The next picture, as by {@link #render(RenderScene, RenderOptions, RenderMonitor, TileStore)}. */
    public RenderResult next(RenderScene scene, RenderOptions options, RenderMonitor monitor, TileStore store) {
        return render(scene, options, monitor, store, workers);
    }

    /**
     * Ends the threads when the picture they make is done, and waits until they have ended.
     *
     * @throws IllegalStateException if a monitor asks while it is called: it would wait for itself
     */
    @Override
    public void close() {
        workers.close();
    }

    /** How large scenes are searched in this virtual machine: "vectors of 8 floats", or of 16, if it has the module jdk.incubator.vector, else "scalar". */
    public static String kernel() {
        return Kernel.inUse();
    }

    /**
     * Renders a scene as it asks to be, on all processors.
     *
     * @throws CancellationException if the calling thread is interrupted before the picture is complete; it stays interrupted
     * @throws IllegalStateException if there is too little memory, saying how much would do, or the program has a fault
     */
    public static Image render(Scene scene) {
        RenderResult result = render(RenderScene.of(scene), RenderOptions.of(scene), RenderMonitor.NONE);
        if (result.outcome() == Outcome.CANCELLED) {
            throw new CancellationException("the thread that renders was interrupted");
        }
        return result.image();
    }

    /**
     * Renders a prepared scene. Returns early, with what is done, when the monitor cancels or the calling thread is interrupted, which it stays.
     *
     * @throws IllegalStateException if any method of the monitor throws anything, there is too little memory, or the program has a fault: with
     *     what was thrown as its cause, and naming the pixel or how much memory would do
     */
    public static RenderResult render(RenderScene scene, RenderOptions options, RenderMonitor monitor) {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(options, "options");
        Objects.requireNonNull(monitor, "monitor");
        return render(scene, options, monitor, TileStore.NONE);
    }

    /**
     * Begins to render a prepared scene, and returns at once. Cancelling the future stops it soon.
     *
     * @param executor runs what waits for the picture, and all that is done with it; the rays are traced by as many threads as the options say
     * @return ends as {@link #render(RenderScene, RenderOptions, RenderMonitor)} does, or throws
     * @throws java.util.concurrent.RejectedExecutionException if the executor takes no more
     */
    public static CompletableFuture<RenderResult> start(RenderScene scene, RenderOptions options, RenderMonitor monitor, Executor executor) {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(options, "options");
        CompletableFuture<RenderResult> result = new CompletableFuture<>();
        RenderMonitor asking = new AskingMonitor(Objects.requireNonNull(monitor, "monitor"), result::isCancelled);
        executor.execute(() -> {
            if (!result.isDone()) {
                try {
                    result.complete(render(scene, options, asking));
                } catch (RuntimeException | Error failed) {
                    result.completeExceptionally(failed);
                }
            }
        });
        return result;
    }

    /** As {@link #render(RenderScene, RenderOptions, RenderMonitor)}, with tiles that are known from earlier, or are kept for later: throwing also if a method of the store throws anything. */
    public static RenderResult render(RenderScene scene, RenderOptions options, RenderMonitor monitor, TileStore store) {
        try (Workers workers = new Workers("paprsek-render")) {
            return render(scene, options, monitor, store, workers);
        }
    }

    private static RenderResult render(RenderScene scene, RenderOptions options, RenderMonitor monitor, TileStore store, Workers workers) {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(options, "options");
        Objects.requireNonNull(monitor, "monitor");
        Objects.requireNonNull(store, "store");
        long begin = System.nanoTime();
        RenderJob job = job(scene, options, monitor, store);
        do {
            if (!workers.run(Math.min(options.threads(), job.tiles()), job)) {
                Thread.currentThread().interrupt();
            }
            job.throwFailure();
        } while (job.isComplete() && job.goesOn());
        boolean isDone = job.isComplete() && job.denoise(workers);
        job.throwFailure();
        RenderResult.Stats stats = job.stats(scene.buildSeconds(), (System.nanoTime() - begin) / 1e9);
        return new RenderResult(job.image(), job.layers(), stats, isDone ? Outcome.DONE : Outcome.CANCELLED, job.certainty());
    }

    /**
     * Prepares and renders a scene; a preparation that is cancelled or interrupted gives a black picture.
     *
     * @throws IllegalStateException as {@link #render(RenderScene, RenderOptions, RenderMonitor)}
     */
    public static RenderResult render(Scene scene, RenderOptions options, RenderMonitor monitor) {
        return render(scene, options, monitor, TileStore.NONE);
    }

    /** As above, with tiles that are known from earlier, or are kept for later: throwing also if a method of the store throws anything. */
    public static RenderResult render(Scene scene, RenderOptions options, RenderMonitor monitor, TileStore store) {
        return render(scene, Assets.none(), options, monitor, store);
    }

    /**
     * As above, of a scene with pictures.
     *
     * @param assets where they come from
     * @throws java.io.UncheckedIOException if one of them cannot be read: with a sentence that says its name
     */
    public static RenderResult render(Scene scene, Assets assets, RenderOptions options, RenderMonitor monitor, TileStore store) {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(options, "options");
        Objects.requireNonNull(monitor, "monitor");
        try {
            return render(RenderScene.of(scene, assets, monitor), options, monitor, store);
        } catch (CancellationException cancelled) {
            Image black = new Image(options.region().width(), options.region().height());
            return new RenderResult(black, Layers.ofSize(black.width(), black.height()), RenderResult.Stats.NONE, Outcome.CANCELLED, Optional.empty());
        }
    }

    private static RenderJob job(RenderScene scene, RenderOptions options, RenderMonitor monitor, TileStore store) {
        try {
            return new RenderJob(scene, options, monitor, store);
        } catch (OutOfMemoryError exhausted) {
            throw Memory.exceeded(scene.scene(), options, exhausted);
        }
    }
}
