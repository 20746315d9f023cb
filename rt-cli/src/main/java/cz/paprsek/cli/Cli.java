package cz.paprsek.cli;

import cz.paprsek.io.PlainText;
import java.io.PrintWriter;
import java.util.List;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** All commands, with their streams: what {@link Main} runs, and tests too. */
@Command(
        name = "rt-cli",
        description = "Renders scenes of spheres, blocks, CSG and glass, and tells what is in them.",
        synopsisSubcommandLabel = "COMMAND",
        mixinStandardHelpOptions = true,
        versionProvider = Cli.Version.class,
        footerHeading = "%nExamples:%n",
        footer = {
            "  rt-cli render scenes/showcase.xml -o showcase.png",
            "  rt-cli render 'scenes/*.xml' -o pictures/ --size 1920x1080",
            "  rt-cli validate scenes/*.xml",
            "",
            "Exit codes: 0 done, 1 rendering failed, 2 wrong usage, 3 bad scene file, 130 interrupted."},
        subcommands = {RenderCommand.class, ValidateCommand.class, InfoCommand.class, SchemaCommand.class,
            AutoComplete.GenerateCompletion.class, CommandLine.HelpCommand.class})
final class Cli implements Runnable {
    private final PrintWriter out;
    private final PrintWriter err;
    private final Interruption interruption;
    @Spec private CommandSpec spec;

    Cli(PrintWriter out, PrintWriter err, Interruption interruption) {
        this.out = out;
        this.err = err;
        this.interruption = interruption;
    }

    /** Runs one command line and returns its exit code. */
    int run(String... args) {
        return new CommandLine(this)
                .setOut(out)
                .setErr(err)
                .setUsageHelpAutoWidth(true)
                .setCaseInsensitiveEnumValuesAllowed(true)
                .setExecutionExceptionHandler((e, command, parsed) -> {
                    err.println(PlainText.of(String.valueOf(e.getMessage() == null ? e.toString() : e.getMessage()), 500));
                    return ExitCode.FAILED;
                })
                .setParameterExceptionHandler(Cli::wrongUsage)
                .execute(args);
    }

    Interruption interruption() {
        return interruption;
    }

    @Override
    public void run() {
        throw new ParameterException(spec.commandLine(), "A command is missing: render, validate, info or schema.");
    }

    private static int wrongUsage(ParameterException e, String[] args) {
        CommandLine command = e.getCommandLine();
        PrintWriter err = command.getErr();
        err.println(PlainText.of(String.valueOf(e.getMessage()), 500));
        CommandLine.UnmatchedArgumentException.printSuggestions(e, err);
        err.println("Try '" + command.getCommandSpec().qualifiedName() + " --help'.");
        return ExitCode.USAGE;
    }

    /** The version that the jar carries. */
    static final class Version implements CommandLine.IVersionProvider {
        @Override
        public String[] getVersion() {
            String version = Cli.class.getPackage().getImplementationVersion();
            return List.of("rt-cli " + (version == null ? "(not packaged)" : version)).toArray(String[]::new);
        }
    }
}
