package cz.paprsek.cli.value;

import cz.paprsek.render.mode.RenderMode;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;

/** What pictures may show, by the names a user gives; lists them for the help and for shells that complete words. */
public final class Modes implements Iterable<String> {
    private static final List<String> NAMES = Arrays.stream(RenderMode.values()).map(RenderMode::toString).toList();

    public static RenderMode parse(String name) {
        return RenderMode.of(name).orElseThrow(() -> Words.unknown(name, NAMES));
    }

    @Override
    public Iterator<String> iterator() {
        return NAMES.iterator();
    }
}
