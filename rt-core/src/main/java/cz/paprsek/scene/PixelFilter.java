package cz.paprsek.scene;

import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/** From where around its centre a pixel gathers light, and with what weight: what its rays are strewn by. */
public enum PixelFilter {
    /** The pixel's own square, evenly. */
    BOX("evenly within the pixel"),
    /** A pixel to each side, falling to nothing in straight lines. */
    TENT("falling to nothing a pixel away"),
    /** A bell curve with a standard deviation of half a pixel, cut off two pixels away. */
    GAUSS("a bell curve"),
    /**
     * Two pixels to each side, below nothing in the outer one, which makes edges sharper.
     *
     * @source Mitchell and Netravali, Reconstruction Filters in Computer Graphics, SIGGRAPH 1988, with B = C = ⅓
     */
    MITCHELL("sharpening: below nothing in its outer parts");

    private final String meaning;

    PixelFilter(String meaning) {
        this.meaning = meaning;
    }

    /** How it weighs light, in a few words. */
    public String meaning() {
        return meaning;
    }

    /** The name as people type it. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The filter of that name, in any case. */
    public static Optional<PixelFilter> of(String name) {
        Objects.requireNonNull(name, "name");
        return Stream.of(values()).filter(filter -> filter.name().equalsIgnoreCase(name)).findFirst();
    }
}
