package cz.paprsek.cli;

import cz.paprsek.cli.input.ChosenScene;
import cz.paprsek.cli.input.FrameChoice;
import cz.paprsek.cli.input.LightWishes;
import cz.paprsek.cli.input.MistakeWishes;
import cz.paprsek.cli.input.Originals;
import cz.paprsek.cli.input.RayWishes;
import cz.paprsek.cli.input.SceneReading;
import cz.paprsek.cli.input.Wishes;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Interruption;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.PixelPlace;
import cz.paprsek.cli.value.Size;
import cz.paprsek.drawing.TreeDrawing;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Failures;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.Pixel.PathPixel;
import cz.paprsek.render.explain.Pixel.PathPixel.Example;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.text.Decoration;
import cz.paprsek.render.explain.text.PathJson;
import cz.paprsek.render.explain.text.PathLines;
import cz.paprsek.render.explain.text.TreeJson;
import cz.paprsek.render.explain.text.TreeText;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.Beside;
import cz.paprsek.teach.mistake.Mistakes;
import cz.paprsek.words.Words;
import cz.paprsek.xml.SceneFileException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.function.BiFunction;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Says why a pixel has its colour. */
@Command(
        name = "explain",
        description = {
            "Says why a pixel of the picture has its colour: every ray behind it, what it hits, and what each light, the mirrored and the "
                    + "refracted ray add, with formula, numbers and result.",
            "Of a pixel of paths (--integrator path): by which ways its light came, from what, and a few paths point by point.",
            "Rays are named by how they came about: E from the eye, then R for reflected and T for transmitted, so that ETR is what is "
                    + "reflected inside the first body of glass."
        },
        footer = {
            "",
            "Examples:",
            "  paprsek explain scenes/glass.xml 250,300          on the glass ball",
            "  paprsek explain scenes/glass.xml 83,100 --size 320x180 | less",
            "  paprsek explain scenes/glass.xml 250,300 --svg rays.svg",
            "  paprsek explain scenes/glass.xml 250,300 --json   for a script",
            "  paprsek explain scenes/glass.xml 250,300 --integrator path",
            "  paprsek explain scenes/glass.xml 250,300 --mistake snell-upside-down",
            "  paprsek explain scenes/database.xml 400,300 --scene Gears"
        })
final class ExplainCommand implements Callable<Integer> {
    private static final double SMALLEST_SHARE = 0.01;

    private final Terminal terminal;
    private final Stop stop;

    @Parameters(index = "0", paramLabel = "SCENE", description = "A scene file or a database; - is standard input.")
    private Path file;

    @Parameters(index = "1", paramLabel = "COLUMN,ROW", description = "The pixel, from 0,0 at the top left.")
    private PixelPlace place;

    @Mixin
    private ChosenScene chosen;

    @Option(names = "--size", paramLabel = "WxH", description = "Width and height of the picture in pixels. Default: the scene's.")
    private Optional<Size> size;

    @Mixin
    private FrameChoice frame;

    @Mixin
    private RayWishes rays;

    @Mixin
    private LightWishes light;

    @Option(names = "--max-depth", paramLabel = "N", description = "Levels of reflected and refracted rays, 1-250. Default: the scene's.")
    private Optional<Integer> maxDepth;

    @Option(names = "--all", description =
            "Shows all rays, also those whose share in the pixel's light is below 1 percent, and of a pixel of several samples the tree of each, "
                    + "not only of the one whose light is nearest to the pixel's.")
    private boolean all;

    @Option(names = "--color", paramLabel = "WHEN", defaultValue = "auto",
            description = "${COMPLETION-CANDIDATES}. Default: auto, on a terminal unless NO_COLOR is set.")
    private When color;

    @Option(names = "--json", description = "Prints the tree as a JSON object.")
    private boolean json;

    @Option(names = "--svg", paramLabel = "FILE", description =
            "Draws the rays in three projections, with the outlines of what they meet; of a pixel of several samples, the one whose light is nearest to the pixel's, "
                    + "and of paths one that is typical of how most of its light came.")
    private Optional<Path> svg;

    /** When to use colours. */
    enum When { auto, always, never }

    @Mixin
    private MistakeWishes mistakes;

    ExplainCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() {
        if (json) {
            stop.oweLastWords();
        }
        svg.filter(drawing -> ImageFormat.ofFile(drawing.toString()).isPresent()).ifPresent(picture -> {
            throw new WrongUsage("--svg draws the rays in SVG: name a file that ends in .svg, not " + picture);
        });
        svg.ifPresent(drawing -> Originals.spare(drawing, "the drawing", "the scene", List.of(file)));
        Wishes wishes = new Wishes(size, maxDepth, rays, light, Optional.empty(), Optional.empty());
        try {
            Scene scene = frame.of(chosen.of(file));
            if (!mistakes.made().equals(Mistakes.NONE)) {
                return beside(scene, options(wishes, scene).settings());
            }
            return explain(scene, options(wishes, scene));
        } catch (CancellationException interrupted) {
            return Interruption.told(terminal, json);
        } catch (IllegalStateException e) {
            terminal.message(file + ": " + e.getMessage());
            return ExitCode.FAILED;
        } catch (SceneFileException e) {
            e.problems().forEach(problem -> terminal.message(problem.toString()));
            return ExitCode.BAD_SCENE;
        } catch (IOException e) {
            terminal.message(SceneReading.sentence(file, file.toString(), chosen.pictures(), e));
            return ExitCode.BAD_SCENE;
        }
    }

