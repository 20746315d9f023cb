package cz.paprsek.cli.output;

import cz.paprsek.asset.Assets;
import cz.paprsek.cli.output.Report.Outcome;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.shard.Footage;
import cz.paprsek.cli.shard.Sharing;
import cz.paprsek.cli.shard.Span;
import cz.paprsek.cli.value.FrameRange;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.Layers;
import cz.paprsek.image.film.FilmWriter;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Failures;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.TileStore;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.resume.Checkpoint;
import cz.paprsek.resume.SceneDigest;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.mistake.Mistakes;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleFunction;
import org.jspecify.annotations.Nullable;

/** Renders frames of a film one after the other: to pictures of their own, or into one file. What does not change from one to the next is prepared once. */
final class FrameBatch {
    private final RenderBatch batch;
    private final Target target;
    private final Scene read;
    private final FrameRange range;
    private final DoubleFunction<Scene> frames;
    private final Scenery scenery = new Scenery();
    private @Nullable Assets assets;
    /** Those of the last frame. */
    private SortedSet<String> files = new TreeSet<>();

    FrameBatch(RenderBatch batch, Target target, Scene read, FrameRange range) {
        this.batch = batch;
        this.target = target;
        this.read = read;
        this.range = range;
        this.frames = SceneFiles.frames(read);
    }

    Outcome run() throws IOException {
        View view = batch.view();
        boolean isLightAlone = view.mode() == RenderMode.SHADED && view.mistakes().equals(Mistakes.NONE) && !view.pixels().haveLayers() && !view.pixels().isTransparent() && !view.pixels().isDenoised();
        if (read.settings().shutter() > 0 && !isLightAlone) {
            throw new WrongUsage("while the shutter is open, pictures show light alone; --shutter 0 goes with --mode, --aov, --transparent, --denoise and --mistake");
        }
        if (batch.share().isPresent()) {
            return shared(batch.share().get());
        }
        Optional<FilmWriter.Format> film = batch.reel().film();
        if (film.isEmpty()) {
            return batch.reel().wishes().isOne() ? one() : pictures();
        }
        try {
            film.get().check(read.settings().fps());
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(String.valueOf(refused.getMessage()));
        }
        return film(film.get());
    }

    /** A share of the frames, whose parts go to files of their own. */
    private Outcome shared(Sharing work) throws IOException {
        long begin = System.nanoTime();
        Scene seen = batch.view().of(frames.apply(range.first()));
        Assets pictures = assets(seen);
        RenderOptions options;
        try {
            options = batch.options(target, seen);
            Image.requireRoom(options.region().width(), options.region().height());
        } catch (IllegalArgumentException refused) {
            return batch.fail(target, Outcome.WRONG_USAGE, List.of(target.source().label() + ": " + refused.getMessage()));
        }
        steady(range.last(), seen.settings());
        return batch.part(work, target, batch.view().of(read), pictures, options, new Footage() {
            @Override
            public ImageOptions written(int frame) {
                return batch.writing().of(frames.apply(frame), options, batch.view(), ImageFormat.PNG);
            }

            @Override
            public RenderScene scene(int frame) {
                return prepared(frame, batch.view().of(steady(frame, seen.settings())), pictures, batch.stopped());
            }
        }, new Span(range.first(), range.last()), begin);
    }

    /**
     * The scene of a frame.
     *
     * @throws WrongUsage if it wishes to be rendered in another way than others: the parts of a film are all made alike
     */
    private Scene steady(int frame, RenderSettings settings) {
        Scene scene = frames.apply(frame);
        if (!scene.settings().equals(settings)) {
            throw new WrongUsage(target.source().label() + ": frame " + frame + " has another <render> than frame " + range.first() + "; shares are of films in which only what is seen changes");
        }
        return scene;
    }

    private RenderScene prepared(int number, Scene scene, Assets pictures, RenderMonitor monitor) {
        RenderScene prepared = scenery.prepared(scene, pictures, monitor);
        double shutter = read.settings().shutter();
        return shutter > 0 ? prepared.exposed(share -> batch.view().of(frames.apply(number + shutter * share)), monitor) : prepared;
    }

    private Outcome one() throws IOException {
        Scene written = frames.apply(range.first());
        Scene seen = batch.view().of(written);
        if (target.isNumbered()) {
            Target now = target.ofFrame(range, range.first());
            FrameLedger.of(target.file().orElseThrow()).forget(now.file().orElseThrow());
            return batch.render(now, written, seen, assets(seen), new Frame(range.first()));
        }
        return batch.render(target, written, seen, assets(seen), new Frame(range.first()));
    }

    private Outcome pictures() throws IOException {
        Path pattern = target.file().orElseThrow(() -> new WrongUsage("pictures of frames go to files; --format y4m makes a film of them that can go to standard output"));
        FrameLedger ledger = FrameLedger.of(pattern);
        Set<Path> pictures = new HashSet<>();
        Outcome outcome = Outcome.DONE;
        for (int frame = range.first(); frame <= range.last() && outcome == Outcome.DONE; frame++) {
            Target now = target.ofFrame(range, frame);
            Path picture = now.file().orElseThrow();
            pictures.add(picture);
            Scene written = frames.apply(frame);
            Scene seen = batch.view().of(written);
            Frame way = new OneOfMany(frame);
            String digest = batch.resume() ? digest(way.keptAs(seen), written, assets(seen), now, options(now, seen)) : "";
            if (batch.resume() && ledger.has(picture, digest)) {
                batch.terminal().message(now.source().label() + ": is there already");
                continue;
            }
            ledger.forget(picture);
            outcome = batch.render(now, written, seen, assets(seen), way);
            if (batch.resume() && outcome == Outcome.DONE) {
                ledger.add(picture, digest);
                Files.deleteIfExists(Checkpoint.fileFor(way.tilesBeside(now)));
            }
        }
        if (batch.resume() && outcome == Outcome.DONE) {
            ledger.done(pictures);
        }
        return outcome;
    }

