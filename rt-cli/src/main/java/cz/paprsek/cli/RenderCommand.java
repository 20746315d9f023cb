package cz.paprsek.cli;

import cz.paprsek.cli.db.DbAction;
import cz.paprsek.cli.input.Cameras;
import cz.paprsek.cli.input.Foreign;
import cz.paprsek.cli.input.FrameWishes;
import cz.paprsek.cli.input.LightWishes;
import cz.paprsek.cli.input.MistakeWishes;
import cz.paprsek.cli.input.ParameterWishes;
import cz.paprsek.cli.input.PixelWishes;
import cz.paprsek.cli.input.RayWishes;
import cz.paprsek.cli.input.SceneArguments;
import cz.paprsek.cli.input.SceneSource;
import cz.paprsek.cli.input.TellingWishes;
import cz.paprsek.cli.input.Wishes;
import cz.paprsek.cli.output.Progress;
import cz.paprsek.cli.output.Reel;
import cz.paprsek.cli.output.RenderBatch;
import cz.paprsek.cli.output.Report;
import cz.paprsek.cli.output.Target;
import cz.paprsek.cli.output.Targets;
import cz.paprsek.cli.output.View;
import cz.paprsek.cli.output.Writing;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.shard.Again;
import cz.paprsek.cli.shard.ShardWork;
import cz.paprsek.cli.shard.Sharing;
import cz.paprsek.cli.shard.Span;
import cz.paprsek.cli.value.Modes;
import cz.paprsek.cli.value.OutputFormat;
import cz.paprsek.cli.value.Shard;
import cz.paprsek.cli.value.Size;
import cz.paprsek.cli.value.Words;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.query.Filter;
import cz.paprsek.query.SceneTables;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Tile;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.mistake.Mistakes;
import cz.paprsek.text.Numbers;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Renders scene files to pictures. */
@Command(
        name = "render",
        description = {
            "Renders scene files, and the scenes of databases, to pictures.",
            "One scene that fails does not stop the others; the exit code is that of the worst. A picture is written whole or not at all."
        },
        footer = {
            "",
            "Examples:",
            "  paprsek render showcase.xml                to showcase.png, here",
            "  paprsek render showcase.xml -o a.jpg --size 1920x1080 --samples 3",
            "  paprsek render 'scenes/*.xml' -o 'out/{name}-small.png' --size 320x180",
            "  paprsek render database.xml --where 'exists(torus)' -o pictures/",
            "  paprsek render a.xml --format ppm16 -o -   16-bit linear light to stdout",
            "  paprsek render a.xml --mode nodes -o t.png where the time goes, by pixel",
            "  paprsek render a.xml --shard 3/8 -o parts  an eighth of it, see merge",
            "  paprsek render a.xml --mistake full-fovy,no-shadow -o wrong.png",
            "  paprsek render flight.xml --frames 1-250 -o 'out/flight-{frame}.png'",
        "  paprsek render flight.xml --frames 1-250 --format y4m -o - \\",
        "      | ffmpeg -i - flight.mp4",
        "  paprsek render a.xml b.xml --json --quiet  one JSON object a line"
        })
