package cz.paprsek.cli.output;

import cz.paprsek.cli.input.Wishes;
import cz.paprsek.cli.output.Report.Outcome;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Failures;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.Problem;
import cz.paprsek.xml.SceneFileException;
import java.io.IOException;
import java.util.List;

/** Renders scenes one after the other, each on all threads; one that fails does not stop the next. */
public record RenderBatch(Terminal terminal, Stop stop, Wishes wishes, View view, boolean resume, Progress.Maker progress, Report report) {

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
        try {
            long begin = System.nanoTime();
            return render(target, view.of(target.source().read()), begin);
        } catch (WrongUsage e) {
            return fail(target, Outcome.WRONG_USAGE, List.of(file + ": " + e.getMessage()));
        } catch (SceneFileException e) {
            return fail(target, Outcome.BAD_SCENE, e.problems().stream().map(Problem::toString).toList());
        } catch (IOException e) {
            return fail(target, Outcome.BAD_SCENE, List.of(Failures.sentence(file, e)));
        } catch (IllegalStateException e) {
            return fail(target, Outcome.FAILED, List.of(file + ": " + e.getMessage()));
        } catch (OutOfMemoryError e) {
            return fail(target, Outcome.FAILED, List.of(file + ": not enough memory; give Java more with -Xmx, or render in parts with --region"));
        }
    }

    private Outcome render(Target target, Scene scene, long begin) {
        RenderOptions options;
        try {
            options = wishes.applyTo(scene.settings()).withMode(view.mode());
            Image.requireRoom(options.region().width(), options.region().height());
        } catch (IllegalArgumentException refused) {
            return fail(target, Outcome.WRONG_USAGE, List.of(target.source().label() + ": " + refused.getMessage()));
        }
        RenderResult result;
        Image image;
        try (Tiles tiles = resume ? Tiles.kept(target, scene, options, terminal) : Tiles.NOT_KEPT) {
            try (Progress monitor = progress.start(target.source().label(), options, stop)) {
                result = Renderer.render(scene, options, tiles.around(monitor));
            }
            if (stop.requested() || result.outcome() == RenderResult.Outcome.CANCELLED) {
                return fail(target, Outcome.INTERRUPTED, List.of(target.source().label() + ": interrupted, no picture written"));
            }
            image = view.finished(result.image());
            stop.guard(() -> write(target, image));
            tiles.discard();
        } catch (WrongUsage e) {
            return fail(target, Outcome.WRONG_USAGE, List.of(String.valueOf(e.getMessage())));
        } catch (IOException e) {
            return stop.requested()
                    ? fail(target, Outcome.INTERRUPTED, List.of(target.source().label() + ": interrupted, no picture written"))
                    : fail(target, Outcome.FAILED, List.of(Failures.sentence(target.shown(), e)));
        }
        report.done(target, scene.name(), image.width(), image.height(), result.stats(), (System.nanoTime() - begin) / 1e9);
        return Outcome.DONE;
    }

    private void write(Target target, Image image) throws IOException {
        if (target.file().isPresent()) {
            ImageFiles.write(image, target.file().get(), target.format());
        } else {
            ImageFiles.write(image, terminal.bytes(), target.format());
        }
    }

    private Outcome fail(Target target, Outcome outcome, List<String> problems) {
        problems.forEach(terminal::message);
        report.failed(target, outcome, problems);
        return outcome;
    }
}
