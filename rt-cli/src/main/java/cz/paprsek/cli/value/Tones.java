package cz.paprsek.cli.value;

import cz.paprsek.material.Rgb.Tone;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;

/** How light is fitted to a screen, by the names a user gives; lists them for the help and for shells that complete words. */
public final class Tones implements Iterable<String> {
    private static final List<String> NAMES = Arrays.stream(Tone.values()).map(Tone::toString).toList();

    public static Tone parse(String name) {
        return Tone.of(name).orElseThrow(() -> Words.unknown(name, NAMES));
    }

    @Override
    public Iterator<String> iterator() {
        return NAMES.iterator();
    }
}