    private RenderOptions options(Target now, Scene seen) {
        try {
            return batch.options(now, seen);
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(String.valueOf(refused.getMessage()));
        }
    }

    /** Of all that the bytes of a picture depend on. */
    private String digest(Scene kept, Scene written, Assets assets, Target now, RenderOptions options) {
        ImageOptions how = batch.writing().of(written, options.withThreads(1), batch.view(), now.format());
        return SceneDigest.of(kept, assets, options.withThreads(1).toString(), how.toString(), batch.writing().toString(), batch.seconds().toString(), now.format() + " legend " + batch.view().legend());
    }

    private Outcome film(FilmWriter.Format format) throws IOException {
        // The unfinished file must be removed.
        batch.stop().oweLastWords();
        Outcome[] outcome = {Outcome.DONE};
        try {
            if (target.file().isEmpty()) {
                outcome[0] = film(format, batch.terminal().bytes());
                return outcome[0];
            }
            AtomicFile.write(target.file().get(), out -> {
                outcome[0] = film(format, out);
                if (outcome[0] != Outcome.DONE) {
                    throw new IOException("the film has not become whole");
                }
            });
            for (int frame = range.first(); batch.resume() && frame <= range.last(); frame++) {
                Files.deleteIfExists(Checkpoint.fileFor(target.besideFrame(range, frame)));
            }
            return Outcome.DONE;
        } catch (IOException e) {
            return outcome[0] != Outcome.DONE ? outcome[0] : batch.stop().requested() ? Outcome.INTERRUPTED
                    : batch.fail(target, Outcome.FAILED, List.of(Failures.sentence(target.shown(), e)));
        }
    }

    private Outcome film(FilmWriter.Format format, OutputStream out) throws IOException {
        InFilm film = new InFilm(format, out);
        for (int frame = range.first(); frame <= range.last(); frame++) {
            Scene seen = batch.view().of(frames.apply(frame));
            film.number = frame;
            Outcome outcome = batch.render(target.labelled(frame), read, seen, assets(seen), film);
            if (outcome != Outcome.DONE) {
                return outcome;
            }
        }
        film.end();
        return Outcome.DONE;
    }

    private Assets assets(Scene scene) throws IOException {
        Assets known = assets == null ? batch.pictures().of(target.source().file()) : assets;
        if (assets == null || !files.equals(scene.files())) {
            batch.tellMissing(target, batch.pictures().read(scene, known), known);
            files = scene.files();
            assets = known;
        }
        return known;
    }

    /** A frame that has a file of its own. */
    private class Frame implements Way {
        int number;

        Frame(int number) {
            this.number = number;
        }

        @Override
        public RenderResult render(Scene scene, Assets pictures, RenderOptions options, RenderMonitor monitor, TileStore store) {
            try {
                return Renderer.render(prepared(number, scene, pictures, monitor), options, monitor, store);
            } catch (CancellationException cancelled) {
                Image black = new Image(options.region().width(), options.region().height());
                return new RenderResult(black, Layers.ofSize(black.width(), black.height()), RenderResult.Stats.NONE, RenderResult.Outcome.CANCELLED, Optional.empty());
            }
        }

        @Override
        public void write(Target to, Image image, Layers layers, ImageOptions how) throws IOException {
            to.write(batch.view().written(to.format()), image, layers, how, batch.terminal());
        }

        /** While the shutter is open, a frame shows more than one scene. */
        @Override
        public Scene keptAs(Scene shown) {
            return read.settings().shutter() > 0 ? batch.view().of(read).withName(read.name() + " " + number) : shown;
        }
    }

    /** A frame that is not asked for by itself: of tiles of another one beside it nobody knows. */
    private class OneOfMany extends Frame {
        OneOfMany(int number) {
            super(number);
        }

        @Override
        public boolean beginsAnew() {
            return true;
        }

        /** Not where the paths of a frame lie that was asked for by itself: they are kept for more of them. */
        @Override
        public Path tilesBeside(Target to) {
            Path picture = to.file().orElseThrow();
            return picture.resolveSibling(picture.getFileName() + ".film");
        }
    }

    /** A frame that becomes part of a file. */
    private final class InFilm extends OneOfMany {
        private final FilmWriter.Format format;
        private final OutputStream out;
        private @Nullable FilmWriter writer;

        InFilm(FilmWriter.Format format, OutputStream out) {
            super(range.first());
            this.format = format;
            this.out = out;
        }

        @Override
        public void write(Target to, Image image, Layers layers, ImageOptions how) throws IOException {
            if (writer == null) {
                writer = new FilmWriter(format, image.width(), image.height(), read.settings().fps(), range.count(), how, out);
            }
            writer.add(image, how);
        }

        void end() throws IOException {
            if (writer != null) {
                writer.end();
            }
        }

        @Override
        public Path tilesBeside(Target to) {
            return target.besideFrame(range, number);
        }

        @Override
        public boolean keepsTiles() {
            return true;
        }
    }
}
