package cz.paprsek.cli;

import cz.paprsek.cli.manual.FishCompletion;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Terminal;
import java.util.concurrent.Callable;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Prints what a shell needs to complete commands and options. */
@Command(
        name = "generate-completion",
        description = "Prints a script with which a shell completes commands and options.",
        footer = {
            "",
            "Examples:",
            "  source <(paprsek generate-completion)",
            "  paprsek generate-completion --shell fish \\",
            "      > ~/.config/fish/completions/paprsek.fish"
        })
final class CompletionCommand implements Callable<Integer> {
    private final Terminal terminal;

    @Spec
    private CommandSpec spec;

    @Option(names = "--shell", paramLabel = "SHELL", defaultValue = "bash", description = "bash, zsh, fish. Default: bash.")
    private Shell shell;

    CompletionCommand(Terminal terminal) {
        this.terminal = terminal;
    }

    /** Zsh reads what is meant for bash. */
    enum Shell { bash, zsh, fish }

    @Override
    public Integer call() {
        CommandLine root = spec.root().commandLine();
        terminal.out().print(shell == Shell.fish ? FishCompletion.of(root) : AutoComplete.bash(root.getCommandName(), root));
        return ExitCode.DONE;
    }
}
