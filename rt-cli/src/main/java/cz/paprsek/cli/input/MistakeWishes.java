package cz.paprsek.cli.input;

import cz.paprsek.cli.value.MistakeNames;
import cz.paprsek.teach.mistake.Mistake;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.List;
import picocli.CommandLine.Option;

/** What the user wants to be done wrong. */
public final class MistakeWishes {
    @Option(names = "--mistake", paramLabel = "MISTAKE", split = ",", completionCandidates = MistakeNames.class, description = {
        "What to do wrong, by a plain tracer that takes one ray a pixel or a grid of them, and knows fewer things than scenes may hold; one or several, with "
                + "commas between: ${COMPLETION-CANDIDATES}."})
    private List<Mistake> made = List.of();

    public Mistakes made() {
        return Mistakes.of(made);
    }
}
