package cz.paprsek.cli.bench;

import cz.paprsek.cli.input.Cameras;
import cz.paprsek.cli.input.FrameChoice;
import cz.paprsek.cli.input.Incoming;
import cz.paprsek.cli.input.Pictures;
import cz.paprsek.cli.input.SceneArguments;
import cz.paprsek.cli.input.SceneReading;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.Share;
import cz.paprsek.cli.value.Size;
import cz.paprsek.image.ImageComparison;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Failures;
import cz.paprsek.io.Folders;
import cz.paprsek.scene.Scene;
import cz.paprsek.text.Numbers;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Renders scenes here and with POV-Ray, and says how far the pictures are apart. */
@Command(
        name = "crosscheck",
        description = {
            "Renders scenes here and with POV-Ray, an independent program, and compares the pictures pixel by pixel in linear light of 16 bits.",
            "Where povray is not installed, its recorded pictures serve, NAME.png beside NAME.xml, and a line says so. One ray a pixel."
        },
        footer = {
            "",
            "Examples:",
            "  paprsek crosscheck rt-core/src/test/resources/crosscheck/*.xml",
            "  paprsek crosscheck mine.xml --size 160x90 --heatmaps differences/",
            "  paprsek crosscheck flight.xml --frame 30"
        })
public final class CrossCheckCommand implements Callable<Integer> {
    private static final String ROW = "%-30s %9s %9s %8s  %s";

    @Mixin
    private Pictures pictures;

    private final Terminal terminal;
    private final Stop stop;

    @Parameters(paramLabel = "SCENE", arity = "1..*",
            description = "Scene files, or - for standard input. Patterns with * ? [] {} and ** are expanded, also when quoted.")
    private List<String> scenes;

    @Option(names = "--tolerance", paramLabel = "STEPS", defaultValue = "2", description =
            "By how many 65535ths a channel may differ. Default: ${DEFAULT-VALUE}.")
    private double tolerance;

    @Option(names = "--at-most", paramLabel = "SHARE", defaultValue = "0.001", description =
            "Which share of pixels may differ by more, for the sake of outlines. Default: 0.1%%.")
    private Share atMost;

    @Option(names = "--camera", paramLabel = "CAMERA", description = Cameras.HELP)
    private Optional<String> camera;

    @Mixin
    private FrameChoice frame;

    @Option(names = "--size", paramLabel = "WxH", description = "Width and height in pixels. Default: the scene's. Needs povray.")
    private Optional<Size> size;

    @Option(names = "--recorded", description = "Compares with the recorded pictures even where povray is installed.")
    private boolean recorded;

    @Option(names = "--record", description = "Records the pictures that POV-Ray makes now, beside the scenes.")
    private boolean record;

    @Option(names = "--heatmaps", paramLabel = "DIR", description =
            "Writes a map of the differences to this directory, which is made, for every scene that differs.")
    private Optional<Path> heatmaps;

    public CrossCheckCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() throws InterruptedException {
        Optional<PovRay> live = recorded ? Optional.empty() : PovRay.installed();
        if (live.isEmpty() && (record || size.isPresent() || frame.isChosen())) {
            throw new WrongUsage(recorded ? "--recorded cannot be combined with --record, --size or --frame"
                    : "--record, --size and --frame need povray, which is not installed");
        }
        if (record && frame.isChosen()) {
            throw new WrongUsage("--record is of scenes as they are written, not of a --frame");
        }
        if (heatmaps.isPresent() && !isMade(heatmaps.get())) {
            return ExitCode.FAILED;
        }
        terminal.result(live.map(pov -> "POV-Ray " + pov.version() + ", run now").orElse(
                "POV-Ray 3.7, recorded" + (recorded ? "" : ": povray is not installed here, so nothing is checked live")));
        terminal.result(String.format(Locale.ROOT, ROW, "scene", "largest", "mean", "beyond", "in 65535ths; beyond: pixels by more than " + Numbers.text(tolerance)));
        int worst = ExitCode.DONE;
        for (Path file : SceneArguments.files(scenes)) {
            if ((record || live.isEmpty()) && Incoming.isOnce(file)) {
                throw new WrongUsage("'" + file + "' is not a file, and recorded pictures lie beside files");
            }
            if (stop.requested()) {
                return ExitCode.INTERRUPTED;
            }
            SceneReading reading = SceneReading.of(file);
            reading.sentences().forEach(terminal::message);
            if ((record || live.isEmpty()) && reading.scenes().size() > 1) {
                throw new WrongUsage(file + " is a database of " + reading.scenes().size() + " scenes, and a recorded picture lies beside a file of one");
            }
            worst = Math.max(worst, reading.isValid() ? ExitCode.DONE : ExitCode.BAD_SCENE);
            for (Scene scene : reading.scenes()) {
                worst = Math.max(worst, check(file, name(file, scene, reading.scenes().size()), scene, live));
            }
        }
        return worst;
    }

    /** Before the first scene is rendered: what cannot be written should be known then. */
    private boolean isMade(Path folder) {
        try {
            Folders.make(folder);
            AtomicFile.check(folder.resolve("map.png"));
            return true;
        } catch (IOException e) {
            terminal.message("cannot write to the directory " + Failures.sentence(folder.toString(), e));
            return false;
        }
    }

    /** That of the file; of one of several scenes with its own. */
    private static String name(Path file, Scene scene, int scenes) {
        return Objects.requireNonNullElse(file.getFileName(), file) + (scenes > 1 ? ": " + scene.name() : "");
    }

    private int check(Path file, String name, Scene scene, Optional<PovRay> live) throws InterruptedException {
        try {
            Scene seen = Cameras.through(frame.of(scene), camera);
            Scene sized = size.map(s -> seen.withSettings(seen.settings().withSize(s.width(), s.height()))).orElse(seen);
            CrossCheck check = CrossCheck.of(file, sized, pictures.read(file, sized), live, record, tolerance);
            ImageComparison found = check.comparison();
            boolean isSame = found.shareBeyond() <= atMost.value();
            terminal.result(String.format(Locale.ROOT, ROW, name, CompareCommand.steps(found.largest()), CompareCommand.steps(found.mean()),
                    found.beyond(), isSame ? "the same" : "DIFFERENT"));
            if (!isSame) {
                check.warnings().forEach(warning -> terminal.result("    " + warning));
                draw(name, check);
            }
            return isSame ? ExitCode.DONE : ExitCode.FAILED;
        } catch (IOException | UncheckedIOException | IllegalArgumentException noPicture) {
            terminal.message(name + ": " + Failures.sentence(noPicture));
            return ExitCode.FAILED;
        }
    }

    private void draw(String name, CrossCheck check) throws IOException {
        if (heatmaps.isPresent()) {
            Path map = heatmaps.get().resolve(name.replaceAll("[^\\p{L}\\p{N}._ -]+", "-") + ".png");
            stop.guard(() -> ImageFiles.write(ImageComparison.heatmap(check.ours(), check.theirs(), tolerance), map));
        }
    }
}
