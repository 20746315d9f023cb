package cz.paprsek.cli;

import cz.paprsek.cli.bench.BenchCommand;
import cz.paprsek.cli.bench.CompareCommand;
import cz.paprsek.cli.bench.CrossCheckCommand;
import cz.paprsek.cli.db.DbCommand;
import cz.paprsek.cli.input.Formats;
import cz.paprsek.cli.input.Modes;
import cz.paprsek.cli.input.PixelPlace;
import cz.paprsek.cli.input.Region;
import cz.paprsek.cli.input.Share;
import cz.paprsek.cli.input.Size;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.render.RenderMode;
import cz.paprsek.render.Tile;
import cz.paprsek.scene.Similar;
import java.util.ArrayList;
import java.util.List;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** The commands put together: what there is, and how a mistake is answered. */
final class Cli {
    /** Of all commands, in the order of the help. */
    private static final List<String> NAMES = List.of(
            "render", "validate", "info", "explain", "convert", "bench", "compare", "crosscheck", "db", "schema", "generate-completion", "help");

    private static final List<String> NEEDING_ALL = List.of("generate-completion", "help");

    private final Terminal terminal;
    private final Stop stop;

    Cli(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    /** Runs the command that the arguments say; returns its {@linkplain ExitCode exit code}. */
    int run(String... args) {
        boolean isOneEnough = args.length > 0 && NAMES.contains(args[0]) && !NEEDING_ALL.contains(args[0]);
        int code = commandLine(isOneEnough ? List.of(args[0]) : NAMES).execute(args);
        terminal.out().flush();
        terminal.err().flush();
        return code;
    }

    /** With the commands of these names: picocli takes longer to look at all of them than a small picture takes to render. */
    private CommandLine commandLine(List<String> names) {
        CommandLine root = new CommandLine(new RootCommand());
        names.forEach(name -> root.addSubcommand(name, command(name)));
        root.registerConverter(Size.class, Size::parse);
        root.registerConverter(RenderMode.class, Modes::parse);
        root.registerConverter(PixelPlace.class, PixelPlace::parse);
        root.registerConverter(Tile.class, Region::parse);
        root.registerConverter(ImageFormat.class, Formats::parse);
        root.registerConverter(Share.class, Share::parse);
        root.setOut(terminal.out());
        root.setErr(terminal.err());
        root.setUsageHelpWidth(100);
        root.setParameterExceptionHandler((mistake, given) -> wrongUsage(mistake.getCommandLine(), sentence(mistake)));
        root.setExecutionExceptionHandler(this::failed);
        root.getCommandSpec().addOption(
                OptionSpec.builder("-V", "--version").versionHelp(true).description("Prints the version and exits.").build());
        describe(root);
        return root;
    }

    private Object command(String name) {
        return switch (name) {
            case "render" -> new RenderCommand(terminal, stop);
            case "validate" -> new ValidateCommand(terminal, stop);
            case "info" -> new InfoCommand(terminal, stop);
            case "explain" -> new ExplainCommand(terminal, stop);
            case "convert" -> new ConvertCommand(terminal, stop);
            case "bench" -> new BenchCommand(terminal, stop);
            case "compare" -> new CompareCommand(terminal, stop);
            case "crosscheck" -> new CrossCheckCommand(terminal, stop);
            case "db" -> DbCommand.of(terminal, stop);
            case "schema" -> new SchemaCommand(terminal, stop);
            case "generate-completion" -> new AutoComplete.GenerateCompletion();
            case "help" -> new CommandLine.HelpCommand();
            default -> throw new IllegalArgumentException(name);
        };
    }

    private static void describe(CommandLine command) {
        CommandSpec spec = command.getCommandSpec();
        if (spec.findOption("--help") == null) {
            spec.addOption(OptionSpec.builder("-h", "--help").usageHelp(true).description("Prints this help and exits.").build());
        }
        spec.usageMessage().exitCodeListHeading("%nExit codes:%n").exitCodeList(ExitCode.explained())
                .commandListHeading("%nCommands:%n").abbreviateSynopsis(true).sortOptions(false);
        command.getSubcommands().values().forEach(Cli::describe);
    }

    private int failed(Exception failure, CommandLine command, CommandLine.ParseResult parsed) {
        if (failure instanceof WrongUsage) {
            return wrongUsage(command, String.valueOf(failure.getMessage()));
        }
        terminal.message("rt-cli: this is a fault of the program, please report it:");
        failure.printStackTrace(terminal.err());
        return ExitCode.FAILED;
    }

    private int wrongUsage(CommandLine command, String sentence) {
        terminal.message("rt-cli: " + sentence);
        terminal.message("Try '" + command.getCommandSpec().qualifiedName() + " --help'.");
        return ExitCode.WRONG_USAGE;
    }

    private static String sentence(ParameterException mistake) {
        if (mistake instanceof UnmatchedArgumentException unmatched && !unmatched.getUnmatched().isEmpty()) {
            CommandSpec spec = mistake.getCommandLine().getCommandSpec();
            String word = unmatched.getUnmatched().get(0);
            List<String> known = new ArrayList<>(spec.subcommands().keySet());
            boolean isOption = word.startsWith("-");
            if (isOption) {
                known = new ArrayList<>(spec.optionsMap().keySet());
                word = word.split("=", 2)[0];
            }
            return (isOption ? "unknown option \"" : known.isEmpty() ? "unexpected \"" : "there is no command \"") + word + "\""
                    + Similar.suggestion(word, known);
        }
        return String.valueOf(mistake.getMessage()).replace("\n", " ");
    }
}
