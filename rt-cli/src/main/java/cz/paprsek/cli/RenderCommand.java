package cz.paprsek.cli;

import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.io.PlainText;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderResult.Outcome;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.Tile;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/** {@code rt-cli render}. */
@Command(
        name = "render",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description = "Renders scene files to pictures. One that fails does not stop the others.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  rt-cli render ball.xml                       writes ball.png here",
            "  rt-cli render ball.xml -o ball.jpg           the format by the ending",
            "  rt-cli render 'scenes/*.xml' -o pictures/    one picture a scene",
            "  rt-cli render a.xml b.xml -o '{name}-small.png' --size 320x180",
            "  rt-cli render ball.xml --region 100,50,64,64 only that part",
            "",
            "Exit codes: 0 done, 1 rendering failed, 2 wrong usage, 3 bad scene file, 130 interrupted."})
final class RenderCommand implements Callable<Integer> {
    @Spec private CommandSpec spec;
    @ParentCommand private Cli cli;

    @Parameters(paramLabel = "SCENE", arity = "1..*", description = "Scene files, or patterns such as 'scenes/*.xml'.")
    private List<String> scenes;

    @Option(names = {"-o", "--output"}, paramLabel = "FILE|PATTERN|DIR", defaultValue = "",
            description = "Where to write: a file, a pattern in which {name} stands for the scene file's name, or a folder. "
                    + "Default: the scene file's name in the working directory.")
    private String output;

    @Option(names = "--size", paramLabel = "WxH", description = "Picture size in pixels, 1-32768 each. Default: what the scene says, or 800x600.")
    private @Nullable String size;

    @Option(names = "--threads", paramLabel = "N", description = "How many threads, 1-1024. Default: all processors. The picture does not depend on it.")
    private @Nullable Integer threads;

    @Option(names = "--max-depth", paramLabel = "N", description = "Levels of rays, 1-250; the eye ray is level 1. Default: what the scene says, or 5.")
    private @Nullable Integer maxDepth;

    @Option(names = "--samples", paramLabel = "N", description = "Rays along each side of a pixel, 1-16. Default: what the scene says, or 1.")
    private @Nullable Integer samples;

    @Option(names = "--region", paramLabel = "X,Y,W,H", description = "Compute only this part; the picture has the part's size.")
    private @Nullable String region;

    @Option(names = "--format", paramLabel = "FORMAT", converter = Formats.class, completionCandidates = Formats.class,
            description = "One of: ${COMPLETION-CANDIDATES}. Default: by the ending of the file, or png.")
    private @Nullable ImageFormat format;

    @Option(names = "--raw", description = "Write linear luminance as decimal text; the same as --format lum.")
    private boolean raw;

    @Option(names = "--json", description = "Print one JSON object per scene instead of a line.")
    private boolean json;

    @Option(names = {"-q", "--quiet"}, description = "Print errors only.")
    private boolean quiet;

    @Override
    public Integer call() throws IOException {
        Outputs outputs = new Outputs(output, raw ? ImageFormat.RAW : format);
        List<Path> files = files();
        Map<Path, Path> writers = new HashMap<>();
        for (Path file : files) {
            check(file, outputs, writers);
        }
        int worst = ExitCode.DONE;
        for (Path file : files) {
            worst = Math.max(worst, render(file, outputs));
            if (cli.interruption().isRequested()) {
                return ExitCode.INTERRUPTED;
            }
        }
        return worst;
    }

    private List<Path> files() {
        try {
            return SceneArguments.expand(scenes);
        } catch (IOException e) {
            throw wrong(String.valueOf(e.getMessage()));
        }
    }

    /** Finds out what cannot work before hours of rendering, not after. */
    private void check(Path scene, Outputs outputs, Map<Path, Path> writers) {
        settings(RenderSettings.DEFAULT);
        Path picture = outputs.file(scene);
        if (outputs.formatOf(picture) == null) {
            throw wrong(picture + ": the ending does not tell the format; use one of " + ImageFormat.all() + ", or --format");
        }
        Path other = writers.put(picture.toAbsolutePath().normalize(), scene);
        if (other != null) {
            throw wrong("both " + other + " and " + scene + " would be written to " + picture
                    + (outputs.isForMany() ? "" : "; give -o a folder, or a pattern with " + Outputs.NAME));
        }
    }

