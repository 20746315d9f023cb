package cz.paprsek.xml.bind;

import cz.paprsek.io.PlainText;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** The problems of one file as they are found, and what is needed to tell their places. */
final class Problems {
    /** Nobody reads more; a file that is no scene at all could have millions. */
    static final int MOST = 100;
    private static final int LONGEST_MESSAGE = 500;

    /** Nothing more need be looked at: the file is hopeless, or there are problems enough. */
    static final class Stop extends RuntimeException {
        private static final long serialVersionUID = 1;

        Stop() {
            super("reading stops here", null, false, false);
        }
    }

    /** Something cannot be made because a part of it could not, which has been told already. */
    static final class ToldAlready extends RuntimeException {
        private static final long serialVersionUID = 1;

        ToldAlready() {
            super("a part is missing", null, false, false);
        }
    }

    private final List<Mistake> found = new ArrayList<>();
    private final Set<String> skipped = new TreeSet<>();
    /** By the record: the bean it was made from. */
    private final IdentityHashMap<Object, Located> origins = new IdentityHashMap<>();
    private boolean areMore;

    int size() {
        return found.size();
    }

    /** @throws Stop if there are more than anybody reads */
    void add(int line, int column, String message) {
        Mistake problem = new Mistake(line, column, PlainText.of(message, LONGEST_MESSAGE));
        if (!found.contains(problem)) {
            if (found.size() == MOST) {
                areMore = true;
                throw new Stop();
            }
            found.add(problem);
        }
    }

    void add(Located where, String message) {
        add(where.line, where.column, message);
    }

    /** Remembers that elements of a name are missing from the beans, since they are wrong. */
    void skip(String element) {
        skipped.add(element);
    }

    /** The names of the elements that are missing from the beans. */
    Set<String> skipped() {
        return skipped;
    }

    /** Makes a record of a bean, and remembers which; null if the record refuses, which becomes a problem of the bean. */
    <T> @Nullable T make(Located bean, Supplier<T> maker) {
        try {
            T made = maker.get();
            origins.put(made, bean);
            return made;
        } catch (IllegalArgumentException refused) {
            add(bean, String.valueOf(refused.getMessage()));
        } catch (ToldAlready incomplete) {
            // Nothing to add.
        }
        return null;
    }

    /** The bean that a record was made from. */
    Located origin(Object made, Located otherwise) {
        return origins.getOrDefault(made, otherwise);
    }

    /** All, in the order of the file. */
    List<Mistake> inOrder() {
        found.sort(Comparator.comparingInt(Mistake::line).thenComparingInt(Mistake::column));
        if (areMore) {
            Mistake last = found.get(found.size() - 1);
            found.add(new Mistake(last.line(), last.column(), "there are more problems than these " + MOST + "; mend these first"));
        }
        return found;
    }
}
