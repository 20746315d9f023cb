package cz.paprsek.cli;

import cz.paprsek.cli.manual.ManPage;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Failures;
import cz.paprsek.io.Folders;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Writes the pages of the manual. */
@Command(
        name = "generate-man",
        description = "Writes pages for man: one for the program and one for each command.",
        footer = {"", "Examples:", "  paprsek generate-man -o ~/.local/share/man/man1", "  man paprsek-render"})
final class ManCommand implements Callable<Integer> {
    private final Terminal terminal;
    private final Stop stop;

    @Spec
    private CommandSpec spec;

    @Option(names = {"-o", "--output"}, paramLabel = "DIR", required = true, description = "The directory to write them to; it is made if it is not there.")
    private Path output;

    ManCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() {
        try {
            Folders.make(output);
            write(spec.root().commandLine(), spec.root().version()[0]);
            return ExitCode.DONE;
        } catch (IOException e) {
            terminal.message(Failures.sentence(output.toString(), e));
            return ExitCode.FAILED;
        }
    }

    private void write(CommandLine command, String version) throws IOException {
        byte[] page = ManPage.of(command, version).getBytes(StandardCharsets.UTF_8);
        stop.guard(() -> AtomicFile.write(output.resolve(ManPage.fileName(command)), out -> out.write(page)));
        for (CommandLine below : command.getSubcommands().values()) {
            write(below, version);
        }
    }
}
