package cz.paprsek.cli.value;

import cz.paprsek.render.film.Film.Layer;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;

/** The layers of a picture by the names a user gives; lists them for the help and for shells that complete words. */
public final class LayerNames implements Iterable<String> {
    private static final List<String> NAMES = Arrays.stream(Layer.values()).map(Layer::toString).toList();

    public static Layer parse(String name) {
        return Layer.of(name).orElseThrow(() -> Words.unknown(name, NAMES));
    }

    @Override
    public Iterator<String> iterator() {
        return NAMES.iterator();
    }
}
