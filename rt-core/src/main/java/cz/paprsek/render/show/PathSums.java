package cz.paprsek.render.show;

import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.sample.PassSums;
import cz.paprsek.render.sample.Passes;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** All that is summed of a pixel's paths for its light and its layers, and how it is kept from pass to pass. Scratch of one worker. */
final class PathSums {
    final PassSums light;
    /** Which share of the pixel is covered. */
    final PassSums cover;
    final PassSums albedo;
    final PassSums direct;
    /** Of each light, and last of all that comes from none. */
    final List<PassSums> sources = new ArrayList<>();
    final FirstHits hits = new FirstHits();
    private final List<PassSums> asked;
    private final boolean asksForHits;
    private final boolean asksForObject;
    private final boolean asksForError;
    private int object;
    private double interval;

    /** @param lights how many the scene has */
    PathSums(Passes sampling, List<Layer> layers, boolean transparent, int lights) {
        light = sampling.newSums();
        cover = transparent ? sampling.newSums() : sampling.newOtherSums();
        albedo = sampling.newOtherSums();
        direct = sampling.newOtherSums();
        for (int i = 0; i <= lights && layers.contains(Layer.LIGHT); i++) {
            sources.add(sampling.newOtherSums());
        }
        asksForHits = layers.contains(Layer.NORMAL) || layers.contains(Layer.DEPTH);
        asksForObject = layers.contains(Layer.OBJECT);
        asksForError = layers.contains(Layer.ERROR);
        Stream<PassSums> more = Stream.of(transparent ? Stream.of(cover) : Stream.<PassSums>empty(), layers.contains(Layer.ALBEDO) ? Stream.of(albedo) : Stream.<PassSums>empty(),
                asksForDirect(layers) ? Stream.of(direct) : Stream.<PassSums>empty(), sources.stream()).flatMap(one -> one);
        asked = Stream.concat(Stream.of(light), more).toList();
    }

    private static boolean asksForDirect(List<Layer> layers) {
        return layers.contains(Layer.DIRECT) || layers.contains(Layer.INDIRECT);
    }

    /** How many numbers of a pixel are kept. */
    static int kept(Passes sampling, List<Layer> layers, boolean transparent, int lights) {
        return sampling.kept() * (transparent ? 2 : 1)
                + sampling.keptOfOthers() * ((layers.contains(Layer.ALBEDO) ? 1 : 0) + (asksForDirect(layers) ? 1 : 0) + (layers.contains(Layer.LIGHT) ? lights + 1 : 0))
                + (layers.contains(Layer.NORMAL) || layers.contains(Layer.DEPTH) ? FirstHits.SIZE : 0) + (layers.contains(Layer.OBJECT) ? 1 : 0);
    }

    /** Goes on with what was kept. */
    void load(float[] numbers) {
        int at = 0;
        for (PassSums one : asked) {
            at = one.load(numbers, at);
        }
        hits.clear();
        at = asksForHits ? hits.load(numbers, at) : at;
        object = asksForObject ? (int) numbers[at] : 0;
        judge();
    }

    /** Pixels are judged by whole passes, in which all sequences have the same number of samples. */
    private void judge() {
        interval = asksForError ? light.interval() : 0;
    }

    /** Keeps whole passes. */
    void save(float[] numbers) {
        int at = 0;
        for (PassSums one : asked) {
            at = one.save(numbers, at);
        }
        at = asksForHits ? hits.save(numbers, at) : at;
        if (asksForObject) {
            numbers[at] = object;
        }
    }

    /** A pass has ended, be it whole or the last. Which object most samples meet is known from the first one. */
    void endPass(boolean isFirst) {
        hits.round();
        object = isFirst ? hits.mostFrequent() : object;
        if (light.areWhole()) {
            judge();
        }
    }

    /** How near the light was to the true one after the last whole pass. */
    double interval() {
        return interval;
    }

    /** The number of the object that is seen, from 1; 0 for none. */
    int object() {
        return object;
    }
}
