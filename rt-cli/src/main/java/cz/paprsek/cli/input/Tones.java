package cz.paprsek.cli.input;

import cz.paprsek.image.ImageOptions.Tone;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;

/** How light is fitted to a screen, by the names a user gives; lists them for the help and for shells that complete words. */
public final class Tones implements Iterable<String> {
    private static final List<String> NAMES = Arrays.stream(Tone.values()).map(tone -> tone.name().toLowerCase(Locale.ROOT)).toList();

    public static Tone parse(String name) {
        return Arrays.stream(Tone.values()).filter(tone -> tone.name().equalsIgnoreCase(name)).findFirst().orElseThrow(() -> Words.unknown(name, NAMES));
    }

    @Override
    public Iterator<String> iterator() {
        return NAMES.iterator();
    }
}
