package cz.paprsek.render;

import cz.paprsek.image.Image;
import cz.paprsek.render.RenderResult.Outcome;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.scene.Scene;
import cz.paprsek.tree.Kernel;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CancellationException;

/** Renders scenes to images. The same scene gives the same image, to the last bit, for any number of threads. */
public final class Renderer {
    private Renderer() {}

    /** How large scenes are searched in this virtual machine: "vectors of 8 floats" if it has the module jdk.incubator.vector, else "scalar". */
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
        Eye eye = Eye.of(scene.scene().camera(), options.settings().width(), options.settings().height());
        return render(scene, options, eye, monitor);
    }

    /** Renders a prepared scene as an eye sees it, throwing as above. */
    public static RenderResult render(RenderScene scene, RenderOptions options, Eye eye, RenderMonitor monitor) {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(options, "options");
        Objects.requireNonNull(eye, "eye");
        Objects.requireNonNull(monitor, "monitor");
        long begin = System.nanoTime();
        RenderJob job = job(scene, options, eye, monitor);
        boolean interrupted = false;
        for (Thread worker : startWorkers(Math.min(options.threads(), job.tiles()), job)) {
            interrupted |= !joined(worker, job);
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
        job.throwFailure();
        RenderStats stats = job.stats(scene.buildSeconds(), (System.nanoTime() - begin) / 1e9);
        return new RenderResult(job.image(), stats, job.isComplete() ? Outcome.DONE : Outcome.CANCELLED);
    }

    /**
     * Prepares and renders a scene; a preparation that is cancelled or interrupted gives a black picture.
     *
     * @throws IllegalStateException as {@link #render(RenderScene, RenderOptions, RenderMonitor)}
     */
    public static RenderResult render(Scene scene, RenderOptions options, RenderMonitor monitor) {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(options, "options");
        Objects.requireNonNull(monitor, "monitor");
        try {
            return render(RenderScene.of(scene, monitor), options, monitor);
        } catch (CancellationException cancelled) {
            Image black = new Image(options.region().width(), options.region().height());
            return new RenderResult(black, RenderStats.NONE, Outcome.CANCELLED);
        }
    }

    private static RenderJob job(RenderScene scene, RenderOptions options, Eye eye, RenderMonitor monitor) {
        try {
            return new RenderJob(scene, options, eye, monitor);
        } catch (OutOfMemoryError exhausted) {
            throw Memory.exceeded(scene.scene(), options, exhausted);
        }
    }

    /** Those that could be started; if one could not, the job has failed and the others end soon. */
    private static List<Thread> startWorkers(int count, RenderJob job) {
        List<Thread> workers = new ArrayList<>();
        try {
            for (int i = 0; i < count; i++) {
                Thread worker = new Thread(job::work, "paprsek-render-" + i);
                worker.setDaemon(true);
                worker.start();
                workers.add(worker);
            }
        } catch (OutOfMemoryError noThread) {
            job.fail(noThread, RenderJob.NOWHERE, RenderJob.NOWHERE);
        }
        return workers;
    }

    /** Waits for a worker to end; false if the wait was interrupted, which cancels the job. */
    private static boolean joined(Thread worker, RenderJob job) {
        boolean undisturbed = true;
        while (true) {
            try {
                worker.join();
                return undisturbed;
            } catch (InterruptedException e) {
                undisturbed = false;
                job.cancel();
            }
        }
    }
}
