package cz.paprsek.shape.font;

import java.io.IOException;
import java.io.InputStream;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/** The fonts that are shipped, by the names that scenes have for them: parts of DejaVu, whose licence lies beside them. */
public final class Fonts {
    /** Their names; that of a file has a dot. */
    public static final List<String> NAMES = List.of("sans", "sans-bold", "serif");

    private Fonts() {}

    /** One of a name; empty if none is shipped that is called so. */
    public static Optional<Font> shipped(String name) {
        return NAMES.contains(Objects.requireNonNull(name, "name")) ? Optional.of(Objects.requireNonNull(Shipped.ALL.get(name))) : Optional.empty();
    }

    /** The file of one that is shipped. */
    public static byte[] file(String name) {
        try (InputStream input = Objects.requireNonNull(Fonts.class.getResourceAsStream(Objects.requireNonNull(name, "name") + ".ttf"), name)) {
            return input.readAllBytes();
        } catch (IOException e) {
            throw new IllegalStateException("the font " + name + " is not where the program is", e);
        }
    }

    /** Read when the first text is made, all of them: that takes no time. */
    private static final class Shipped {
        static final Map<String, Font> ALL = read();

        private static Map<String, Font> read() {
            Map<String, Font> all = new LinkedHashMap<>();
            for (String name : NAMES) {
                all.put(name, new Font(file(name)));
            }
            return all;
        }
    }
}
