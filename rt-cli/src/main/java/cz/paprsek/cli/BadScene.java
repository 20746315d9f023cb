package cz.paprsek.cli;

import java.util.List;

/** A file that a command cannot do without is missing or not valid. */
final class BadScene extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final transient List<String> sentences;

    /** @param sentences what is wrong, a line each */
    BadScene(List<String> sentences) {
        super(String.join("\n", sentences));
        this.sentences = List.copyOf(sentences);
    }

    List<String> sentences() {
        return sentences;
    }
}
