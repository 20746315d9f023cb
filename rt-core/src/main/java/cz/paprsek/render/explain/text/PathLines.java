package cz.paprsek.render.explain.text;

import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.Pixel.PathPixel;
import cz.paprsek.render.explain.Pixel.PathPixel.Example;
import cz.paprsek.render.explain.Pixel.PathPixel.Way;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.words.Words;
import java.util.ArrayList;
import java.util.List;

/** A pixel of paths as lines of text: by which ways its light came, from what, and a few paths point by point. */
public final class PathLines {
    /** Of the paths that are typical, so many are told unless all is. */
    private static final int MOST_EXAMPLES = 4;

    private final PathPixel pixel;
    private final Words words;
    private final PathWords names;
    private final Decoration decoration;
    private final List<String> lines = new ArrayList<>();

    private PathLines(PathPixel pixel, Decoration decoration, Words words) {
        this.pixel = pixel;
        this.words = words;
        this.names = new PathWords(words);
        this.decoration = decoration;
    }

    /**
     * The lines, without their ends.
     *
     * @param smallestShare ways that bring a smaller share of the pixel's light are only counted; 0 for all
     */
    public static List<String> lines(PathPixel pixel, double smallestShare, Decoration decoration, Words words) {
        PathLines text = new PathLines(pixel, decoration, words);
        text.table(words.of("path.ways"), pixel.ways(), smallestShare, true);
        text.table(words.of("path.sources"), pixel.sources(), smallestShare, false);
        pixel.examples().stream().limit(smallestShare == 0 ? Long.MAX_VALUE : MOST_EXAMPLES).forEach(text::example);
        String patch = decoration.patch(pixel.developed());
        text.lines.add(words.of("pixel", pixel.column(), pixel.row()) + ": " + text.names.sum(pixel) + (patch.isEmpty() ? "" : "  " + patch));
        return text.lines;
    }

    private void table(String title, List<Way> ways, double smallestShare, boolean isWhole) {
        List<Way> told = ways.stream().filter(way -> pixel.share(way.light()) >= smallestShare).toList();
        int width = told.stream().mapToInt(way -> names.amount(pixel, way).length()).max().orElse(0);
        lines.add(title);
        for (Way way : told) {
            String amount = names.amount(pixel, way);
            String patch = decoration.patch(way.light());
            lines.add("  " + amount + " ".repeat(width - amount.length()) + "  " + (isWhole ? names.of(way) : names.source(way)) + (patch.isEmpty() ? "" : "  " + patch));
        }
        if (told.size() < ways.size()) {
            double rest = ways.stream().filter(way -> !told.contains(way)).mapToDouble(way -> pixel.share(way.light())).sum();
            lines.add("  " + words.of("path.rest", ways.size() - told.size(), words.figures(Figures.of(100 * rest))));
        }
        lines.add("");
    }

    private void example(Example example) {
        lines.add(words.of("path.example", example.sample() + 1, pixel.samples().size(), names.of(pixel.ways().get(example.way())), words.figures(Figures.of(example.brought()))));
        TracedRay ray = example.ray();
        lines.add("  " + words.of("path.eye") + " " + words.figures(Figures.of(ray.origin())));
        point(ray, LinearRgb.WHITE);
        lines.add("");
    }

    /**
     * What a ray of a path meets, and what comes straight from the lights there; then the ray that goes on from there.
     *
     * @param before how much of the light of the ray before reaches the eye
     */
    private void point(TracedRay ray, LinearRgb before) {
        LinearRgb reaching = before.times(ray.weight());
        if (ray.encounter().isEmpty()) {
            String what = ray.seen().map(light -> words.of("light", light.label())).orElse(words.of("path.sky"));
            lines.add("  " + decoration.headline(ray.kind(), what) + brings(ray.light().times(reaching)));
            return;
        }
        Encounter met = ray.encounter().get();
        lines.add("  " + decoration.headline(ray.kind(), names.name(met.place().surface()) + " " + words.figures(Figures.of(met.place().point()))));
        LinearRgb through = ray.absorbed().map(by -> reaching.times(by.left())).orElse(reaching);
        if (met.emitted().most() > 0) {
            lines.add("    " + words.of("name.emission") + brings(met.emitted().times(through)));
        }
        met.lights().stream().filter(light -> light.added().most() > 0)
                .forEach(light -> lines.add("    " + words.of("light", light.label()) + brings(light.added().times(through))));
        ray.children().forEach(child -> point(child, through));
    }

    private String brings(LinearRgb light) {
        return light.most() > 0 ? words.of("path.brings", words.figures(Figures.of(light))) : "";
    }
}
