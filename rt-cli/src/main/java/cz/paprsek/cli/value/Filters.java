package cz.paprsek.cli.value;

import cz.paprsek.scene.RenderSettings.PixelFilter;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;

/** How a pixel's rays may be strewn, by the names a user gives; lists them for the help and for shells that complete words. */
public final class Filters implements Iterable<String> {
    private static final List<String> NAMES = Arrays.stream(PixelFilter.values()).map(PixelFilter::toString).toList();

    public static PixelFilter parse(String name) {
        return PixelFilter.of(name).orElseThrow(() -> Words.unknown(name, NAMES));
    }

    @Override
    public Iterator<String> iterator() {
        return NAMES.iterator();
    }
}
