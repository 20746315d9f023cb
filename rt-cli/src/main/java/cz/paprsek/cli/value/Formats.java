package cz.paprsek.cli.value;

import cz.paprsek.image.ImageFormat;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;

/** The picture formats by the names a user gives them; lists them for the help and for shells that complete words. */
public final class Formats implements Iterable<String> {
    private static final List<String> NAMES = Arrays.stream(ImageFormat.values()).map(ImageFormat::extension).toList();

    public static ImageFormat parse(String name) {
        return ImageFormat.of(name).orElseThrow(() -> Words.unknown(name, NAMES));
    }

    @Override
    public Iterator<String> iterator() {
        return NAMES.iterator();
    }
}