final class RenderCommand implements Callable<Integer> {
    private final Terminal terminal;
    private final Stop stop;
    private final Optional<Sharing> sharing;

    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "SCENE", arity = "1..*",
            description = "Scene files, or - for standard input. Patterns with * ? [] {} and ** are expanded, also when quoted.")
    private List<String> scenes = List.of();

    @Option(names = "--where", paramLabel = "FILTER", description = "Only scenes that match; 'paprsek db --help' explains filters.")
    private Optional<String> where = Optional.empty();

    @Option(names = {"-o", "--output"}, paramLabel = "FILE|DIR|PATTERN", description = {
        "A file, for one scene; its ending says the format. A directory (which exists or ends in /), or a pattern in which {name} "
                + "stands for the scene's file name, or in a database its own, and {dir} for the directory the scene is in. Directories "
                + "are made. - is standard output.",
        "Default: {name}.png in the working directory."})
    private Optional<String> output = Optional.empty();

    @Option(names = "--format", paramLabel = "FORMAT", completionCandidates = OutputFormat.Names.class, description = {
        "One of ${COMPLETION-CANDIDATES}. Default: by the ending of the output, else png.",
        "exr, hdr, pfm and ppm16 hold linear light, txt brightness 0-255 and lum linear luminance, one image row a line; apng, gif and y4m are films, of --frames."})
    private Optional<OutputFormat> format = Optional.empty();

    @Option(names = "--raw", description = "Text output holds linear luminance as decimals, 1 for white, instead of 0-255: the same as --format lum.")
    private boolean raw;

    @Option(names = "--size", paramLabel = "WxH", description = "Width and height in pixels, each 1-32768. Default: the scene's.")
    private Optional<Size> size = Optional.empty();

    @Option(names = "--region", paramLabel = "X,Y,W,H", description =
            "Renders this part only: column and row of its top left pixel from 0, width, height. The picture has the part's size.")
    private Optional<Tile> region = Optional.empty();

    @Mixin
    private ParameterWishes given = new ParameterWishes();

    @Mixin
    private RayWishes rays = new RayWishes();

    @Option(names = "--max-depth", paramLabel = "N", description =
            "Levels of reflected and refracted rays, 1-250; the ray from the eye is level 1. Default: the scene's.")
    private Optional<Integer> maxDepth = Optional.empty();

    @Option(names = "--mode", paramLabel = "MODE", defaultValue = "shaded", completionCandidates = Modes.class, description = {
        "What the picture shows: ${COMPLETION-CANDIDATES}.",
        "rays, nodes and samples are counts per pixel, and error is how far its value may be from the true one, in steps of 255, on a scale of colours that is drawn below the "
                + "picture. In exr, pfm, txt and lum these and depth are numbers: counts, errors from 0 to 1, below 0 where they cannot be trusted, and distances in scene units, "
                + "0 where nothing is seen."})
    private RenderMode mode = RenderMode.SHADED;

    @Option(names = "--camera", paramLabel = "CAMERA", description = Cameras.HELP)
    private Optional<String> camera = Optional.empty();

    @Option(names = "--light", paramLabel = "LIGHT", description =
            "Shows what this light adds, by its name or its number from 1: the others are dark, ambient light and background black.")
    private Optional<String> light = Optional.empty();

    @Option(names = "--no-floor", description = "Leaves away the floor that files of other programs are given.")
    private boolean noFloor;

    @Option(names = "--no-legend", description = "Leaves away the scale of colours, so that the picture has the size asked for.")
    private boolean noLegend;

    @Option(names = "--threads", paramLabel = "N", description =
            "Threads to render with, 1-1024; the picture is the same for any number. Default: all processors.")
    private Optional<Integer> threads = Optional.empty();

    @Option(names = "--bits", paramLabel = "N", description =
            "Bits per channel: 8 or 16 of png, 16 or 32 of exr. Default: the smaller number.")
    private Optional<Integer> bits = Optional.empty();

    @Option(names = "--uncompressed", description = "Writes exr as large as it is, for programs that cannot unpack it.")
    private boolean uncompressed;

    @Mixin
    private LightWishes shown = new LightWishes();

    @Mixin
    private FrameWishes film = new FrameWishes();

    @Mixin
    private PixelWishes pixels = new PixelWishes();

    @Mixin
    private MistakeWishes mistakes = new MistakeWishes();

    @Option(names = "--resume", description = {
        "Keeps every finished tile in FILE.resume beside the picture, and goes on from there if an earlier render was interrupted or killed. "
                + "The picture is the same, to the last bit. The file is removed when the picture is written; with the integrator path it stays, for more paths later."})
    private boolean resume;

    @Option(names = "--time", paramLabel = "SECONDS", description =
            "Of the integrator path, makes as many passes of 64 paths a pixel as can be done in this time, at least one, unless --samples ends it before.")
    private Optional<Double> time = Optional.empty();

    @Option(names = "--shard", paramLabel = "I/N", description = {
        "Renders one share of the picture, the I-th of N, on this machine; others take the others. Its parts go to files in the directory -o, which is made, each when it is done; "
                + "those that are there already and whole are not made again. 'paprsek merge' puts them together to the same picture, to the last bit; 'paprsek plan' writes what clusters need."})
    private Optional<Shard> shard = Optional.empty();

    @Option(names = "--by", paramLabel = "WHAT", defaultValue = "tiles", description = {
        "How the work of --shard is dealt out: ${COMPLETION-CANDIDATES}. By passes, parts are of 64 paths of each of their pixels, for light alone by the integrator path, of as many paths everywhere. Default: tiles."})
    private By by = By.tiles;

    private enum By { tiles, passes }

    @Mixin
    private TellingWishes telling = new TellingWishes();

    RenderCommand(Terminal terminal, Stop stop) {
        this(terminal, stop, Optional.empty());
    }

    /** @param sharing takes the orders for shares, in place of files in a folder */
    RenderCommand(Terminal terminal, Stop stop, Optional<Sharing> sharing) {
        this.terminal = terminal;
        this.stop = stop;
        this.sharing = sharing;
    }

    /** What the words of a plain call say. */
    RenderCommand(Terminal terminal, Stop stop, PlainRender words) {
        this(terminal, stop);
        scenes = words.scenes();
        output = words.output();
        size = words.size();
        threads = words.threads();
        telling = new TellingWishes(words.isQuiet());
    }

    @Override
    public Integer call() {
        if (resume && output.equals(Optional.of("-"))) {
            throw new WrongUsage("--resume needs a file for the picture, to keep the tiles beside it");
        }
        checkWords();
        telling.prepare(output, stop);
        Wishes wishes = wishes();
        Reel reel = shard.isPresent() ? new Reel(film, Optional.empty()) : Reel.of(film, output, format);
        if (reel.film().isPresent() && (pixels.isTransparent() || pixels.haveLayers() || bits.isPresent() || raw || time.isPresent())) {
            throw new WrongUsage("--transparent, --aov, --bits, --raw and --time are for pictures, and " + reel.film().get().extension() + " is a film");
        }
        Optional<ImageFormat> picture = reel.pictures(format);
        Optional<String> place = shard.isPresent() ? output : reel.output(output, new Targets(output, picture, raw));
        List<Target> targets = shard.isPresent() ? List.of(shared(sources())) : new Targets(place, picture, raw).of(sources());
        if (!telling.isQuiet() && output.isPresent() && !place.equals(output)) {
            terminal.message("the pictures go to " + place.get());
        }
        Writing writing = new Writing(bits, uncompressed);
        writing.check(targets.stream().map(Target::format).toList());
        View view = view();
        view.check(targets);
        Progress.Maker progress = telling.isQuiet() ? Progress.Maker.SILENT : Progress.maker(terminal);
        Optional<Sharing> share = shard.map(one -> sharing.orElseGet(() -> new ShardWork(one, Words.path(output.orElseThrow()), sharedWords(), isByPasses())));
        return new RenderBatch(terminal, stop, wishes, view, writing, resume, time, given.pictures(), reel, progress, Report.of(terminal, telling.isJson(), telling.isQuiet()), share).run(targets);
    }

    /** @throws WrongUsage if some words do not go together */
    private void checkWords() {
        if (mode != RenderMode.SHADED && mode != RenderMode.ERROR && shown.areSaid()) {
            throw new WrongUsage("--exposure and --tone are for light, which --mode " + mode + " does not show");
        }
        if (mode != RenderMode.SHADED && (pixels.isTransparent() || pixels.haveLayers())) {
            throw new WrongUsage("--transparent and --aov are for pictures of light, which --mode " + mode + " is not");
        }
        if (time.isPresent() && !(time.get() > 0)) {
            throw new WrongUsage("--time must be a number of seconds above 0, but is " + Numbers.text(time.get()));
        }
        if (!mistakes.made().equals(Mistakes.NONE) && (mode != RenderMode.SHADED || region.isPresent() || resume || time.isPresent() || pixels.isTransparent() || pixels.haveLayers() || pixels.isDenoised())) {
            throw new WrongUsage("--mistake is for whole pictures of light, without --mode, --region, --resume, --time, --transparent, --aov and --denoise");
        }
        if (isByPasses() && (shard.isEmpty() || sharing.isPresent())) {
            throw new WrongUsage("--by says how the work of --shard is dealt out" + (sharing.isPresent() ? "; an engine deals it out by itself, in tiles and frames" : ", which is not there"));
        }
        shard.ifPresent(one -> checkShared());
    }

    private boolean isByPasses() {
        return by == By.passes;
    }

    private void checkShared() {
        if (output.isEmpty() || output.get().equals("-")) {
            throw new WrongUsage("--shard needs a directory for its parts, -o DIR");
        }
        if (resume || time.isPresent() || !mistakes.made().equals(Mistakes.NONE)) {
            throw new WrongUsage("--shard is without --resume, which it does by itself, and without --time and --mistake");
        }
        if (bits.isPresent() || uncompressed || raw || format.flatMap(OutputFormat::film).isPresent()) {
            throw new WrongUsage("--bits, --uncompressed, --raw and films' formats are said when the parts are put together: paprsek merge DIR -o FILE");
        }
        if (ImageFormat.ofFile(output.get()).isPresent()) {
            throw new WrongUsage("with --shard, -o is a directory for parts, not a picture such as " + output.get());
        }
    }

    /** The directory of parts in place of a picture, in the format that can hold whatever is known of their pixels. */
    private Target shared(List<SceneSource> sources) {
        if (sources.size() > 1) {
            throw new WrongUsage("--shard is for one scene, but there are " + sources.size() + "; of a database, choose one with --where 'name = ...'");
        }
        return new Target(sources.get(0), Optional.of(Words.path(output.orElseThrow())), sharedFormat(), "");
    }

    private ImageFormat sharedFormat() {
        boolean isMore = pixels.haveLayers() || pixels.isTransparent();
        return format.flatMap(OutputFormat::picture).orElse(isMore ? ImageFormat.EXR : ImageFormat.PNG);
    }

    private Wishes wishes() {
        return new Wishes(size, maxDepth, rays, shown, region, threads);
    }

    private View view() {
        return new View(mode, camera, light, !noLegend, pixels, mistakes.made());
    }

    /** What a scene is made of beside its file. */
    ParameterWishes given() {
        return given;
    }

    /** The words of the command line but those that say whose work it is and where it goes. */
    private List<String> sharedWords() {
        return Again.shared(spec.commandLine().getParseResult().originalArgs());
    }

    /** @throws WrongUsage if the words cannot be said of a share, or its parts cannot be put together to a picture of a format */
    void checkShare(Path scene, ImageFormat merged) {
        checkWords();
        View view = view();
        view.check(List.of(new Target(SceneSource.of(scene, !noFloor, given), Optional.empty(), merged, "")));
        if (view.isNumbers(merged) != view.isNumbers(sharedFormat())) {
            throw new WrongUsage("parts for " + merged.extension() + " must hold " + (view.isNumbers(merged) ? "numbers" : "colours") + "; add --format " + merged.extension());
        }
    }

    /**
     * Into how many parts the picture of a scene is divided, for so many shares.
     *
     * @throws WrongUsage if the words do not suit the scene
     */
    long shares(Scene read, int count) {
        try {
            RenderOptions options = view().applyTo(wishes().applyTo(Cameras.through(read, camera).settings()), ImageFormat.EXR);
            return ShardWork.parts(options, film.frames().map(range -> new Span(range.first(), range.last())).orElse(Span.STILL), isByPasses(), count);
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(String.valueOf(refused.getMessage()));
        }
    }

    private List<SceneSource> sources() {
        if (output.isEmpty()) {
            scenes.stream().filter(RenderCommand::isMeantAsPicture).findFirst().ifPresent(word -> {
                throw new WrongUsage("is " + word + " meant as the output? say -o " + word);
            });
        }
        Optional<Filter<Scene>> filter = where.map(text -> DbAction.filter("--where", Optional.of(text), SceneTables.SCENE));
        List<SceneSource> sources = SceneSource.all(SceneArguments.files(scenes), filter, !noFloor, given);
        if (sources.isEmpty()) {
            throw new WrongUsage("no scene " + where.map(text -> "matches " + text).orElse("is in " + String.join(", ", scenes)));
        }
        return sources;
    }

    private static boolean isMeantAsPicture(String word) {
        return ImageFormat.ofFile(word).isPresent() && (Foreign.kind(Words.path(word)).isPresent() || !Files.exists(Words.path(word)));
    }
}
