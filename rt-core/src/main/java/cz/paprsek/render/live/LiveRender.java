package cz.paprsek.render.live;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.math.Require;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.Tile;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import java.util.Objects;
import java.util.concurrent.CancellationException;
import org.jspecify.annotations.Nullable;

/**
 * Keeps a picture of a changing scene: coarse at once, then finer and finer until it is the picture that {@link Renderer} makes, to the last
 * bit. Works on threads of its own; every method returns at once.
 *
 * <p>A new scene stops the refining of the old one. Only the first pass of a scene is always finished, or nothing would be seen as long as a
 * hand keeps moving; it is as coarse as it must be to take some {@value #FIRST_PASS_MILLIS} ms, and while scenes follow each other quickly, of few processors
 * some are left to whoever shows the rest of what the hand does.
 */
public final class LiveRender implements AutoCloseable {
    private static final int COARSEST = 16;
    private static final double FIRST_PASS_MILLIS = 20;
    /** How much faster, or slower, a first pass must promise to be for its step to change: otherwise it would change to and fro. */
    private static final double SLACK = 1.5;
    /** What is shown so soon after something else is moved by a hand. */
    private static final long MOVES_NANOS = 150_000_000;
    /** While a hand moves, refining begins when it has stood still for so long. */
    private static final long STILL_NANOS = 50_000_000;

    private final int threads;
    /** Kept from pass to pass, with what they work with. */
    private final Renderer renderer = Renderer.keeping("paprsek-live-worker");
    private @Nullable Request waiting;
    private volatile boolean outdated;
    private volatile boolean stopped;
    private volatile boolean closed;
    private @Nullable RenderScene ready;
    /** Where its pictures came from. */
    private @Nullable Assets known;
    private int firstStep = 8;

    /** When something else was shown last, and until when the next first pass waits, both as {@link System#nanoTime}. */
    private long shown = System.nanoTime() - MOVES_NANOS;
    private long rests = shown;

    /** @param moves whether it came so soon after another one that more of them are to be expected */
    private record Request(Scene scene, Assets assets, RenderSettings settings, LiveListener listener, boolean moves) {}

