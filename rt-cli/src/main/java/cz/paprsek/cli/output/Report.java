package cz.paprsek.cli.output;

import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.shard.Sharing;
import cz.paprsek.cli.value.Shard;
import cz.paprsek.io.Failures;
import cz.paprsek.io.Json;
import cz.paprsek.render.RenderResult;
import java.util.List;
import java.util.Locale;

/** Tells how each scene of a batch ended: on standard output, unless a picture goes there. */
public interface Report {
    /**
     * A picture is written.
     *
     * @param totalSeconds reading, rendering and writing
     */
    void done(Target target, String scene, int width, int height, RenderResult result, double totalSeconds);

    /** The share of a picture's work is done. */
    void shared(Target target, Shard shard, Sharing.Done done, double totalSeconds);

    /** A scene has no picture; the user has been told why. */
    void failed(Target target, Outcome outcome, List<String> problems);

    /** How a scene ended, in the words of the JSON output. */
    enum Outcome {
        DONE(ExitCode.DONE),
        FAILED(ExitCode.FAILED),
        WRONG_USAGE(ExitCode.WRONG_USAGE),
        BAD_SCENE(ExitCode.BAD_SCENE),
        INTERRUPTED(ExitCode.INTERRUPTED);

        final int exitCode;

        Outcome(int exitCode) {
            this.exitCode = exitCode;
        }

        /** A scheduler tries again what has failed, but not what is wrong. */
        static Outcome ofReading(Exception failure) {
            return Failures.isOfMachine(failure) ? FAILED : BAD_SCENE;
        }

        String text() {
            return name().toLowerCase(Locale.ROOT).replace('_', ' ');
        }
    }

    static Report of(Terminal terminal, boolean json, boolean quiet) {
        return json ? new AsJson(terminal) : new AsText(terminal, quiet);
    }

    /** A line for each picture. */
    record AsText(Terminal terminal, boolean quiet) implements Report {
        @Override
        public void done(Target target, String scene, int width, int height, RenderResult result, double totalSeconds) {
            RenderResult.Stats stats = result.stats();
            String line = String.format(Locale.ROOT, "%s -> %s  %dx%d  %.2f s  %.1f Mray/s", target.source().label(), target.shown(), width, height,
                    totalSeconds, stats.rays() / 1e6 / Math.max(stats.traceSeconds(), 1e-9))
                    + result.certainty().map(known -> String.format(Locale.ROOT, "  %.2f %% of the pixels within the error, the farthest %.4f", 100 * known.within(), known.farthest())
                            + (known.untrusted() > 0 ? String.format(Locale.ROOT, ", %.2f %% not to be trusted", 100 * known.untrusted()) : "")).orElse("");
            if (!quiet && target.file().isPresent()) {
                terminal.result(line);
            } else if (!quiet) {
                terminal.message(line);
            }
        }

        @Override
        public void shared(Target target, Shard shard, Sharing.Done done, double totalSeconds) {
            if (!quiet) {
                int before = done.parts() - done.made();
                terminal.result(String.format(Locale.ROOT, "%s -> %s  shard %s  %d parts%s  %.2f s", target.source().label(), target.shown(), shard, done.parts(),
                        before == 0 ? "" : ", " + before + " of them there before", totalSeconds));
            }
        }

        @Override
        public void failed(Target target, Outcome outcome, List<String> problems) {}
    }

    /** An object for each scene, one a line. */
    record AsJson(Terminal terminal) implements Report {
        @Override
        public void done(Target target, String scene, int width, int height, RenderResult result, double totalSeconds) {
            RenderResult.Stats stats = result.stats();
            Json all = begin(target, Outcome.DONE)
                    .with("scene", scene)
                    .with("format", target.format().extension())
                    .with("width", width)
                    .with("height", height)
                    .with("seconds", new Json()
                            .with("build", micros(stats.buildSeconds()))
                            .with("trace", micros(stats.traceSeconds()))
                            .with("total", micros(totalSeconds)))
                    .with("rays", RayCounts.asJson(stats))
                    .with("hits", stats.hits());
            result.certainty().ifPresent(known -> all.with("certainty", new Json().with("within", known.within()).with("farthest", known.farthest()).with("untrusted", known.untrusted())));
            terminal.result(all.toString());
        }

        @Override
        public void shared(Target target, Shard shard, Sharing.Done done, double totalSeconds) {
            terminal.result(begin(target, Outcome.DONE).with("shard", shard.toString()).with("parts", done.parts()).with("made", done.made())
                    .with("seconds", micros(totalSeconds)).toString());
        }

        @Override
        public void failed(Target target, Outcome outcome, List<String> problems) {
            terminal.result(begin(target, outcome).withTexts("problems", problems).toString());
        }

        private static Json begin(Target target, Outcome outcome) {
            return new Json().with("file", target.scene().toString()).with("output", target.shown()).with("outcome", outcome.text());
        }

        private static double micros(double seconds) {
            return Math.rint(seconds * 1e6) / 1e6;
        }
    }
}
