package cz.paprsek.xml;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** The problems of one file as they are found. */
final class Problems {
    /** Nobody reads more; a file that is no scene at all could have millions. */
    private static final int MOST = 100;

    private final String file;
    private final List<Problem> found = new ArrayList<>();

    Problems(String file) {
        this.file = file;
    }

    int size() {
        return found.size();
    }

    boolean isFull() {
        return found.size() >= MOST;
    }

    void add(int line, int column, String message) {
        Problem problem = new Problem(file, line, column, message);
        if (!isFull() && !found.contains(problem)) {
            found.add(problem);
        }
    }

    void add(Located where, String message) {
        add(where.line, where.column, message);
    }

    /** Does what may be refused by a record; the refusal becomes a problem of the bean. */
    void attempt(Located where, Runnable work) {
        try {
            work.run();
        } catch (IllegalArgumentException refused) {
            add(where, String.valueOf(refused.getMessage()));
        }
    }

    void throwIfAny() throws SceneFileException {
        if (!found.isEmpty()) {
            found.sort(Comparator.comparingInt(Problem::line).thenComparingInt(Problem::column));
            throw new SceneFileException(found);
        }
    }
}
