package cz.paprsek.render;

import cz.paprsek.math.Require;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import java.util.Objects;

/**
 * How to render.
 *
 * @param settings size, depth and samples of the whole picture
 * @param region the part of the picture to compute; the image that results has the region's size
 * @param mode what the picture shows
 * @param threads how many workers, 1–1024; the picture does not depend on it
 * @param numbers whether depths and counts are to be put in the image as they are, for programs, and not as brightness and colours
 * @param fixedSampler whether what is random is the same in every pixel, as in a scene that is converted for POV-Ray
 */
public record RenderOptions(RenderSettings settings, Tile region, RenderMode mode, int threads, boolean numbers, boolean fixedSampler) {

    /** @throws IllegalArgumentException if the region does not lie inside the picture */
    public RenderOptions {
        Objects.requireNonNull(settings, "settings");
        Objects.requireNonNull(region, "region");
        Objects.requireNonNull(mode, "mode");
        Require.within("threads", threads, 1, 1024);
        Require.that(region.x() + region.width() <= settings.width() && region.y() + region.height() <= settings.height(),
                "region " + region.x() + "," + region.y() + "," + region.width() + "," + region.height()
                        + " must lie inside the picture of " + settings.width() + " × " + settings.height() + " pixels");
    }

    /** The whole picture, on all processors. */
    public static RenderOptions of(RenderSettings settings) {
        return new RenderOptions(settings, new Tile(0, 0, settings.width(), settings.height()), RenderMode.SHADED,
                Runtime.getRuntime().availableProcessors(), false, false);
    }

    /** What the scene asks for. */
    public static RenderOptions of(Scene scene) {
        return of(scene.settings());
    }

    public RenderOptions withThreads(int count) {
        return new RenderOptions(settings, region, mode, count, numbers, fixedSampler);
    }

    public RenderOptions withRegion(Tile part) {
        return new RenderOptions(settings, part, mode, threads, numbers, fixedSampler);
    }

    public RenderOptions withMode(RenderMode shown) {
        return new RenderOptions(settings, region, shown, threads, numbers, fixedSampler);
    }

    /**
     * With {@link RenderMode#DEPTH}, {@link RenderMode#RAYS}, {@link RenderMode#NODES} and {@link RenderMode#SAMPLES}: distances in scene units, 0 where nothing is seen, and
     * counts, in all three channels alike.
     */
    public RenderOptions withNumbers() {
        return new RenderOptions(settings, region, mode, threads, true, fixedSampler);
    }

    /** With the same random numbers in every pixel: to be compared, pixel by pixel, with pictures of programs that are given them. */
    public RenderOptions withFixedSampler() {
        return new RenderOptions(settings, region, mode, threads, numbers, true);
    }
}
