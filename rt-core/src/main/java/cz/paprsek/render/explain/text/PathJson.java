package cz.paprsek.render.explain.text;

import cz.paprsek.io.Json;
import cz.paprsek.render.explain.Pixel.PathPixel;
import cz.paprsek.render.explain.Pixel.PathPixel.Example;
import cz.paprsek.render.explain.Pixel.PathPixel.Way;
import cz.paprsek.words.Words;

/** A pixel of paths as a JSON object, every number in full; colours are linear. */
public final class PathJson {
    private static final PathWords NAMES = new PathWords(Words.ENGLISH);

    private PathJson() {}

    @SuppressWarnings("exports") // Told as it is by its toString; what it is made of is for our own programs.
    public static Json of(PathPixel pixel) {
        Json json = TreeJson.color(new Json().with("column", pixel.column()).with("row", pixel.row()).with("paths", pixel.samples().size()), "light", pixel.light());
        if (pixel.exposure() != 0 || !pixel.light().equals(pixel.developed())) {
            TreeJson.color(json.with("exposure", pixel.exposure()).with("tone", pixel.tone().toString()), "shown", pixel.developed());
        }
        return json.with("error", Math.abs(pixel.interval())).with("trusted", pixel.interval() >= 0)
                .with("ways", pixel.ways().stream().map(way -> amount(new Json().withTexts("way", NAMES.names(way)), pixel, way)).toList())
                .with("sources", pixel.sources().stream().map(way -> amount(new Json().with("source", NAMES.source(way)), pixel, way)).toList())
                .with("examples", pixel.examples().stream().map(PathJson::of).toList())
                .with("samples", pixel.samples().stream().map(sample -> TreeJson.color(new Json(), "light", sample)).toList());
    }

    private static Json amount(Json json, PathPixel pixel, Way way) {
        TreeJson.color(json.with("paths", way.paths()).with("share", pixel.share(way.light())), "light", way.light());
        way.halfWidth().ifPresent(half -> TreeJson.color(json, "half-width", half));
        return json;
    }

    private static Json of(Example example) {
        Json json = TreeJson.color(new Json().with("way", example.way()).with("sample", example.sample()), "brought", example.brought());
        return json.with("ray", TreeJson.of(example.ray()));
    }
}
