package cz.paprsek.render;

import cz.paprsek.image.Image;
import cz.paprsek.render.RenderResult.Outcome;
import cz.paprsek.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;

/** Renders scenes to images. The same scene gives the same image, to the last bit, for any number of threads. */
public final class Renderer {
    private Renderer() {}

    /** Renders a scene as it asks to be, on all processors. */
    public static Image render(Scene scene) {
        return render(RenderScene.of(scene), RenderOptions.of(scene), RenderMonitor.NONE).image();
    }

    /**
     * Renders a prepared scene. Returns early, with what is done, when the monitor cancels or the calling thread is interrupted.
     *
     * @throws IllegalStateException naming the pixel, if the monitor throws or the program has a fault
     */
    public static RenderResult render(RenderScene scene, RenderOptions options, RenderMonitor monitor) {
        Eye eye = new Eye(scene.scene().camera(), options.settings().width(), options.settings().height());
        return render(scene, options, eye, monitor);
    }

    /** Renders a prepared scene as an eye sees it. */
    static RenderResult render(RenderScene scene, RenderOptions options, Eye eye, RenderMonitor monitor) {
        long begin = System.nanoTime();
        RenderJob job = new RenderJob(scene, options, eye, monitor);
        List<Thread> workers = new ArrayList<>();
        for (int i = 0; i < Math.min(options.threads(), job.tiles()); i++) {
            Thread worker = new Thread(job::work, "paprsek-render-" + i);
            worker.setDaemon(true);
            workers.add(worker);
            worker.start();
        }
        boolean interrupted = false;
        for (Thread worker : workers) {
            interrupted |= !joined(worker, job);
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
        job.throwFailure();
        RenderStats stats = job.stats(scene.buildSeconds(), (System.nanoTime() - begin) / 1e9);
        return new RenderResult(job.image(), stats, job.isComplete() ? Outcome.DONE : Outcome.CANCELLED);
    }

    /** Prepares and renders a scene; a cancelled preparation gives a black picture. */
    public static RenderResult render(Scene scene, RenderOptions options, RenderMonitor monitor) {
        try {
            return render(RenderScene.of(scene, monitor), options, monitor);
        } catch (CancellationException cancelled) {
            Image black = new Image(options.region().width(), options.region().height());
            return new RenderResult(black, RenderStats.NONE, Outcome.CANCELLED);
        }
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
