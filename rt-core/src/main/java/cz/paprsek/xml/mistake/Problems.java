package cz.paprsek.xml.mistake;

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
public final class Problems {
    /** Nobody reads more; a file that is no scene at all could have millions. */
    public static final int MOST = 100;
    private static final int LONGEST_MESSAGE = 500;

    /** Where an element of the file starts; both from 1. */
    public interface Place {
        int line();

        int column();
    }

    /** Nothing more need be looked at: the file is hopeless, or there are problems enough. */
    public static final class Stop extends RuntimeException {
        private static final long serialVersionUID = 1;

        public Stop() {
            super("reading stops here", null, false, false);
        }
    }

    /** Something cannot be made because a part of it could not, which has been told already. */
    public static final class ToldAlready extends RuntimeException {
        private static final long serialVersionUID = 1;

        public ToldAlready() {
            super("a part is missing", null, false, false);
        }
    }

    private final List<Mistake> found = new ArrayList<>();
    private final Set<String> skipped = new TreeSet<>();
    /** By the record: the bean it was made from. */
    private final IdentityHashMap<Object, Place> origins = new IdentityHashMap<>();
    private boolean areMore;

    public int size() {
        return found.size();
    }

    /** @throws Stop if there are more than anybody reads */
    public void add(int line, int column, String message) {
        add(line, column, message, List.of());
    }

    /** As {@link #add(int, int, String)}, where an attribute of the element there is at fault. */
    public void add(int line, int column, String message, String attribute) {
        add(line, column, message, List.of(attribute));
    }

    private void add(int line, int column, String message, List<String> attributes) {
        Mistake problem = new Mistake(line, column, PlainText.of(message, LONGEST_MESSAGE), attributes);
        if (!found.contains(problem)) {
            if (found.size() == MOST) {
                areMore = true;
                throw new Stop();
            }
            found.add(problem);
        }
    }

    public void add(Place where, String message) {
        add(where.line(), where.column(), message);
    }

    /** As {@link #add(Place, String)}, where an attribute of the element there is at fault; none if its name is empty. */
    public void add(Place where, String message, String attribute) {
        add(where.line(), where.column(), message, attribute.isEmpty() ? List.of() : List.of(attribute));
    }

    /** Remembers that elements of a name are missing from the beans, since they are wrong. */
    public void skip(String element) {
        skipped.add(element);
    }

    /** The names of the elements that are missing from the beans. */
    public Set<String> skipped() {
        return skipped;
    }

    /** Makes a record of a bean, and remembers which; null if the record refuses, which becomes a problem of the bean. */
    public <T> @Nullable T make(Place bean, Supplier<T> maker) {
        try {
            T made = maker.get();
            origins.put(made, bean);
            return made;
        } catch (IllegalArgumentException refused) {
            String sentence = String.valueOf(refused.getMessage());
            add(bean.line(), bean.column(), sentence, namedIn(sentence));
        } catch (ToldAlready incomplete) {
            // Nothing to add.
        }
        return null;
    }

    /** Whatever may be the name of an attribute in what a record says of itself, in turn; not in what it advises to do. */
    private static List<String> namedIn(String sentence) {
        return List.of(sentence.replaceFirst(";.*", "").split("[^a-z-]+"));
    }

    /** The bean that a record was made from. */
    public Place origin(Object made, Place otherwise) {
        return origins.getOrDefault(made, otherwise);
    }

    /** All, in the order of the file. */
    public List<Mistake> inOrder() {
        found.sort(Comparator.comparingInt(Mistake::line).thenComparingInt(Mistake::column));
        if (areMore) {
            Mistake last = found.get(found.size() - 1);
            found.add(new Mistake(last.line(), last.column(), "there are more problems than these " + MOST + "; mend these first", List.of()));
        }
        return found;
    }
}
