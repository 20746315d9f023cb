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
     * @param results its standard output, in UTF-8
     * @param messages what it tells its user
     * @return its {@linkplain cz.paprsek.cli.process.ExitCode exit code}
     */
    public static int run(OutputStream results, PrintWriter messages, List<String> words) {
        return run(results, messages, Optional.empty(), words);
    }

    /**
     * Takes the order for a picture or film whose tiles are made one by one.
     *
     * @param results standard output, in UTF-8: what is asked for in place of a picture
     * @param messages what is wrong, if there is no order
     * @param words as for {@code render}, without that word, {@code --shard} and {@code -o}
     * @param piecework takes it
     * @return the exit code of {@code render}
     */
    public static int order(OutputStream results, PrintWriter messages, List<String> words, Piecework piecework) {
        List<String> all = new ArrayList<>(List.of("render"));
        all.addAll(words);
        all.addAll(List.of("--shard", piecework.shard().toString(), "-o", "parts", "--quiet"));
        return run(results, messages, Optional.of(piecework), all);
    }

    private static int run(OutputStream results, PrintWriter messages, Optional<Sharing> sharing, List<String> words) {
        Results bytes = new Results(results);
        Terminal terminal = new Terminal(new PrintWriter(bytes, false, StandardCharsets.UTF_8), messages, bytes, false);
        return new Cli(terminal, new Stop(), sharing).run(words.toArray(String[]::new));
    }
}
