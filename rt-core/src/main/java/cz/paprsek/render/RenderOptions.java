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
 * @param region the part of the picture to compute, in pixels of the image; the image that results has the region's size
 * @param mode what the picture shows
 * @param threads how many workers, 1–1024; the picture does not depend on it
 * @param numbers whether depths and counts are to be put in the image as they are, for programs, and not as brightness and colours
 * @param fixedSampler whether what is random is the same in every pixel, as in a scene that is converted for POV-Ray
 * @param step how many pixels of the picture stand side by side in one of the image: 1 for the picture itself, up to {@value RenderSettings#LARGEST_SIDE}
 */
public record RenderOptions(RenderSettings settings, Tile region, RenderMode mode, int threads, boolean numbers, boolean fixedSampler, int step) {

    /** @throws IllegalArgumentException if the region does not lie inside the picture */
    public RenderOptions {
        Objects.requireNonNull(settings, "settings");
        Objects.requireNonNull(region, "region");
        Objects.requireNonNull(mode, "mode");
        Require.within("threads", threads, 1, 1024);
        Require.within("step", step, 1, RenderSettings.LARGEST_SIDE);
        int columns = coarse(settings.width(), step);
        int rows = coarse(settings.height(), step);
        Require.that(region.x() + region.width() <= columns && region.y() + region.height() <= rows,
                "region " + region.x() + "," + region.y() + "," + region.width() + "," + region.height()
                        + " must lie inside the picture of " + columns + " × " + rows + " pixels");
    }

    /** The whole picture, on all processors. */
    public static RenderOptions of(RenderSettings settings) {
        return new RenderOptions(settings, new Tile(0, 0, settings.width(), settings.height()), RenderMode.SHADED,
                Runtime.getRuntime().availableProcessors(), false, false, 1);
    }

    /** What the scene asks for. */
    public static RenderOptions of(Scene scene) {
        return of(scene.settings());
    }

    public RenderOptions withThreads(int count) {
        return new RenderOptions(settings, region, mode, count, numbers, fixedSampler, step);
    }

    public RenderOptions withRegion(Tile part) {
        return new RenderOptions(settings, part, mode, threads, numbers, fixedSampler, step);
    }

    public RenderOptions withMode(RenderMode shown) {
        return new RenderOptions(settings, region, shown, threads, numbers, fixedSampler, step);
    }

    /**
     * With {@link RenderMode#DEPTH}, {@link RenderMode#RAYS}, {@link RenderMode#NODES} and {@link RenderMode#SAMPLES}: distances in scene units, 0 where nothing is seen, and
     * counts, in all three channels alike.
     */
    public RenderOptions withNumbers() {
        return new RenderOptions(settings, region, mode, threads, true, fixedSampler, step);
    }

    /** With the same random numbers in every pixel: to be compared, pixel by pixel, with pictures of programs that are given them. */
    public RenderOptions withFixedSampler() {
        return new RenderOptions(settings, region, mode, threads, numbers, true, step);
    }

    /** A coarse image of the whole picture, to be shown before it: each pixel stands for step × step of them, and at right and bottom for those there are. */
    public RenderOptions withStep(int pixels) {
        Require.within("step", pixels, 1, RenderSettings.LARGEST_SIDE);
        Tile whole = new Tile(0, 0, coarse(settings.width(), pixels), coarse(settings.height(), pixels));
        return new RenderOptions(settings, whole, mode, threads, numbers, fixedSampler, pixels);
    }

    /** How many pixels of the image there are to so many of the picture. */
    static int coarse(int pixels, int step) {
        return (pixels + step - 1) / step;
    }
}
