package cz.paprsek.cli;

import cz.paprsek.cli.input.ChosenScene;
import cz.paprsek.cli.input.SceneReading;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Interruption;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.PixelPlace;
import cz.paprsek.cli.value.Size;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Failures;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderScene;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.sheet.Worksheet;
import cz.paprsek.words.Words;
import cz.paprsek.xml.SceneFileException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Writes pixels as exercises for the classroom, with their solutions. */
@Command(
        name = "worksheet",
        description = {
            "Writes pixels as exercises to be printed: of each the sketch of its rays, what is given, and lines to fill in, each reckoned from the numbers above it "
                    + "with a pocket calculator, to four decimals. The solutions are on a sheet of their own. Of the ray through the middle of a pixel.",
            "A PDF has pages of A4; a page of HTML is printed by a browser."
        },
        footer = {
            "",
            "Examples:",
            "  paprsek worksheet csg.xml --pixel 480,300 -o sheet.pdf",
            "  paprsek worksheet csg.xml --pixel 480,300 --pixel 200,400 --seed 7 \\",
            "      --language cs -o 7.html"
        })
final class WorksheetCommand implements Callable<Integer> {
    private final Terminal terminal;
    private final Stop stop;

    @Parameters(index = "0", paramLabel = "SCENE", description = "A scene file or a database; - is standard input.")
    private Path file;

    @Option(names = "--pixel", paramLabel = "COLUMN,ROW", required = true, description = "A pixel, from 0,0 at the top left. May be given several times.")
    private List<PixelPlace> places;

    @Option(names = "--seed", paramLabel = "N", description = {
        "Makes variant N: for each pixel another one whose rays meet the same surfaces and lights, so that each student has other numbers."})
    private Optional<Integer> seed;

    @Option(names = "--language", paramLabel = "LANGUAGE", defaultValue = "en", description = "${COMPLETION-CANDIDATES}: English or Czech. Default: ${DEFAULT-VALUE}.")
    private Language language;

    @Option(names = {"-o", "--output"}, paramLabel = "FILE", required = true, description = "The worksheet, which ends in .pdf or .html.")
    private Path output;

    @Mixin
    private ChosenScene chosen;

    @Option(names = "--size", paramLabel = "WxH", description = "Width and height of the picture in pixels. Default: the scene's.")
    private Optional<Size> size;

    /** What the page is written in. */
    enum Language { en, cs }

    WorksheetCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() {
        if (!isPdf() && !output.toString().toLowerCase(Locale.ROOT).endsWith(".html")) {
            throw new WrongUsage("a worksheet is a PDF, or a page that browsers print: name a file that ends in .pdf or .html, not " + output);
        }
        byte[] page;
        try {
            Scene scene = chosen.of(file);
            page = page(scene);
        } catch (CancellationException interrupted) {
            return Interruption.told(terminal, false);
        } catch (SceneFileException e) {
            e.problems().forEach(problem -> terminal.message(problem.toString()));
            return ExitCode.BAD_SCENE;
        } catch (IOException e) {
            terminal.message(SceneReading.sentence(file, file.toString(), chosen.pictures(), e));
            return ExitCode.BAD_SCENE;
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(file + ": " + refused.getMessage());
        } catch (IllegalStateException failed) {
            terminal.message(file + ": " + failed.getMessage());
            return ExitCode.FAILED;
        }
        try {
            stop.write(output, () -> AtomicFile.write(output, out -> out.write(page)));
            return ExitCode.DONE;
        } catch (IOException e) {
            terminal.message(Failures.sentence(output.toString(), e));
            return ExitCode.FAILED;
        }
    }

    private boolean isPdf() {
        return output.toString().toLowerCase(Locale.ROOT).endsWith(".pdf");
    }

    private byte[] page(Scene scene) throws IOException {
        RenderMonitor monitor = new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return stop.requested();
            }
        };
        RenderSettings settings = size.map(wanted -> scene.settings().withSize(wanted.width(), wanted.height())).orElse(scene.settings());
        try {
            RenderScene ready = RenderScene.of(scene, chosen.pictures().read(file, scene), monitor);
            Worksheet sheet = new Worksheet(scene, ready, settings, places.stream().map(place -> new int[] {place.column(), place.row()}).toList(),
                    seed.map(OptionalLong::of).orElse(OptionalLong.empty()), Words.in(Locale.forLanguageTag(language.name())));
            return isPdf() ? sheet.pdf() : sheet.html().getBytes(StandardCharsets.UTF_8);
        } catch (UncheckedIOException unreadable) {
            throw new IOException(unreadable.getMessage(), unreadable);
        }
    }
}
