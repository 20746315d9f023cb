package cz.paprsek.lesson;

import cz.paprsek.xml.Problem;
import java.util.List;
import java.util.stream.Collectors;

/** A file is not a valid lesson. Its message has a line for every problem. */
public final class LessonException extends Exception {
    private static final long serialVersionUID = 1;

    private final transient List<Problem> problems;

    LessonException(List<Problem> problems) {
        super(problems.stream().map(Problem::toString).collect(Collectors.joining("\n")));
        this.problems = List.copyOf(problems);
    }

    /** The problems found; at least one, and only one of the lesson's own file. */
    public List<Problem> problems() {
        return problems;
    }
}
