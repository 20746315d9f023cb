package cz.paprsek.cli;

import cz.paprsek.asset.Assets;
import cz.paprsek.cli.input.ChosenScene;
import cz.paprsek.cli.input.Foreign;
import cz.paprsek.cli.input.GradedPictures;
import cz.paprsek.cli.output.GradeProgress;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Interruption;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.StoredImage;
import cz.paprsek.io.Failures;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Says whether pictures of a scene are right, and if not, which mistakes explain them. */
@Command(
        name = "grade",
        description = {
            "Says whether pictures of a scene that others have made are right, and if not, which mistakes explain them best, one or two, of those that "
                    + "'paprsek render --help' lists. The first line is 'right', the mistake, 'one of: ...' if several give the same picture, or 'unexplained'.",
            "Pictures may be of any size and format, also text of brightness; they are compared in steps of 1/255 of sRGB. One ray a pixel and the scene's own "
                    + "samples are both tried."
        },
        footer = {
            "",
            "Examples:",
            "  paprsek grade glass.xml student.png",
            "  paprsek grade glass.xml student.ppm --evidence why.png",
            "  paprsek grade glass.xml pictures/ --csv > grades.csv"
        })
final class GradeCommand implements Callable<Integer> {
    private final Terminal terminal;
    private final Stop stop;

    @Parameters(index = "0", paramLabel = "SCENE", description = "A scene file or a database.")
    private Path file;

    @Parameters(index = "1..*", arity = "1..*", paramLabel = "PICTURE", description = "Pictures, or folders of them; patterns with * are expanded.")
    private List<String> words;

    @Mixin
    private ChosenScene chosen;

    @Option(names = "--samples", paramLabel = "N", description = "Rays along each side of a pixel that the pictures were made with, 1-16, if that is known.")
    private Optional<Integer> samples;

    @Option(names = "--evidence", paramLabel = "FILE|DIR", description = {
        "Writes a picture of four: the given one, the right one; below, the one with the mistake, and where that and the given one differ. A directory (which "
                + "ends in /) for several."})
    private Optional<String> evidence;

    @Option(names = "--csv", description = "Prints a table instead, a line for each picture.")
    private boolean csv;

    @Option(names = "--json", description = "Prints a JSON object for each picture, one a line.")
    private boolean json;

    GradeCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() {
        if (csv && json) {
            throw new WrongUsage("--csv and --json are two forms of the same; say one");
        }
        List<Path> files = GradedPictures.files(words);
        Evidence drawn = new Evidence(evidence, file, files);
        try {
            Scene scene = chosen.of(file);
            Assets assets = chosen.pictures().read(file, scene);
            drawn.spare(chosen.pictures().files(file, assets.digests().keySet()));
            RenderSettings settings = samples.map(scene.settings()::withSamples).orElse(scene.settings());
            GradeReport report = new GradeReport(terminal, stop, csv, json, files.size() > 1 || !Path.of(words.get(0)).equals(files.get(0)), drawn);
            report.begin();
            Grading grading = new Grading(scene.withSettings(settings), assets, samples.isPresent(), stop);
            int worst = ExitCode.DONE;
            for (Path picture : files) {
                worst = Math.max(worst, grade(picture, grading, report));
            }
            return worst;
        } catch (CancellationException interrupted) {
            return Interruption.told(terminal, json);
        } catch (SceneFileException e) {
            e.problems().forEach(problem -> terminal.message(problem.toString()));
            return ExitCode.BAD_SCENE;
        } catch (IOException e) {
            terminal.message(Failures.sentence(file.toString(), e));
            return ExitCode.BAD_SCENE;
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(file + ": " + refused.getMessage());
        }
    }

    private int grade(Path picture, Grading grading, GradeReport report) {
        StoredImage given;
        try {
            given = ImageFiles.readStored(picture);
        } catch (IOException e) {
            terminal.message(Failures.sentence(picture.toString(), e) + Foreign.sceneInPlaceOfPicture(picture));
            return ExitCode.BAD_SCENE;
        }
        Grading.Graded graded;
        try (GradeProgress progress = new GradeProgress(terminal, picture.toString())) {
            graded = grading.of(given, progress);
        }
        return report.told(picture, graded);
    }
}
