package cz.paprsek.cli;

import cz.paprsek.cli.input.SceneSource;
import cz.paprsek.cli.input.TellingWishes;
import cz.paprsek.cli.output.Reel;
import cz.paprsek.cli.output.Target;
import cz.paprsek.cli.output.Targets;
import cz.paprsek.cli.output.View;
import cz.paprsek.cli.output.Writing;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Memory;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.shard.Assembly;
import cz.paprsek.cli.shard.Card;
import cz.paprsek.cli.shard.Heads;
import cz.paprsek.cli.shard.Span;
import cz.paprsek.cli.shard.Survey;
import cz.paprsek.cli.value.Formats;
import cz.paprsek.cli.value.FrameRange;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.io.Failures;
import cz.paprsek.io.Json;
import cz.paprsek.origin.Origins;
import cz.paprsek.text.Numbers;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Puts a picture together that several machines have rendered. */
@Command(
        name = "merge",
        description = {
            "Puts the parts of a picture together that 'paprsek render --shard' has made: to the same bytes as if one machine had rendered it, in whatever order and by "
                    + "whichever machines they were made.",
            "What is missing, damaged or of another picture is told, file by file, with the line that makes it; then no picture is written, and the exit code is 4."
        },
        footer = {"", "Examples:", "  paprsek render scene.xml --shard 1/2 -o parts    on one machine", "  paprsek render scene.xml --shard 2/2 -o parts    on another",
            "  paprsek merge parts -o scene.png"})
final class MergeCommand implements Callable<Integer> {
    private static final long MILLIS_BETWEEN = 1000;
    private static final long MOST_BETWEEN = 30 * MILLIS_BETWEEN;

    private final Terminal terminal;
    private final Stop stop;

    @Parameters(index = "0", paramLabel = "DIR", description = "The directory of the parts.")
    private Path folder;

    @Option(names = {"-o", "--output"}, paramLabel = "FILE", description = {
        "The picture; its ending says the format. Of a film {frame} stands for the number of the frame. - is standard output. Default: {name}.png in the working directory, by the directory's name."})
    private Optional<String> output;

    @Option(names = "--format", paramLabel = "FORMAT", completionCandidates = Formats.class, description = "One of ${COMPLETION-CANDIDATES}. Default: by the ending of the output, else png.")
    private Optional<ImageFormat> format;

    @Option(names = "--bits", paramLabel = "N", description = "Bits per channel: 8 or 16 of png, 16 or 32 of exr. Default: the smaller number.")
    private Optional<Integer> bits;

    @Option(names = "--uncompressed", description = "Writes exr as large as it is, for programs that cannot unpack it.")
    private boolean uncompressed;

    @Option(names = "--frames", paramLabel = "A-B", description = "Of a film, these frames only. Default: all that were shared out.")
    private Optional<FrameRange> frames;

    @Option(names = "--wait", paramLabel = "SECONDS", defaultValue = "0", description = "Waits so long for parts that are missing, looking for them after 1, 2, 4 seconds, in the end every 30. Default: 0.")
    private double patience;

    @Mixin
    private TellingWishes telling;

    MergeCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() {
        if (!(patience >= 0)) {
            throw new WrongUsage("--wait must be a number of seconds, 0 or above, but is " + Numbers.text(patience));
        }
        telling.prepare(output, stop);
        Target target = target(output);
        new Writing(bits, uncompressed).check(List.of(target.format()));
        try {
            Survey survey = Assembly.checked(awaited(), stop);
            if (!survey.isWhole()) {
                return refuse(survey);
            }
            survey.damaged().forEach(sentence -> terminal.message("note: " + sentence + "; other parts have what it should"));
            return survey.span().isStill() ? merge(survey, target) : film(survey);
        } catch (IOException e) {
            return failed(Failures.sentence(folder.toString(), e));
        } catch (OutOfMemoryError e) {
            return failed(folder + ": " + Memory.sentence("the picture", 0));
        }
    }

    private Target target(Optional<String> place) {
        String name = Objects.requireNonNullElse(folder.toAbsolutePath().normalize().getFileName(), folder).toString();
        SceneSource parts = new SceneSource(folder, folder.toString(), name, () -> {
            throw new IOException("these are parts of a picture");
        });
        return new Targets(place, format, false).of(List.of(parts)).get(0);
    }

    /** Puts frames together one after the other, each to a picture of its own. */
    private int film(Survey survey) throws IOException {
        FrameRange range = new FrameRange(survey.dealt().first(), survey.dealt().last());
        Target target = target(range.count() == 1 ? output : Optional.of(numbered()));
        for (Map.Entry<Integer, Survey> frame : survey.byFrame().entrySet()) {
            int code = merge(frame.getValue(), target.ofFrame(range, frame.getKey()));
            if (code != ExitCode.DONE) {
                return code;
            }
        }
        return ExitCode.DONE;
    }

