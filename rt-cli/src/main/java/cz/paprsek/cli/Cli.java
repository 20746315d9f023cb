package cz.paprsek.cli;

import cz.paprsek.cli.bench.BenchCommand;
import cz.paprsek.cli.bench.CompareCommand;
import cz.paprsek.cli.bench.CrossCheckCommand;
import cz.paprsek.cli.db.DbCommand;
import cz.paprsek.cli.input.RayWishes;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Memory;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.shard.Sharing;
import cz.paprsek.cli.value.Filters;
import cz.paprsek.cli.value.Formats;
import cz.paprsek.cli.value.FrameRange;
import cz.paprsek.cli.value.Integrators;
import cz.paprsek.cli.value.LayerNames;
import cz.paprsek.cli.value.MistakeNames;
import cz.paprsek.cli.value.Modes;
import cz.paprsek.cli.value.OutputFormat;
import cz.paprsek.cli.value.Part;
import cz.paprsek.cli.value.PixelPlace;
import cz.paprsek.cli.value.Region;
import cz.paprsek.cli.value.Samples;
import cz.paprsek.cli.value.Shard;
import cz.paprsek.cli.value.Share;
import cz.paprsek.cli.value.Size;
import cz.paprsek.cli.value.Tones;
import cz.paprsek.cli.value.Words;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.io.Failures;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.render.Tile;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.teach.mistake.Mistake;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;

/** The commands put together: what there is, and how a mistake is answered. */
final class Cli {
    /** Of all commands, in the order of the help. */
    private static final List<String> NAMES = List.of(
            "render", "merge", "plan", "validate", "info", "explain", "convert", "bench", "compare", "grade", "worksheet", "lesson", "crosscheck", "db", "schema", "generate-completion", "generate-man", "help");

    /** As wide as every terminal is. */
    private static final int WIDTH = 80;

    private static final List<String> NEEDING_ALL = List.of("plan", "generate-completion", "generate-man", "help");

    private final Terminal terminal;
    private final Stop stop;
    private final Optional<Sharing> sharing;

    Cli(Terminal terminal, Stop stop) {
        this(terminal, stop, Optional.empty());
    }

    /** @param sharing as {@link RenderCommand} has it */
    Cli(Terminal terminal, Stop stop, Optional<Sharing> sharing) {
        this.terminal = terminal;
        this.stop = stop;
        this.sharing = sharing;
    }

    /** Runs the command that the arguments say; returns its {@linkplain ExitCode exit code}. */
    int run(String... args) {
        Optional<PlainRender> plain = sharing.isEmpty() ? PlainRender.of(args) : Optional.empty();
        boolean isOneEnough = args.length > 0 && NAMES.contains(args[0]) && !NEEDING_ALL.contains(args[0]);
        int code = plain.isPresent() ? run(plain.get()) : run(commandLine(isOneEnough ? List.of(args[0]) : NAMES), args);
        terminal.out().flush();
        // A command that has failed to write bytes has told why; lines are lost without its knowledge, also those that tell of a difference.
        Optional<IOException> lost = terminal.bytes().lost().filter(failure -> code != ExitCode.FAILED || terminal.bytes().areLinesLost());
        lost.ifPresent(failure -> terminal.message(Failures.sentence("standard output", failure) + "; results are lost"));
        terminal.err().flush();
        return lost.isPresent() && code == ExitCode.DONE ? ExitCode.FAILED : code;
    }

    private int run(CommandLine commands, String... args) {
        try {
            return commands.execute(args);
        } catch (OutOfMemoryError e) {
            return outOfMemory();
        }
    }

    private int run(PlainRender words) {
        try {
            return new RenderCommand(terminal, stop, words).call();
        } catch (OutOfMemoryError e) {
            return outOfMemory();
        } catch (RuntimeException failure) {
            return failed(failure, Objects.requireNonNull(commandLine(List.of("render")).getSubcommands().get("render")));
        }
    }

    private int outOfMemory() {
        terminal.message("paprsek: " + Memory.sentence("", 0));
        return ExitCode.FAILED;
    }

