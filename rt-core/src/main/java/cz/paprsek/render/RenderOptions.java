package cz.paprsek.render;

import cz.paprsek.math.Require;
import cz.paprsek.render.denoise.Denoiser;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.show.PathCounts;
import cz.paprsek.render.show.PathLayers;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;

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
 * @param layers what else is to be known of each pixel, each once
 * @param transparent whether the picture is to have opacity: nothing where nothing is hit, in place of the sky or background that is still seen in mirrors and through glass,
 *     and of a pixel that is hit in part its share
 * @param noise what becomes of the noise of a picture of paths, in whole passes of {@value RenderSettings#USUAL_PATHS} if anything; layers, and what is known of its errors,
 *     stay as they are
 */
public record RenderOptions(RenderSettings settings, Tile region, RenderMode mode, int threads, boolean numbers, boolean fixedSampler, int step,
        List<Layer> layers, boolean transparent, Noise noise) {
    private static final String ONLY_JUDGED = " is of paths, and of pixels with samples A..B: no others are judged";

    /** What becomes of noise. */
    public enum Noise {
        /** It stays. */
        LEFT,
        /** It stays, and what is to be known to take it out goes to planes of its own: of a part of a picture that is put together. */
        TOLD,
        /** It is taken out of the finished picture, which is whole. */
        TAKEN_OUT
    }

    /** @throws IllegalArgumentException if the region does not lie inside the picture */
    public RenderOptions {
        Objects.requireNonNull(settings, "settings");
        Objects.requireNonNull(region, "region");
        Objects.requireNonNull(mode, "mode");
        Objects.requireNonNull(noise, "noise");
        boolean denoised = noise != Noise.LEFT;
        Require.within("threads", threads, 1, 1024);
        Require.within("step", step, 1, RenderSettings.LARGEST_SIDE);
        layers = List.copyOf(layers);
        Require.that(layers.stream().distinct().count() == layers.size(), "each layer can be asked for once: " + layers);
        Require.that(mode == RenderMode.SHADED || (layers.isEmpty() && !transparent), "layers and transparency are of pictures of light, not of " + mode);
        Require.that(!layers.contains(Layer.ERROR) || settings.isPath() || settings.isAdaptive(), "layer error" + ONLY_JUDGED);
        Require.that(mode != RenderMode.ERROR || settings.isPath() || settings.isAdaptive(), "mode error" + ONLY_JUDGED);
        Require.that(!denoised || mode == RenderMode.SHADED, "a denoiser is for pictures of light, not of " + mode);
        Require.that(!denoised || settings.isPath(), "a denoiser is for integrator path: other pictures have no noise that it would know");
        Require.that(!denoised || settings.mostRays() % RenderSettings.USUAL_PATHS == 0,
                "a denoiser needs whole passes: samples of a multiple of " + RenderSettings.USUAL_PATHS + ", not " + settings.mostRays());
        int columns = coarse(settings.width(), step);
        int rows = coarse(settings.height(), step);
        Require.that(region.x() + region.width() <= columns && region.y() + region.height() <= rows,
                "region " + region.x() + "," + region.y() + "," + region.width() + "," + region.height()
                        + " must lie inside the picture of " + columns + " × " + rows + " pixels");
        Require.that(noise != Noise.TAKEN_OUT || (region.width() == columns && region.height() == rows), "a denoiser needs the whole picture, not a region of it");
    }

    /** The whole picture, on all processors. */
    public static RenderOptions of(RenderSettings settings) {
        return new RenderOptions(settings, new Tile(0, 0, settings.width(), settings.height()), RenderMode.SHADED,
                Runtime.getRuntime().availableProcessors(), false, false, 1, List.of(), false, Noise.LEFT);
    }

    /** What the scene asks for. */
    public static RenderOptions of(Scene scene) {
        return of(scene.settings());
    }

    /** With others of the same size, for the same region. */
    public RenderOptions withSettings(RenderSettings other) {
        return new RenderOptions(other, region, mode, threads, numbers, fixedSampler, step, layers, transparent, noise);
    }

    public RenderOptions withThreads(int count) {
        return new RenderOptions(settings, region, mode, count, numbers, fixedSampler, step, layers, transparent, noise);
    }

    public RenderOptions withRegion(Tile part) {
        return new RenderOptions(settings, part, mode, threads, numbers, fixedSampler, step, layers, transparent, noise);
    }

    /** For a part of the picture, of which others make the rest: noise that is to be taken out of all of it is told. */
    public RenderOptions ofPart(Tile part) {
        return new RenderOptions(settings, part, mode, threads, numbers, fixedSampler, step, layers, transparent, noise == Noise.TAKEN_OUT ? Noise.TOLD : noise);
    }

    /** Whether noise is to be taken out once the picture is finished. */
    public boolean denoised() {
        return noise == Noise.TAKEN_OUT;
    }

    /** Whether anything is to be known that a denoiser goes by. */
    boolean isGuided() {
        return noise != Noise.LEFT;
    }

    public RenderOptions withMode(RenderMode shown) {
        return new RenderOptions(settings, region, shown, threads, numbers, fixedSampler, step, layers, transparent, noise);
    }

    /**
     * With {@link RenderMode#DEPTH}, {@link RenderMode#RAYS}, {@link RenderMode#NODES} and {@link RenderMode#SAMPLES}: distances in scene units, 0 where nothing is seen, and
     * counts, in all three channels alike.
     */
    public RenderOptions withNumbers() {
        return new RenderOptions(settings, region, mode, threads, true, fixedSampler, step, layers, transparent, noise);
    }

    /** With the same random numbers in every pixel: to be compared, pixel by pixel, with pictures of programs that are given them. */
    public RenderOptions withFixedSampler() {
        return new RenderOptions(settings, region, mode, threads, numbers, true, step, layers, transparent, noise);
    }

    /** With what else is to be known of each pixel. */
    public RenderOptions withLayers(List<Layer> wanted) {
        return new RenderOptions(settings, region, mode, threads, numbers, fixedSampler, step, wanted, transparent, noise);
    }

    /** With opacity: transparent where nothing is hit. */
    public RenderOptions withTransparency() {
        return new RenderOptions(settings, region, mode, threads, numbers, fixedSampler, step, layers, true, noise);
    }

    /** With noise taken out once the picture is finished. */
    public RenderOptions withDenoiser() {
        return new RenderOptions(settings, region, mode, threads, numbers, fixedSampler, step, layers, transparent, Noise.TAKEN_OUT);
    }

    /** A coarse image of the whole picture, to be shown before it: each pixel stands for step × step of them, and at right and bottom for those there are. */
    public RenderOptions withStep(int pixels) {
        Require.within("step", pixels, 1, RenderSettings.LARGEST_SIDE);
        Tile whole = new Tile(0, 0, coarse(settings.width(), pixels), coarse(settings.height(), pixels));
        return new RenderOptions(settings, whole, mode, threads, numbers, fixedSampler, pixels, layers, transparent, noise);
    }

    /** How many numbers each pixel gets: three of light, with opacity that, those of layers, and those that are kept from pass to pass. */
    public int channels(Scene scene) {
        return keptFrom(scene) + kept(scene);
    }

    /** Which of them, counted from 0, is the first that is kept: of a picture in passes the number of the pixel's paths. */
    public int keptFrom(Scene scene) {
        Objects.requireNonNull(scene, "scene");
        return (transparent ? 4 : 3) + layerPlanes(scene).size();
    }

    /** How many numbers of each pixel are kept from one pass to the next; none if all of the picture's tiles are made once and for all. */
    int kept(Scene scene) {
        return !isInPasses() ? 0 : mode != RenderMode.SHADED ? PathCounts.kept(paths()) : isWatched() ? PathLayers.kept(paths(), layers, transparent, isGuided(), scene.lights().size()) : paths().kept();
    }

    /** The paths of its pixels. */
    Passes paths() {
        return new Passes(settings, fixedSampler, isJudged() || isGuided());
    }

    /** Whether it is to be known how near pixels are to the truth. */
    boolean isJudged() {
        return settings.isAdaptive() || mode == RenderMode.ERROR || layers.contains(Layer.ERROR);
    }

    /** Whether more is to be known of pixels than their light. */
    boolean isWatched() {
        return !layers.isEmpty() || transparent || isGuided();
    }

    /** Whether the picture is made in passes, each of which makes all of it better. */
    public boolean isInPasses() {
        return settings.isPath() && (mode == RenderMode.SHADED || mode.scale().isPresent());
    }

    /** Into how many passes a picture is divided at most: one, unless it is {@linkplain #isInPasses made in passes}. */
    public int passes() {
        return isInPasses() ? Passes.passes(settings) : 1;
    }

    /** The names of the planes of what else is known of each pixel when the picture is finished; last, if noise is told, those that tell it. */
    public List<String> planes(Scene scene) {
        Objects.requireNonNull(scene, "scene");
        List<String> told = noise == Noise.TOLD ? Denoiser.PLANES : List.of();
        return Stream.of(layerPlanes(scene), told).flatMap(List::stream).toList();
    }

    /** The names of the planes of all layers. */
    List<String> layerPlanes(Scene scene) {
        return layers.stream().flatMap(layer -> layer.planes(scene.lights()).stream()).toList();
    }

    /** How many pixels of the image there are to so many of the picture. */
    static int coarse(int pixels, int step) {
        return (pixels + step - 1) / step;
    }
}
