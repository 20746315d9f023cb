package cz.paprsek.sheet;

import cz.paprsek.render.RenderScene;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.scene.RenderSettings;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.Collectors;

/** Other pixels that give the same exercise with other numbers: their rays meet the same surfaces, and the same lights arrive there. */
record Variant(RenderScene scene, RenderSettings settings) {
    private static final int TRIES = 2000;
    /** How far from the pixel it is looked at first, as a share of the picture's width and height. */
    private static final double NEAREST = 1.0 / 8;

    /**
     * A pixel like another one.
     *
     * @param seed each gives another one, the same every time
     * @return empty if none was found
     */
    Optional<Pixel> like(Pixel pixel, long seed) {
        String wanted = kind(pixel.rays().get(0));
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < TRIES; i++) {
            // Near ones first, which are more often alike, but not so near that many seeds would share one.
            double reach = NEAREST + (1 - NEAREST) * (i + 1) / TRIES;
            int width = (int) Math.max(2, settings.width() * reach);
            int height = (int) Math.max(2, settings.height() * reach);
            int column = pixel.column() + random.nextInt(2 * width + 1) - width;
            int row = pixel.row() + random.nextInt(2 * height + 1) - height;
            boolean isOther = column != pixel.column() || row != pixel.row();
            if (isOther && column >= 0 && row >= 0 && column < settings.width() && row < settings.height()) {
                Pixel other = scene.explain(settings, column, row);
                if (kind(other.rays().get(0)).equals(wanted)) {
                    return Optional.of(other);
                }
            }
        }
        return Optional.empty();
    }

    private static String kind(TracedRay ray) {
        return ray.encounter().map(met -> met.place().surface().part() + " " + met.place().face() + met.place().fromInside()
                + met.lights().stream().map(term -> term.visibility() > 0 ? "+" : "-").collect(Collectors.joining())
                + ray.children().stream().map(child -> child.kind() + kind(child)).collect(Collectors.joining(",", "(", ")"))).orElse("/");
    }
}
