package cz.paprsek.cli;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.render.Renderer;
import java.util.Objects;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** The program called without a command: says what there is. */
@Command(
        name = "paprsek",
        versionProvider = RootCommand.Version.class,
        description = "Paprsek: renders scene files to pictures by ray tracing.",
        synopsisSubcommandLabel = "COMMAND",
        footer = {
            "",
            "Examples:",
            "  paprsek render scenes/showcase.xml -o showcase.png",
            "  paprsek render 'scenes/*.xml' -o pictures/ --size 640x360",
            "  paprsek validate my.xml",
            "",
            "'paprsek COMMAND --help' explains a command."
        })
final class RootCommand implements Runnable {
    @Spec
    private CommandSpec spec;

    @Override
    public void run() {
        throw new WrongUsage("say what to do: " + String.join(", ", spec.subcommands().keySet()));
    }

    /** The version the jar was built as. */
    static final class Version implements IVersionProvider {
        @Override
        public String[] getVersion() {
            String built = Objects.requireNonNullElse(Version.class.getPackage().getImplementationVersion(), "(development)");
            return new String[] {"Paprsek " + built, "Java " + Runtime.version() + ", " + Renderer.kernel()};
        }
    }
}