    /** With the commands of these names: picocli takes longer to look at all of them than a small picture takes to render. */
    CommandLine commandLine(List<String> names) {
        CommandLine root = new CommandLine(new RootCommand());
        names.forEach(name -> root.addSubcommand(name, command(name)));
        register(root, Size.class, Size::parse);
        register(root, RenderMode.class, Modes::parse);
        register(root, PixelPlace.class, PixelPlace::parse);
        register(root, Tile.class, Region::parse);
        register(root, ImageFormat.class, Formats::parse);
        register(root, OutputFormat.class, OutputFormat::parse);
        register(root, FrameRange.class, FrameRange::parse);
        register(root, Layer.class, LayerNames::parse);
        register(root, Tone.class, Tones::parse);
        register(root, Share.class, Share::parse);
        register(root, Shard.class, Shard::parse);
        register(root, Samples.class, Samples::parse);
        register(root, Mistake.class, MistakeNames::parse);
        register(root, Part.class, Part::parse);
        register(root, PixelFilter.class, Filters::parse);
        register(root, Integrator.class, Integrators::parse);
        register(root, RayWishes.Sampler.class, word -> Words.constant(RayWishes.Sampler.class, word));
        register(root, ExplainCommand.When.class, word -> Words.constant(ExplainCommand.When.class, word));
        register(root, CompletionCommand.Shell.class, word -> Words.constant(CompletionCommand.Shell.class, word));
        register(root, WorksheetCommand.Language.class, word -> Words.constant(WorksheetCommand.Language.class, word));
        register(root, BenchCommand.Opponent.class, word -> Words.constant(BenchCommand.Opponent.class, word));
        register(root, Path.class, Words::file);
        register(root, Integer.class, Words::wholeNumber);
        register(root, int.class, Words::wholeNumber);
        register(root, Double.class, Words::number);
        register(root, double.class, Words::number);
        root.setOut(terminal.out());
        root.setErr(terminal.err());
        root.setUsageHelpWidth(WIDTH);
        Answers answers = new Answers();
        root.setParameterExceptionHandler(answers);
        root.setExecutionExceptionHandler(answers);
        root.getCommandSpec().addOption(
                OptionSpec.builder("-V", "--version").versionHelp(true).description("Prints the version and exits.").build());
        describe(root);
        return root;
    }

    private static <T> void register(CommandLine root, Class<T> type, Function<String, T> parse) {
        root.registerConverter(type, new Meaning<>(parse));
    }

    /** No lambda, like {@link Answers}: of those that implement an interface as old as picocli's, Java 17 cannot archive the classes, and dies of it. */
    private record Meaning<T>(Function<String, T> parse) implements ITypeConverter<T> {
        @Override
        public T convert(String word) {
            return parse.apply(word);
        }
    }

    private final class Answers implements IParameterExceptionHandler, IExecutionExceptionHandler {
        @Override
        public int handleParseException(ParameterException mistake, String[] given) {
            return wrongUsage(mistake.getCommandLine(), Mistakes.sentence(mistake));
        }

        @Override
        public int handleExecutionException(Exception failure, CommandLine command, CommandLine.ParseResult parsed) {
            return failed(failure, command);
        }
    }

    private Object command(String name) {
        return switch (name) {
            case "render" -> new RenderCommand(terminal, stop, sharing);
            case "merge" -> new MergeCommand(terminal, stop);
            case "plan" -> new PlanCommand(terminal, stop);
            case "validate" -> new ValidateCommand(terminal, stop);
            case "info" -> new InfoCommand(terminal, stop);
            case "explain" -> new ExplainCommand(terminal, stop);
            case "convert" -> new ConvertCommand(terminal, stop);
            case "bench" -> new BenchCommand(terminal, stop);
            case "compare" -> new CompareCommand(terminal, stop);
            case "grade" -> new GradeCommand(terminal, stop);
            case "worksheet" -> new WorksheetCommand(terminal, stop);
            case "lesson" -> new LessonCommand(terminal, stop);
            case "crosscheck" -> new CrossCheckCommand(terminal, stop);
            case "db" -> DbCommand.of(terminal, stop);
            case "schema" -> new SchemaCommand(terminal, stop);
            case "generate-completion" -> new CompletionCommand(terminal);
            case "generate-man" -> new ManCommand(terminal, stop);
            case "help" -> new CommandLine.HelpCommand();
            default -> throw new IllegalArgumentException(name);
        };
    }

    private static void describe(CommandLine command) {
        CommandSpec spec = command.getCommandSpec();
        if (spec.userObject() instanceof CommandLine.HelpCommand) {
            spec.usageMessage().header("Explains a command, as --help after its name does; without a name, the program.").description();
        }
        if (spec.findOption("--help") == null) {
            spec.addOption(OptionSpec.builder("-h", "--help").usageHelp(true).description("Prints this help and exits.").build());
        }
        spec.usageMessage().exitCodeListHeading("%nExit codes:%n").exitCodeList(ExitCode.explained())
                .commandListHeading("%nCommands:%n").abbreviateSynopsis(true).sortOptions(false);
        command.getSubcommands().values().forEach(Cli::describe);
    }

    private int failed(Exception failure, CommandLine command) {
        if (failure instanceof WrongUsage) {
            return wrongUsage(command, String.valueOf(failure.getMessage()));
        }
        terminal.message("paprsek: this is a fault of the program, please report it:");
        failure.printStackTrace(terminal.err());
        return ExitCode.FAILED;
    }

    private int wrongUsage(CommandLine command, String sentence) {
        terminal.message("paprsek: " + sentence);
        terminal.message("Try '" + command.getCommandSpec().qualifiedName() + " --help'.");
        return ExitCode.WRONG_USAGE;
    }
}
