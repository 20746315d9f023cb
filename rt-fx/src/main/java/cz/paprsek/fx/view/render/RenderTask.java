package cz.paprsek.fx.view.render;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.model.picture.UnfinishedPicture;
import cz.paprsek.fx.view.picture.PictureBuffer;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderResult.Outcome;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.Tile;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.RenderSettings;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import javafx.concurrent.Task;
import org.jspecify.annotations.Nullable;

/**
 * One picture on its way to the screen. Paints finished tiles on a {@link PictureBuffer}; cancelled, it stops at once and what is done
 * stays. All methods may be called while it runs, from JavaFX's thread.
 */
final class RenderTask extends Task<RenderResult> {
    private final String title;
    private final Subject subject;
    private final Assets assets;
    private final RenderOptions options;
    private final PictureBuffer buffer;
    /** What it was before its noise was taken out; empty unless that is wished. */
    private final Optional<PictureBuffer> noisy;
    private final UnfinishedPicture onDisk;
    private final KeptFilm kept;
    /** The cancelled one that this one goes on with. */
    private final Optional<RenderTask> before;
    private final AtomicLong rays = new AtomicLong();
    private final CountDownLatch end = new CountDownLatch(1);
    private volatile long began;
    private volatile int done;
    private volatile int total;
    /** When the noise began to be taken out; 0 before. */
    private volatile long traced;
    private volatile long ended;
    private volatile @Nullable RenderScene prepared;
    private volatile @Nullable Image image;
    private volatile @Nullable Mixer mixer;

    /**
     * @param title what the user reads for it
     * @param onDisk what outlives the program of it, or has outlived it
     * @throws ArithmeticException if the picture is larger than any array
     */
    RenderTask(String title, Subject subject, Assets assets, RenderOptions options, UnfinishedPicture onDisk) {
        this.title = title;
        this.subject = subject;
        this.assets = assets;
        this.options = options;
        this.buffer = new PictureBuffer(options.region().width(), options.region().height());
        this.noisy = options.denoised() ? Optional.of(new PictureBuffer(buffer.width(), buffer.height())) : Optional.empty();
        this.onDisk = onDisk;
        this.kept = new KeptFilm(options.channels(subject.seen()), onDisk);
        this.before = Optional.empty();
    }

    private RenderTask(RenderTask cancelled) {
        title = cancelled.title;
        subject = cancelled.subject;
        assets = cancelled.assets;
        options = cancelled.options;
        buffer = cancelled.buffer;
        noisy = cancelled.noisy;
        onDisk = cancelled.onDisk;
        kept = cancelled.kept;
        before = Optional.of(cancelled);
        RenderProgress so = cancelled.progress();
        done = so.done();
        total = so.total();
        rays.set(so.rays());
        image = cancelled.image;
    }

    /** One that goes on where this one, which was cancelled, stopped: with the same bytes as if it had not been. */
    RenderTask goOn() {
        return new RenderTask(this);
    }

    @Override
    protected RenderResult call() throws InterruptedException {
        if (before.isPresent() && before.get().began != 0) {
            before.get().end.await();
        }
        began = System.nanoTime();
        try {
            RenderScene ready = RenderScene.of(subject.seen(), assets, new Monitor(0));
            prepared = ready;
            onDisk.open(subject.seen(), assets, options);
            RenderResult result = Renderer.render(ready, options, new Monitor(passedBefore()), kept);
            if (options.denoised() && result.outcome() == Outcome.DONE) {
                buffer.paint(result.image(), new Tile(0, 0, buffer.width(), buffer.height()), 1, how());
            }
            if (options.layers().contains(Layer.LIGHT)) {
                mixer = new Mixer(result, buffer, how());
            }
            if (result.outcome() == Outcome.DONE) {
                kept.forget();
            }
            return result;
        } finally {
            ended = System.nanoTime();
            end.countDown();
        }
    }

    /** Nobody wants it any more. */
    void giveUp() {
        cancel();
        kept.forget();
    }

