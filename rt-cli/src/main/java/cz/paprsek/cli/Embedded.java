package cz.paprsek.cli;

import cz.paprsek.cli.process.Results;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.shard.Piecework;
import cz.paprsek.cli.shard.Sharing;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The command line within a process that goes on afterwards: that of an engine of many machines, say. */
public final class Embedded {
    private Embedded() {}

    /**
     * Runs a command.
     *
     * @param messages what it tells its user
     * @return its {@linkplain cz.paprsek.cli.process.ExitCode exit code}
     */
    public static int run(PrintWriter messages, List<String> words) {
        return run(messages, Optional.empty(), words);
    }

    /**
     * Takes the order for a picture or film whose tiles are made one by one.
     *
     * @param messages what is wrong, if there is no order
     * @param words as for {@code render}, without that word, {@code --shard} and {@code -o}
     * @param piecework takes it
     * @return the exit code of {@code render}
     */
    public static int order(PrintWriter messages, List<String> words, Piecework piecework) {
        List<String> all = new ArrayList<>(List.of("render"));
        all.addAll(words);
        all.addAll(List.of("--shard", piecework.shard().toString(), "-o", "parts", "--quiet"));
        return run(messages, Optional.of(piecework), all);
    }

    private static int run(PrintWriter messages, Optional<Sharing> sharing, List<String> words) {
        Results nowhere = new Results(OutputStream.nullOutputStream());
        Terminal terminal = new Terminal(new PrintWriter(nowhere, false, StandardCharsets.UTF_8), messages, nowhere, false);
        return new Cli(terminal, new Stop(), sharing).run(words.toArray(String[]::new));
    }
}
