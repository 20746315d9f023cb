package cz.paprsek.render.explain.text;

import cz.paprsek.render.explain.Pixel.PathPixel;
import cz.paprsek.render.explain.Pixel.PathPixel.Way;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.words.Words;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** What the ways of light are called, and how much they bring, in one language. */
public record PathWords(Words words) {
    private static final double STEPS = 255;

    /** A way by what it meets, such as {@code lamp > wall > eye}; of where light comes from only the name. */
    public String of(Way way) {
        return String.join(" > ", names(way));
    }

    /** Where light comes from, such as {@code lamp}. */
    public String source(Way way) {
        return switch (way.source()) {
            case LIGHT, SURFACE -> name(way.shines().orElseThrow());
            case SKY -> words.of("path.sky");
            case AMBIENT -> words.of("path.ambient");
        };
    }

    List<String> names(Way way) {
        List<String> names = new ArrayList<>();
        names.add(source(way));
        if (way.isShortened()) {
            names.add("…");
        }
        way.surfaces().forEach(surface -> names.add(name(surface)));
        names.add(words.of("path.eye"));
        return names;
    }

    String name(InScene<? extends ScenePath> place) {
        String name = place.part() instanceof ScenePath.LightAt light ? place.scene().lights().get(light.index()).name()
                : ((ScenePath.BodyAt) place.part()).in(place.scene()).name();
        return name.isEmpty() ? words.surface(place) : name;
    }

    /** How much a way brings, in columns: its share in the pixel, its light with what that may be off, and by how many paths. */
    public String amount(PathPixel pixel, Way way) {
        String off = way.halfWidth().map(half -> " ± " + Figures.of(half)).orElse("");
        return words.figures(String.format(Locale.ROOT, "%6.2f %%", 100 * pixel.share(way.light())) + "  " + Figures.of(way.light()) + off) + "  " + words.of("path.paths", way.paths());
    }

    /** What the pixel's light is and how well that is known, in one line. */
    public String sum(PathPixel pixel) {
        return words.of("path.average", pixel.samples().size()) + " = " + words.figures(Figures.of(pixel.light()) + Figures.shown(pixel.developed(), pixel.exposure(), pixel.tone(), words))
                + (pixel.samples().size() < 64 ? "" : pixel.interval() < 0 ? words.of("path.untrusted") : words.of("path.interval", words.figures(Figures.of(STEPS * pixel.interval()))));
    }
}