    /** Which numbers of samples there are, the scene's integrator says. */
    private RenderOptions options(Wishes wishes, Scene scene) {
        try {
            return wishes.applyTo(scene.settings());
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(file + ": " + refused.getMessage());
        }
    }

    private int beside(Scene scene, RenderSettings settings) {
        if (svg.isPresent()) {
            throw new WrongUsage("--mistake tells numbers, and draws no rays; leave --svg away");
        }
        try {
            Beside beside = new Beside(scene, settings, mistakes.made(), place.column(), place.row());
            if (json) {
                terminal.result(beside.json().toString());
            } else {
                beside.lines(Words.ENGLISH).forEach(line -> terminal.result(Letters.fit(line)));
            }
            return ExitCode.DONE;
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(file + ": " + refused.getMessage());
        }
    }

    private int explain(Scene scene, RenderOptions options) throws IOException {
        Optional<TracedRay> drawn;
        if (options.settings().isPath()) {
            PathPixel pixel = explained(scene, (ready, monitor) -> ready.explainPaths(options, place.column(), place.row(), monitor));
            show(pixel);
            drawn = pixel.examples().stream().map(Example::ray).findFirst();
        } else {
            Pixel pixel = explained(scene, (ready, monitor) -> ready.explain(options, place.column(), place.row(), monitor));
            show(pixel);
            drawn = Optional.of(pixel.rays().get(pixel.typical()));
        }
        if (svg.isPresent() && drawn.isEmpty()) {
            terminal.message(svg.get() + ": not drawn, as no path brings any light");
        } else if (svg.isPresent() && !draw(TreeDrawing.svg(scene, drawn.get(), all || options.settings().isPath() ? 0 : SMALLEST_SHARE, Words.ENGLISH), svg.get())) {
            return ExitCode.FAILED;
        }
        return stop.requested() ? ExitCode.INTERRUPTED : ExitCode.DONE;
    }

    private <T> T explained(Scene scene, BiFunction<RenderScene, RenderMonitor, T> how) throws IOException {
        RenderMonitor monitor = new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return stop.requested();
            }
        };
        try {
            return how.apply(RenderScene.of(scene, chosen.pictures().read(file, scene), monitor), monitor);
        } catch (UncheckedIOException unreadable) {
            throw new IOException(unreadable.getMessage(), unreadable);
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(file + ": " + refused.getMessage());
        }
    }

    private boolean draw(String drawing, Path target) {
        try {
            stop.write(target, () -> AtomicFile.write(target, out -> out.write(drawing.getBytes(StandardCharsets.UTF_8))));
            return true;
        } catch (IOException e) {
            terminal.message(Failures.sentence(target.toString(), e));
            return false;
        }
    }

    private void show(Pixel pixel) {
        if (json) {
            terminal.result(TreeJson.of(pixel).toString());
            return;
        }
        double smallest = all ? 0 : SMALLEST_SHARE;
        if (isColored()) {
            TreeText.lines(pixel, smallest, AnsiDecoration.ofSystem()).forEach(line -> terminal.out().println(Letters.fit(line)));
        } else {
            TreeText.lines(pixel, smallest, Decoration.NONE).forEach(line -> terminal.result(Letters.fit(line)));
        }
        if (!all && pixel.rays().size() > 1) {
            terminal.message("--all tells of each of the " + pixel.rays().size() + " rays in full, --samples 1 of the one through the middle of the pixel");
        }
    }

    private void show(PathPixel pixel) {
        if (json) {
            terminal.result(PathJson.of(pixel).toString());
        } else if (isColored()) {
            PathLines.lines(pixel, all ? 0 : SMALLEST_SHARE, AnsiDecoration.ofSystem(), Words.ENGLISH).forEach(line -> terminal.out().println(Letters.fit(line)));
        } else {
            PathLines.lines(pixel, all ? 0 : SMALLEST_SHARE, Decoration.NONE, Words.ENGLISH).forEach(line -> terminal.result(Letters.fit(line)));
        }
    }

    private boolean isColored() {
        return switch (color) {
            case always -> true;
            case never -> false;
            case auto -> System.getenv().getOrDefault("NO_COLOR", "").isEmpty() && Terminal.resultsAreWatched();
        };
    }
}
