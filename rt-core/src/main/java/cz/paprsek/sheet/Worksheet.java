package cz.paprsek.sheet;

import cz.paprsek.drawing.TreeDrawing;
import cz.paprsek.math.Require;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.text.Outline;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.words.Words;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalLong;

/**
 * A worksheet to be printed: of each pixel the sketch of the rays, what is given, and lines to be filled in, each to be reckoned from the numbers above it; then
 * their solutions. Numbers have four decimals and are reckoned on with these, so that a pocket calculator gets there. Of the ray through the middle of a pixel.
 */
public final class Worksheet {
    /** Rays of a smaller share are given rather than reckoned. */
    private static final double SMALLEST_SHARE = 0.04;
    private static final int MOST_RAYS = 6;

    private final Scene scene;
    private final OptionalLong seed;
    private final Words words;
    private final List<Task> tasks = new ArrayList<>();

    /** One pixel: exercises of rays, those before that others need. */
    record Task(Pixel pixel, String sketch, List<RayExercise> rays) {
        LinearRgb reckoned() {
            return rays.get(rays.size() - 1).light();
        }
    }

    /**
     * Of some pixels.
     *
     * @param ready the scene made ready for rays
     * @param settings size of the picture and depth of rays
     * @param places column and row of each pixel, counted from 0 at the top left
     * @param seed which variant, in which other pixels stand for these; empty for these
     * @throws IllegalArgumentException if there is no such pixel, if the picture is one of paths, or if there is no variant
     */
    public Worksheet(Scene scene, RenderScene ready, RenderSettings settings, List<int[]> places, OptionalLong seed, Words words) {
        this.scene = Objects.requireNonNull(scene, "scene");
        this.seed = Objects.requireNonNull(seed, "seed");
        this.words = Objects.requireNonNull(words, "words");
        Require.that(!settings.isPath(), "a worksheet is about single rays, not paths: integrator must be whitted");
        RenderSettings middle = settings.withSamples(1);
        for (int[] place : places) {
            Pixel pixel = ready.explain(middle, place[0], place[1]);
            if (seed.isPresent()) {
                pixel = new Variant(ready, middle).like(pixel, seed.getAsLong()).orElseThrow(() -> new IllegalArgumentException(
                        "no other pixel is like " + place[0] + "," + place[1] + ", whose rays meet the same: choose one that has such neighbours"));
            }
            tasks.add(task(pixel));
        }
    }

    private Task task(Pixel pixel) {
        TracedRay ray = pixel.rays().get(0);
        List<Outline> order = new ArrayList<>();
        childrenFirst(Outline.of(ray).pruned(SMALLEST_SHARE), order);
        List<Outline> chosen = order.subList(Math.max(0, order.size() - MOST_RAYS), order.size());
        Map<String, LinearRgb> found = new HashMap<>();
        List<RayExercise> exercises = new ArrayList<>();
        for (Outline outline : chosen) {
            RayExercise exercise = new RayExercise(outline, words, found);
            if (outline.ray().encounter().isPresent() || outline.ray().level() == 1) {
                exercises.add(exercise);
                found.put(outline.name(), exercise.light());
            }
        }
        return new Task(pixel, TreeDrawing.svg(scene, ray, SMALLEST_SHARE, words), exercises);
    }

    private static void childrenFirst(Outline outline, List<Outline> order) {
        outline.children().forEach(child -> childrenFirst(child, order));
        order.add(outline);
    }

    /** The same as a PDF of A4 pages, which has its fonts in it. */
    public byte[] pdf() {
        return new SheetPdf(scene.name(), seed, words).file(tasks);
    }

    /** The page: a whole HTML document that needs nothing beside it; printed, the solutions begin on a sheet of their own. */
    public String html() {
        return new SheetPage(scene.name(), seed, words).page(tasks);
    }
}
