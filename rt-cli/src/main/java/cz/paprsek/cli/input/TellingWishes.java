package cz.paprsek.cli.input;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.WrongUsage;
import java.util.Optional;
import picocli.CommandLine.Option;

/** How much the user wants to be told of pictures that are written, and in which form. */
public final class TellingWishes {
    @Option(names = "--json", description = "Prints a JSON object for every picture, one a line, instead of plain text.")
    private boolean json;

    @Option(names = {"-q", "--quiet"}, description = "Prints errors only, and what --json asks for.")
    private boolean quiet;

    /** As picocli makes them. */
    public TellingWishes() {
        this(false);
    }

    /** In no special form. */
    public TellingWishes(boolean quiet) {
        this.quiet = quiet;
    }

    public boolean isJson() {
        return json;
    }

    public boolean isQuiet() {
        return quiet;
    }

    /**
     * Promises to whoever reads JSON that the end is told.
     *
     * @throws WrongUsage if the picture goes where that should
     */
    public void prepare(Optional<String> output, Stop stop) {
        if (json && output.equals(Optional.of("-"))) {
            throw new WrongUsage("--json and the picture cannot both go to standard output");
        }
        if (json) {
            stop.oweLastWords();
        }
    }
}