    /** @param threads how many workers trace a pass */
    public LiveRender(int threads) {
        this.threads = Require.within("threads", threads, 1, 1024);
        Thread thread = new Thread(this::run, "paprsek-live");
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * Starts anew with another scene, size or listener. Of several calls in short order, those overtaken by the next are left out.
     *
     * @param settings of the final picture
     * @param listener is told of this picture only
     */
    public void show(Scene scene, RenderSettings settings, LiveListener listener) {
        show(scene, Assets.none(), settings, listener);
    }

    /**
     * As above, of a scene with pictures.
     *
     * @param assets where they come from; as long as these are the same, pictures are read but once
     */
    public synchronized void show(Scene scene, Assets assets, RenderSettings settings, LiveListener listener) {
        long now = System.nanoTime();
        waiting = new Request(Objects.requireNonNull(scene, "scene"), Objects.requireNonNull(assets, "assets"), Objects.requireNonNull(settings, "settings"),
                Objects.requireNonNull(listener, "listener"), now - shown < MOVES_NANOS);
        shown = now;
        outdated = true;
        notifyAll();
    }

    /** Stops rendering, also in a first pass, until there is something else to show. */
    public synchronized void stop() {
        waiting = null;
        stopped = true;
    }

    /** Stops rendering for ever. */
    @Override
    public synchronized void close() {
        closed = true;
        notifyAll();
    }

    private void run() {
        try (renderer) {
            for (Request request = take(); request != null; request = take()) {
                serve(request);
            }
        }
    }

    private void serve(Request request) {
        try {
            refine(request);
        } catch (Superseded wished) {
            // There is something else to show, or nothing any more.
        } catch (Throwable fault) {
            ready = null;
            tell(request.listener(), fault);
        }
    }

    /** A listener that cannot even hear of a fault is reported as if it had ended the thread, which goes on to serve others. */
    private static void tell(LiveListener listener, Throwable fault) {
        try {
            listener.failed(fault);
        } catch (Throwable another) {
            if (another != fault) {
                another.addSuppressed(fault);
            }
            Thread live = Thread.currentThread();
            live.getUncaughtExceptionHandler().uncaughtException(live, another);
        }
    }

    private synchronized @Nullable Request take() {
        while (!closed && (waiting == null || (waiting.moves && System.nanoTime() < rests))) {
            try {
                wait(waiting == null ? 0 : millisUntil(rests));
            } catch (InterruptedException byAListener) {
                // It is not theirs to end this thread, which others may still wait for; close() does that.
            }
        }
        Request taken = closed ? null : waiting;
        waiting = null;
        outdated = false;
        stopped = false;
        return taken;
    }

    /** A hand that moves has the processors to itself, as far as the first passes leave them, until it stands still. */
    private synchronized void awaitStill() throws Superseded {
        while (System.nanoTime() < shown + STILL_NANOS) {
            if (outdated || stopped || closed) {
                throw new Superseded();
            }
            try {
                wait(millisUntil(shown + STILL_NANOS));
            } catch (InterruptedException byAListener) {
                // The next pass tells.
                Thread.currentThread().interrupt();
                return;
            }
        }
    }

    private static long millisUntil(long nanos) {
        return 1 + Math.max(0, nanos - System.nanoTime()) / 1_000_000;
    }

    private void refine(Request request) throws Superseded {
        RenderMonitor unlessStopped = new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return stopped || closed;
            }
        };
        long start = System.nanoTime();
        RenderScene scene = prepared(request, unlessStopped);
        ready = scene;
        LivePass pass = LivePass.at(scene, request.settings(), firstStep);
        // One processor is left to whoever shows what a hand does; what comes after the first pass gives way to the next scene anyway.
        RenderResult result = render(pass, Math.max(1, threads - 1), unlessStopped);
        request.listener().painted(pass, result.image(), new Tile(0, 0, result.image().width(), result.image().height()));
        request.listener().completed(pass, result);
        adapt(result);
        if (request.moves()) {
            // Of two processors half of one, of many nearly all.
            long now = System.nanoTime();
            rests = now + (now - start) / Math.max(1, threads - 1);
            awaitStill();
        }
        while (!pass.isLast()) {
            pass = pass.next();
            request.listener().completed(pass, render(pass, threads, new Refinement(pass, request.listener())));
        }
    }

    private RenderScene prepared(Request request, RenderMonitor monitor) throws Superseded {
        try {
            RenderScene before = ready;
            RenderScene now = before == null || request.assets() != known ? RenderScene.of(request.scene(), request.assets(), monitor) : before.changedTo(request.scene(), monitor);
            known = request.assets();
            return now;
        } catch (CancellationException cancelled) {
            throw superseded(monitor);
        }
    }

    private RenderResult render(LivePass pass, int workers, RenderMonitor monitor) throws Superseded {
        RenderResult result = renderer.next(pass.scene(), pass.options(workers), monitor);
        if (result.outcome() == RenderResult.Outcome.CANCELLED) {
            throw superseded(monitor);
        }
        return result;
    }

    /** @throws IllegalStateException if nobody wished that: then a listener has interrupted this thread */
    private static Superseded superseded(RenderMonitor monitor) {
        if (Thread.interrupted() && !monitor.cancelled()) {
            throw new IllegalStateException("the thread that renders live was interrupted, which only a listener can do");
        }
        return new Superseded();
    }

    /** There is something else to show, or nothing any more. */
    private static final class Superseded extends Exception {
        private static final long serialVersionUID = 1;
    }

    /** Chooses how coarse the next first pass is, by how long this one took. */
    private void adapt(RenderResult result) {
        double millis = result.stats().traceSeconds() * 1e3;
        if (millis > FIRST_PASS_MILLIS * SLACK) {
            firstStep = Math.min(COARSEST, firstStep * 2);
        } else if (millis * 4 < FIRST_PASS_MILLIS / SLACK) {
            firstStep = Math.max(1, firstStep / 2);
        }
    }

    /** Passes tiles on until the scene is no longer the newest. */
    private final class Refinement implements RenderMonitor {
        private final LivePass pass;
        private final LiveListener listener;

        Refinement(LivePass pass, LiveListener listener) {
            this.pass = pass;
            this.listener = listener;
        }

        @Override
        public boolean cancelled() {
            return outdated || stopped || closed;
        }

        @Override
        public void finished(Tile tile, Image image, int done, int total) {
            listener.painted(pass, image, tile);
        }
    }
}
