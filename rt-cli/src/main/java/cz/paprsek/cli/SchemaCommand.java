package cz.paprsek.cli;

import cz.paprsek.io.AtomicFile;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code rt-cli schema}. */
@Command(
        name = "schema",
        mixinStandardHelpOptions = true,
        description = "Prints the schema of scene files, for editors that complete and check XML.")
final class SchemaCommand implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Option(names = {"-o", "--output"}, paramLabel = "FILE", description = "Write it to this file instead.")
    private @Nullable Path output;

    @Override
    public Integer call() throws IOException {
        if (output == null) {
            spec.commandLine().getOut().print(SceneFiles.schema());
            spec.commandLine().getOut().flush();
        } else {
            AtomicFile.write(output, out -> out.write(SceneFiles.schema().getBytes(StandardCharsets.UTF_8)));
        }
        return ExitCode.DONE;
    }
}
