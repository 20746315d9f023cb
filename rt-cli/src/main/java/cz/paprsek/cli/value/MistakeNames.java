package cz.paprsek.cli.value;

import cz.paprsek.teach.mistake.Mistake;
import java.util.Iterator;

/** What can be done wrong, by the names a user gives; lists them for the help and for shells that complete words. */
public final class MistakeNames implements Iterable<String> {
    public static Mistake parse(String name) {
        return Mistake.of(name).orElseThrow(() -> Words.unknown(name, Mistake.NAMES));
    }

    @Override
    public Iterator<String> iterator() {
        return Mistake.NAMES.iterator();
    }
}
