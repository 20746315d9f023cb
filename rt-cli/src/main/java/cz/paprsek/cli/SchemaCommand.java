package cz.paprsek.cli;

import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Failures;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Prints the schema of scene files. */
@Command(
        name = "schema",
        description = "Prints the XML schema (XSD) of scene files, for editors that complete and check XML.",
        footer = {"", "Example:", "  paprsek schema -o scene.xsd"})
final class SchemaCommand implements Callable<Integer> {
    private final Terminal terminal;
    private final Stop stop;

    @Option(names = {"-o", "--output"}, paramLabel = "FILE", description = "Writes to this file instead of standard output.")
    private Optional<Path> output;

    SchemaCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() {
        byte[] text = SceneFiles.schema().getBytes(StandardCharsets.UTF_8);
        try {
            if (output.isPresent()) {
                stop.write(output.get(), () -> AtomicFile.write(output.get(), out -> out.write(text)));
            } else {
                terminal.bytes().write(text);
            }
            return ExitCode.DONE;
        } catch (IOException e) {
            terminal.message(Failures.sentence(output.map(Path::toString).orElse("standard output"), e));
            return ExitCode.FAILED;
        }
    }
}
