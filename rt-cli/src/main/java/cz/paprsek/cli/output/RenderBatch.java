package cz.paprsek.cli.output;

import cz.paprsek.asset.Assets;
import cz.paprsek.cli.input.Originals;
import cz.paprsek.cli.input.Pictures;
import cz.paprsek.cli.input.SceneReading;
import cz.paprsek.cli.input.Wishes;
import cz.paprsek.cli.output.Report.Outcome;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Memory;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.shard.Card;
import cz.paprsek.cli.shard.Footage;
import cz.paprsek.cli.shard.Order;
import cz.paprsek.cli.shard.Sharing;
import cz.paprsek.cli.shard.Span;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles.GrowingPng;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.Layers;
import cz.paprsek.io.Failures;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.TileStore;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.PlainTracer;
import cz.paprsek.teach.mistake.Mistakes;
import cz.paprsek.warning.SceneWarnings;
import cz.paprsek.xml.Problem;
import cz.paprsek.xml.SceneFileException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/**
 * Renders scenes one after the other, each on all threads; one that fails does not stop the next.
 *
 * @param share of the work that is to be done, in place of all of it
 */
public record RenderBatch(Terminal terminal, Stop stop, Wishes wishes, View view, Writing writing, boolean resume, Optional<Double> seconds, Pictures pictures, Reel reel, Progress.Maker progress, Report report,
        Optional<Sharing> share) {

    /** The exit code of the worst. */
    public int run(List<Target> targets) {
        int worst = ExitCode.DONE;
        for (Target target : targets) {
            Outcome outcome = stop.requested() ? fail(target, Outcome.INTERRUPTED, List.of("interrupted")) : run(target);
            worst = Math.max(worst, outcome.exitCode);
            if (outcome == Outcome.INTERRUPTED) {
                break;
            }
        }
        return worst;
    }

    private Outcome run(Target target) {
        String file = target.source().label();
        if (!target.refusal().isEmpty()) {
            return fail(target, Outcome.WRONG_USAGE, List.of(file + ": " + target.refusal()));
        }
        try {
            long begin = System.nanoTime();
            Scene read = reel.wishes().applyTo(target.source().read());
            if (progress != Progress.Maker.SILENT) {
                target.source().reading().notes().forEach(note -> terminal.message(file + ": note: " + note));
            }
            if (reel.wishes().frames().isPresent()) {
                return new FrameBatch(this, target, read, reel.wishes().frames().get()).run();
            }
            Scene seen = view.of(read);
            Assets assets = pictures.of(target.source().file());
            tellMissing(target, pictures.read(seen, assets), assets);
            return render(target, read, seen, assets, begin, new Still());
        } catch (WrongUsage e) {
            return fail(target, Outcome.WRONG_USAGE, List.of(file + ": " + e.getMessage()));
        } catch (SceneFileException e) {
            return fail(target, Outcome.BAD_SCENE, e.problems().stream().map(Problem::toString).toList());
        } catch (IOException e) {
            return fail(target, Outcome.ofReading(e), List.of(SceneReading.sentence(target.source().file(), file, pictures, e)));
        } catch (UncheckedIOException e) {
            return fail(target, Outcome.ofReading(e), List.of(file + ": " + e.getMessage()));
        } catch (IllegalArgumentException noSuchFrame) {
            return fail(target, Outcome.BAD_SCENE, List.of(file + ": " + noSuchFrame.getMessage()));
        } catch (IllegalStateException e) {
            return fail(target, Outcome.FAILED, List.of(file + ": " + e.getMessage()));
        } catch (OutOfMemoryError e) {
            return fail(target, Outcome.FAILED, List.of(file + ": " + Memory.sentence("the scene", 0)));
        }
    }

    /** Tells what is missing beside the meshes that have been read; of a model by itself all is told already. */
    void tellMissing(Target target, Scene read, Assets assets) {
        if (progress != Progress.Maker.SILENT && !assets.digests().isEmpty() && target.source().reading().notes().isEmpty()) {
            SceneWarnings.ofMeshes(read).forEach(warning -> terminal.message(target.source().label() + ": note: " + warning.message()));
        }
    }

    /** One scene by itself. */
    private final class Still implements Way {
        @Override
        public RenderResult render(Scene scene, Assets assets, RenderOptions options, RenderMonitor monitor, TileStore store) {
            return Renderer.render(scene, assets, options, monitor, store);
        }

        @Override
        public void write(Target target, Image image, Layers layers, ImageOptions how) throws IOException {
            target.write(view.written(target.format()), image, layers, how, terminal);
        }

        @Override
        public boolean isAlone() {
            return true;
        }
    }

    Outcome render(Target target, Scene read, Scene scene, Assets assets, Way way) {
        return render(target, read, scene, assets, System.nanoTime(), way);
    }

    /** @throws IllegalArgumentException if there is no such picture */
    RenderOptions options(Target target, Scene scene) {
        return timed(view.applyTo(wishes.applyTo(scene.settings()), target.format()));
    }

    /** @param scene what is shown of the one that was read */
    private Outcome render(Target target, Scene read, Scene scene, Assets assets, long begin, Way way) {
        RenderOptions options;
        try {
            options = options(target, scene);
            Image.requireRoom(options.region().width(), options.region().height());
        } catch (IllegalArgumentException refused) {
            return fail(target, Outcome.WRONG_USAGE, List.of(target.source().label() + ": " + refused.getMessage()));
        }
        if (share.isPresent()) {
            return part(share.get(), target, scene, assets, options, still(read, scene, assets, options), Span.STILL, begin);
        }
        int width = options.region().width();
        int height = options.region().height();
        String tooLarge = target.source().label() + ": " + Room.sentence(scene, options, target.format());
        if (Room.memory(scene, options, target.format()) > Memory.allowed()) {
            return fail(target, Outcome.FAILED, List.of(tooLarge));
        }
        try {
            if (target.file().isPresent()) {
                spare(target, assets);
                Room.checkDisk(target.file().get(), view.written(target.format()).leastBytes(width, height));
            }
            if (options.isInPasses() && progress != Progress.Maker.SILENT) {
                SceneWarnings.ofPaths(scene.withSettings(options.settings())).forEach(warning -> terminal.message(target.source().label() + ": note: " + warning.message()));
            }
            try (Tiles tiles = resume ? Tiles.kept(target, way, scene, assets, options, terminal, progress == Progress.Maker.SILENT) : Tiles.NOT_KEPT;
                    Beside beside = Beside.of(new Digest(read, target.format()), target, options, way.isAlone() && view.scale(target.format()).isEmpty() ? Optional.of(writing.options()) : Optional.empty())) {
                if (options.isInPasses()) {
                    // A picture is kept, and how good it is must be said.
                    stop.oweLastWords();
                }
                WholePasses passes = new WholePasses(seconds, (image, layers, count) -> isWritten(target, read, beside, image, layers, ofPasses(options, count), way),
                        hindered -> terminal.message(target.source().label() + ": note: the picture so far could not be written, rendering goes on: "
                                + Failures.sentence(target.shown(), hindered)));
                RenderResult result = rendered(target, scene, assets, options, tiles, passes, beside, way);
                if (stop.requested() || result.outcome() == RenderResult.Outcome.CANCELLED) {
                    return interrupted(target, passes);
                }
                Image image = view.finished(result.image(), target.format());
                write(target, read, beside, image, result.layers(), passes.passesInTime().map(count -> ofPasses(options, count)).orElse(options), way);
                if (!way.keepsTiles()) {
                    tiles.discard();
                }
                report.done(target, scene.name(), image.width(), image.height(), result, (System.nanoTime() - begin) / 1e9);
            }
        } catch (WrongUsage e) {
            return fail(target, Outcome.WRONG_USAGE, List.of(String.valueOf(e.getMessage())));
        } catch (IOException e) {
            return stop.requested() ? interrupted(target, new WholePasses(seconds, (image, layers, count) -> false, hindered -> {}))
                    : fail(target, Outcome.FAILED, List.of(Failures.sentence(target.file().map(Path::toString).orElse("standard output"), e)));
        } catch (OutOfMemoryError e) {
            return fail(target, Outcome.FAILED, List.of(tooLarge));
        }
        return Outcome.DONE;
    }

    /** @throws WrongUsage if the picture would be written over one of the pictures that it shows */
    private void spare(Target target, Assets assets) {
        target.file().ifPresent(file -> Originals.spare(file, "the picture of " + target.source().label(), "the scene's own", pictures.files(target.source().file(), assets.digests().keySet())));
    }

    /** A picture that does not move. */
    private Footage still(Scene read, Scene scene, Assets assets, RenderOptions options) {
        return new Footage() {
            @Override
            public ImageOptions written(int frame) {
                return writing.of(read, options, view, ImageFormat.PNG);
            }

            @Override
            public RenderScene scene(int frame) {
                return RenderScene.of(scene, assets, stopped());
            }
        };
    }

    /**
     * Renders a share of a picture or of frames, whose parts go to files of their own.
     *
     * @param scene what is shown; of a film, all of it
     */
    Outcome part(Sharing work, Target target, Scene scene, Assets assets, RenderOptions options, Footage footage, Span span, long begin) {
        String label = target.source().label();
        try {
            PartProgress shown = new PartProgress(terminal, label + ": shard " + work.shard(), progress == Progress.Maker.SILENT);
            Card card = Card.of(scene, !span.isStill(), assets, options, footage.written(span.first()), view.legend());
            Sharing.Done done = work.run(new Order(target.source().file(), scene, assets, card, options, span, footage), stop, shown);
            if (stop.requested()) {
                return fail(target, Outcome.INTERRUPTED, List.of(label + ": interrupted; what is done stays in " + target.shown() + ", and the same command goes on from there"));
            }
            report.shared(target, work.shard(), done, (System.nanoTime() - begin) / 1e9);
            return Outcome.DONE;
        } catch (WrongUsage e) {
            return fail(target, Outcome.WRONG_USAGE, List.of(String.valueOf(e.getMessage())));
        } catch (CancellationException stopped) {
            return fail(target, Outcome.INTERRUPTED, List.of(label + ": interrupted"));
        } catch (IOException e) {
            return fail(target, stop.requested() ? Outcome.INTERRUPTED : Outcome.FAILED, List.of(Failures.sentence(target.shown(), e)));
        }
    }

    RenderMonitor stopped() {
        return new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return stop.requested();
            }
        };
    }

    /** Without end but that of the time, unless somebody says how many paths there are to be. */
    private RenderOptions timed(RenderOptions options) {
        if (seconds.isEmpty()) {
            return options;
        }
        if (!options.isInPasses()) {
            throw new WrongUsage("--time is for pictures in passes, those of the light of --integrator path");
        }
        return wishes.rays().haveSamples() ? options : options.withSettings(options.settings().withMostRays(RenderSettings.MOST_PATHS));
    }

    /** What would have been asked for to get the picture after so many passes. */
    private static RenderOptions ofPasses(RenderOptions options, int passes) {
        return options.withSettings(options.settings().withMostRays(passes * RenderSettings.USUAL_PATHS));
    }

    /** Writes the picture of the passes so far, if it goes to a file. */
    private boolean isWritten(Target target, Scene read, Beside beside, Image image, Layers layers, RenderOptions options, Way way) throws IOException {
        if (target.file().isEmpty() || way.keepsTiles()) {
            return false;
        }
        write(target, read, beside, view.finished(image, target.format()), layers, options, way);
        return true;
    }

    private void write(Target target, Scene read, Beside beside, Image image, Layers layers, RenderOptions options, Way way) throws IOException {
        ImageOptions how = view.written(target.format(), writing.of(read, beside.digest(), options, view, target.format()));
        Optional<GrowingPng> compressed = beside.png(image, how);
        stop.guard(() -> {
            if (compressed.isPresent()) {
                compressed.get().write(target.file().orElseThrow(), how);
            } else {
                way.write(target, image, layers, how);
            }
        });
    }

    private RenderResult rendered(Target target, Scene scene, Assets assets, RenderOptions options, Tiles tiles, WholePasses passes, Beside beside, Way way) {
        if (!view.mistakes().equals(Mistakes.NONE)) {
            return wrong(target, scene, options);
        }
        try (Progress monitor = progress.start(target.source().label(), options, stop)) {
            monitor.whenPassed(passes);
            return way.render(scene, assets, options, beside.telling(monitor), tiles.store());
        }
    }

    private RenderResult wrong(Target target, Scene scene, RenderOptions options) {
        try {
            Image image = PlainTracer.of(scene, options.settings(), view.mistakes()).render(stop::requested);
            return new RenderResult(image, Layers.ofSize(image.width(), image.height()), RenderResult.Stats.NONE, RenderResult.Outcome.DONE, Optional.empty());
        } catch (IllegalArgumentException unknown) {
            throw new WrongUsage(target.source().label() + ": " + unknown.getMessage());
        } catch (CancellationException stopped) {
            return new RenderResult(new Image(1, 1), Layers.ofSize(1, 1), RenderResult.Stats.NONE, RenderResult.Outcome.CANCELLED, Optional.empty());
        }
    }

    private Outcome interrupted(Target target, WholePasses passes) {
        return fail(target, Outcome.INTERRUPTED, List.of(target.source().label() + ": interrupted, " + (passes.passesWritten() == 0 ? "no picture written"
                : target.shown() + " has the " + passes.passesWritten() * RenderSettings.USUAL_PATHS + " paths a pixel that were complete")));
    }

    Outcome fail(Target target, Outcome outcome, List<String> problems) {
        problems.forEach(terminal::message);
        report.failed(target, outcome, problems);
        return outcome;
    }
}
