package cz.paprsek.cli.process;

import java.util.List;

/** A file that a command cannot do without is missing or not valid. */
public final class BadScene extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient List<String> sentences;

    /** @param sentences what is wrong, a line each */
    public BadScene(List<String> sentences) {
        super(String.join("\n", sentences));
        this.sentences = List.copyOf(sentences);
    }

    public List<String> sentences() {
        return sentences;
    }
}
