package cz.paprsek.render.mode;

import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/** What a picture shows: light, or something to learn from. */
public enum RenderMode {
    /** The light that reaches the eye. */
    SHADED("the light that reaches the eye"),
    /** Of what is seen, the normal towards the viewer: x as red, y as green, z as blue, −1 as 0 and 1 as 255. */
    NORMALS("the normal of what is seen: x, y, z as red, green, blue"),
    /** Of what is seen, the distance from the eye: light is near, dark is far, black is nothing. */
    DEPTH("the distance of what is seen: light is near, dark is far"),
    /** Of what is seen, the object: a colour for each, by its number in the scene. */
    OBJECTS("a colour for each object"),
    /** How many rays a pixel took, of all kinds, on a {@linkplain HeatScale#RAYS scale} of colours. */
    RAYS("how many rays a pixel took, on a scale of colours"),
    /** How many nodes of the hierarchy those rays visited, each from the root on, on a {@linkplain HeatScale#NODES scale} of colours. */
    NODES("how many nodes of the hierarchy a pixel's rays visited"),
    /**
     * The share of the lights that reaches what is seen, in their colours; black where all are blocked or behind, and on what shows no light
     * that falls on it, such as a perfect mirror.
     */
    SHADOWS("the share of the lights that reaches what is seen"),
    /**
     * How a picture lies on what is seen: ten by ten cells, each with the tenths of its u and v as two digits, redder to the right and
     * greener upwards.
     */
    UV("how a picture lies on what is seen: numbered cells, u and v in tenths"),
    /** How many rays from the eye a pixel took, on a {@linkplain HeatScale#SAMPLES scale} of colours. */
    SAMPLES("how many rays from the eye a pixel took");

    private final String meaning;

    RenderMode(String meaning) {
        this.meaning = meaning;
    }

    /** What is shown, in a few words. */
    public String meaning() {
        return meaning;
    }

    /** The scale of a heat map; empty if the picture is none. */
    public Optional<HeatScale> scale() {
        return switch (this) {
            case RAYS -> Optional.of(HeatScale.RAYS);
            case NODES -> Optional.of(HeatScale.NODES);
            case SAMPLES -> Optional.of(HeatScale.SAMPLES);
            default -> Optional.empty();
        };
    }

    /** Whether what is shown is a number, one for each pixel. */
    public boolean isNumber() {
        return this == DEPTH || scale().isPresent();
    }

    /** The name as people type it. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The mode of that name, in any case. */
    public static Optional<RenderMode> of(String name) {
        Objects.requireNonNull(name, "name");
        return Stream.of(values()).filter(mode -> mode.name().equalsIgnoreCase(name)).findFirst();
    }
}
