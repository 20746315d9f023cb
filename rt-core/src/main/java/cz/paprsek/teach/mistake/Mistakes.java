package cz.paprsek.teach.mistake;

import java.util.Collection;
import java.util.Collections;
import java.util.EnumSet;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;

/** Some mistakes that are made together. Immutable. */
public final class Mistakes {
    /** All as it should be. */
    public static final Mistakes NONE = new Mistakes(EnumSet.noneOf(Mistake.class));

    private final Set<Mistake> made;

    private Mistakes(EnumSet<Mistake> made) {
        this.made = Collections.unmodifiableSet(made);
    }

    /** These, in any order. */
    public static Mistakes of(Collection<Mistake> made) {
        EnumSet<Mistake> copy = EnumSet.noneOf(Mistake.class);
        made.forEach(mistake -> copy.add(Objects.requireNonNull(mistake, "mistake")));
        return new Mistakes(copy);
    }

    /** This one. */
    public static Mistakes of(Mistake mistake) {
        return new Mistakes(EnumSet.of(mistake));
    }

    /** These, and one more. */
    public Mistakes and(Mistake mistake) {
        EnumSet<Mistake> more = EnumSet.of(mistake);
        more.addAll(made);
        return new Mistakes(more);
    }

    /** Those that are not of a part. */
    public Mistakes without(Mistake.Part part) {
        Objects.requireNonNull(part, "part");
        return of(made.stream().filter(mistake -> mistake.part() != part).toList());
    }

    public boolean has(Mistake mistake) {
        return made.contains(Objects.requireNonNull(mistake, "mistake"));
    }

    /** All of them, in the order of the table. */
    public Set<Mistake> all() {
        return made;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Mistakes mistakes && made.equals(mistakes.made);
    }

    @Override
    public int hashCode() {
        return made.hashCode();
    }

    /** Their names, with + between. */
    @Override
    public String toString() {
        return made.stream().map(Mistake::toString).collect(Collectors.joining(" + "));
    }
}