    /** The output with a place for the number of the frame. */
    private String numbered() {
        if (output.equals(Optional.of("-"))) {
            throw new WrongUsage("these are frames of a film, each a picture of its own, which go to files: -o '" + Target.FRAME + ".png'");
        }
        return Reel.numbered(output, new Targets(output, format, false));
    }

    /** What there is, as soon as nothing is missing, or when there is no more time. */
    private Survey awaited() throws IOException {
        long begin = System.nanoTime();
        Optional<Span> wanted = frames.map(range -> new Span(range.first(), range.last()));
        Heads heads = new Heads();
        try {
            while (!Files.exists(folder) && isPatient(begin)) {
                TimeUnit.MILLISECONDS.sleep(MILLIS_BETWEEN);
            }
            Survey survey = Survey.of(folder, wanted, heads);
            // Parts of another picture do not go away by waiting.
            for (long pause = MILLIS_BETWEEN; !survey.isWhole() && survey.foreign().isEmpty() && isPatient(begin); pause = Math.min(2 * pause, MOST_BETWEEN)) {
                for (long waited = 0; waited < pause && isPatient(begin); waited += MILLIS_BETWEEN) {
                    TimeUnit.MILLISECONDS.sleep(MILLIS_BETWEEN);
                }
                survey = Survey.of(folder, wanted, heads);
            }
            return survey;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("interrupted");
        }
    }

    private boolean isPatient(long begin) {
        return (System.nanoTime() - begin) / 1e9 < patience && !stop.requested();
    }

    private int merge(Survey survey, Target target) throws IOException {
        Card card = survey.card().orElseThrow();
        View view = View.ofParts(card.mode(), card.legend());
        check(card, view, target);
        if (Assembly.memory(survey) > Memory.allowed()) {
            return failed(folder + ": " + Memory.sentence("the picture of " + card.region().width() + "x" + card.region().height() + " pixels", Assembly.memory(survey)));
        }
        Assembly whole = Assembly.of(survey, stop);
        Image image = view.finished(whole.image(), target.format());
        ImageOptions how = card.applyTo(new Writing(bits, uncompressed).options()).withOrigin(Origins.areToldIn(target.format()) ? whole.origin() : Origin.UNTOLD);
        try {
            stop.guard(() -> target.write(view.written(target.format()), image, whole.layers(), view.written(target.format(), how), terminal));
        } catch (IOException e) {
            return failed(Failures.sentence(target.file().map(Path::toString).orElse("standard output"), e));
        }
        String line = folder + " -> " + target.shown() + "  " + image.width() + "x" + image.height() + "  " + survey.parts().size() + " parts";
        if (telling.isJson()) {
            terminal.result(said("done").with("output", target.shown()).with("width", image.width()).with("height", image.height()).with("parts", survey.parts().size()).toString());
        } else if (!telling.isQuiet() && target.file().isPresent()) {
            terminal.result(line);
        } else if (!telling.isQuiet()) {
            terminal.message(line);
        }
        return ExitCode.DONE;
    }

    /** @throws WrongUsage if the format cannot hold what the parts have */
    private static void check(Card card, View view, Target target) {
        String ending = target.format().extension();
        if (!card.layers().isEmpty() && target.format() != ImageFormat.EXR) {
            throw new WrongUsage(ending + " has no layers, which these parts have; let the output end in .exr");
        }
        if (card.transparent() && !target.format().isTransparent()) {
            throw new WrongUsage(ending + " has no opacity, which these parts have; let the output end in .png or .exr");
        }
        if (view.isNumbers(target.format()) != card.numbers()) {
            throw new WrongUsage(card.numbers() ? "these parts hold numbers, for exr, pfm, txt and lum; for " + ending + ", render them with --format " + ending
                    : "these parts hold colours and no numbers; for those in " + ending + ", render them with --format " + ending);
        }
    }

    private int refuse(Survey survey) throws IOException {
        List<String> obstacles = survey.obstacles(stop);
        obstacles.forEach(terminal::message);
        if (telling.isJson()) {
            terminal.result(said("parts lacking").with("parts", survey.parts().size()).withTexts("problems", obstacles).toString());
        }
        return ExitCode.PARTS_LACKING;
    }

    private int failed(String sentence) {
        boolean isStopped = stop.requested();
        terminal.message(isStopped ? folder + ": interrupted, no picture written" : sentence);
        if (telling.isJson()) {
            terminal.result(said(isStopped ? "interrupted" : "failed").withTexts("problems", List.of(sentence)).toString());
        }
        return isStopped ? ExitCode.INTERRUPTED : ExitCode.FAILED;
    }

    private Json said(String outcome) {
        return new Json().with("directory", folder.toString()).with("outcome", outcome);
    }
}