    private int render(Path file, Outputs outputs) {
        PrintWriter err = spec.commandLine().getErr();
        try {
            Scene scene = SceneFiles.read(file);
            Path picture = outputs.file(file);
            RenderOptions options = options(settings(scene.settings()));
            RenderResult result = trace(scene, options, file);
            if (result.outcome() == Outcome.DONE) {
                Files.createDirectories(picture.toAbsolutePath().getParent());
                ImageFormat kind = outputs.formatOf(picture);
                ImageFiles.write(result.image(), picture, kind == null ? ImageFormat.PNG : kind);
            }
            report(new RenderReport(file, picture, result));
            return ExitCode.DONE;
        } catch (SceneFileException e) {
            e.problems().forEach(problem -> err.println(problem));
            return ExitCode.BAD_SCENE;
        } catch (IOException e) {
            err.println(PlainText.of(String.valueOf(e.getMessage()), 500));
            return Files.isReadable(file) ? ExitCode.FAILED : ExitCode.BAD_SCENE;
        } catch (IllegalStateException | OutOfMemoryError e) {
            err.println(file + ": " + PlainText.of(String.valueOf(e.getMessage()), 500));
            return ExitCode.FAILED;
        }
    }

    private RenderResult trace(Scene scene, RenderOptions options, Path file) {
        try (Progress progress = new Progress(file.getFileName().toString(), spec.commandLine().getErr(), quiet, cli.interruption())) {
            return Renderer.render(scene, options, progress);
        }
    }

    private void report(RenderReport report) {
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(report.toJson());
        } else if (!quiet && report.result().outcome() == Outcome.DONE) {
            out.println(report.toLine());
        } else if (report.result().outcome() == Outcome.CANCELLED) {
            spec.commandLine().getErr().println(report.scene() + ": interrupted, nothing was written");
        }
    }

    private RenderSettings settings(RenderSettings scene) {
        try {
            RenderSettings settings = scene;
            if (size != null) {
                int[] sides = numbers(size.toLowerCase(java.util.Locale.ROOT), "x", 2, "--size takes WIDTHxHEIGHT, such as 1280x720");
                settings = settings.withSize(sides[0], sides[1]);
            }
            settings = maxDepth == null ? settings : settings.withMaxDepth(maxDepth);
            settings = samples == null ? settings : settings.withSamples(samples);
            if (threads != null) {
                RenderOptions.of(settings).withThreads(threads);
            }
            return settings;
        } catch (IllegalArgumentException e) {
            throw wrong(String.valueOf(e.getMessage()));
        }
    }

    private RenderOptions options(RenderSettings settings) {
        try {
            RenderOptions options = RenderOptions.of(settings);
            options = threads == null ? options : options.withThreads(threads);
            if (region == null) {
                return options;
            }
            int[] part = numbers(region, ",", 4, "--region takes X,Y,WIDTH,HEIGHT, such as 100,50,64,64");
            return options.withRegion(new Tile(part[0], part[1], part[2], part[3]));
        } catch (IllegalArgumentException e) {
            throw wrong(String.valueOf(e.getMessage()));
        }
    }

    private int[] numbers(String text, String separator, int count, String sentence) {
        List<String> words = List.of(text.split(separator, -1));
        try {
            int[] numbers = words.stream().mapToInt(Integer::parseInt).toArray();
            if (numbers.length == count) {
                return numbers;
            }
        } catch (NumberFormatException e) {
            throw wrong(sentence + ", but was given \"" + text + "\"");
        }
        throw wrong(sentence + ", but was given \"" + text + "\"");
    }

    private ParameterException wrong(String sentence) {
        return new ParameterException(spec.commandLine(), sentence);
    }
}