    /** So many tiles of whole passes were done before, but for the last one, which is found again as the first of those that follow. */
    private int passedBefore() {
        if (before.isEmpty() || !options.isInPasses() || options.settings().isAdaptive()) {
            return 0;
        }
        int ofOnePass = Math.max(1, total / options.passes());
        return Math.max(0, done / ofOnePass - 1) * ofOnePass;
    }

    /** What the user reads for it. */
    String title() {
        return title;
    }

    Subject subject() {
        return subject;
    }

    RenderOptions options() {
        return options;
    }

    /** How it is shown: light exposed and toned, all else as it is. */
    ImageOptions how() {
        RenderSettings settings = options.settings();
        return options.mode() == RenderMode.SHADED ? ImageOptions.shown(settings.exposure(), settings.tone()) : ImageOptions.DEFAULT;
    }

    /** How it is saved: as it is shown, and told where it comes from. */
    ImageOptions saved(ImageFormat format) {
        Origin origin = subject.origin(options, format);
        String mix = Optional.ofNullable(mixer).map(Mixer::told).orElse("");
        return how().withOrigin(mix.isEmpty() || origin.equals(Origin.UNTOLD) ? origin
                : new Origin(origin.scene(), origin.digest(), origin.program(), origin.settings() + "; lights mixed afterwards: " + mix));
    }

    PictureBuffer buffer() {
        return buffer;
    }

    /** The picture before its noise was taken out, to be compared with it; empty unless that is wished. */
    Optional<PictureBuffer> noisy() {
        return noisy;
    }

    /** What mixes its lights; empty until the picture is finished, and if there are no layers of lights. */
    Optional<Mixer> mixer() {
        return Optional.ofNullable(mixer);
    }

    /** The scene made ready for rays; empty until it is. */
    Optional<RenderScene> prepared() {
        return Optional.ofNullable(prepared);
    }

    /** The picture in linear light, as far as it has got, and with its lights as they are mixed; empty until there is a tile of it. */
    Optional<Image> image() {
        return Optional.ofNullable(mixer).map(Mixer::image).or(() -> Optional.ofNullable(image));
    }

    /** Whether it was finished, cancelled or failed; for JavaFX's thread, which is told of it before the other one has quite returned. */
    boolean isOver() {
        return switch (getState()) {
            case READY, SCHEDULED, RUNNING -> false;
            case SUCCEEDED, CANCELLED, FAILED -> true;
        };
    }

    /** Whether nothing more will be painted; after cancelling, that is a moment later. */
    boolean isStopped() {
        return ended != 0;
    }

    /** How far it is by now. */
    RenderProgress progress() {
        long now = ended == 0 ? System.nanoTime() : ended;
        Optional<RenderProgress> earlier = before.map(RenderTask::progress);
        return new RenderProgress(done, total, earlier.map(RenderProgress::elapsedSeconds).orElse(0.0) + secondsUntil(now),
                earlier.map(RenderProgress::tracingSeconds).orElse(0.0) + secondsUntil(traced == 0 ? now : traced),
                rays.get(), !options.isInPasses() || !options.settings().isAdaptive(), traced != 0);
    }

    private double secondsUntil(long time) {
        return began == 0 ? 0 : (time - began) / 1e9;
    }

    private final class Monitor implements RenderMonitor {
        private final int doneBefore;

        Monitor(int doneBefore) {
            this.doneBefore = doneBefore;
        }

        @Override
        public boolean cancelled() {
            return isCancelled();
        }

        @Override
        public void traced(long more) {
            rays.addAndGet(more);
        }

        @Override
        public void finished(Tile tile, Image underWay, int tilesDone, int tilesTotal) {
            image = underWay;
            total = tilesTotal;
            countUpTo(Math.min(tilesTotal, doneBefore + tilesDone));
            buffer.paint(underWay, tile, 1, how());
            noisy.ifPresent(before -> before.paint(underWay, tile, 1, how()));
        }

        @Override
        public void denoising() {
            traced = System.nanoTime();
        }
    }

    /** Workers may tell of their tiles in another order than they counted them. */
    private synchronized void countUpTo(int tiles) {
        done = Math.max(done, tiles);
    }
}
