package cz.paprsek.xml;

import java.util.List;
import java.util.stream.Collectors;

/** A file is not a valid scene. Its message has a line for every problem. */
public final class SceneFileException extends Exception {
    private static final long serialVersionUID = 1;

    private final transient List<Problem> problems;

    SceneFileException(List<Problem> problems) {
        super(problems.stream().map(Problem::toString).collect(Collectors.joining("\n")));
        this.problems = List.copyOf(problems);
    }

    /** All problems found, in the order of the file; at least one. */
    public List<Problem> problems() {
        return problems;
    }
}
