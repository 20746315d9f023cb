package cz.paprsek.render.show;

import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.sample.PassSums;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.surface.World;
import java.util.List;
import java.util.stream.Stream;

/** The same of a pixel's paths, and how it is kept from pass to pass. */
final class PathSums extends LayerSums<PassSums> {
    private final List<PassSums> asked;
    private final boolean asksForHits;
    private final boolean asksForObject;
    private final boolean asksForError;
    private final boolean isGuided;
    private final Guides guides = new Guides();
    private int object;
    private double interval;

    PathSums(World scene, Passes sampling, List<Layer> layers, boolean transparent, boolean guided) {
        super(scene, new FirstSight(scene), layers, transparent, sampling::newSums, sampling::newOtherSums);
        asksForHits = layers.contains(Layer.NORMAL) || layers.contains(Layer.DEPTH);
        asksForObject = layers.contains(Layer.OBJECT);
        isGuided = guided;
        asksForError = layers.contains(Layer.ERROR);
        Stream<PassSums> more = Stream.of(transparent ? Stream.of(cover) : Stream.<PassSums>empty(), layers.contains(Layer.ALBEDO) ? Stream.of(albedo) : Stream.<PassSums>empty(),
                asksForDirect(layers) ? Stream.of(direct) : Stream.<PassSums>empty(), sources.stream()).flatMap(one -> one);
        asked = Stream.concat(Stream.of(light), more).toList();
    }

    private static boolean asksForDirect(List<Layer> layers) {
        return layers.contains(Layer.DIRECT) || layers.contains(Layer.INDIRECT);
    }

    /** How many numbers of a pixel are kept: last those that guide. */
    static int kept(Passes sampling, List<Layer> layers, boolean transparent, boolean guided, int lights) {
        return (guided ? Guides.SIZE : 0) + sampling.kept() * (transparent ? 2 : 1)
                + sampling.keptOfOthers() * ((layers.contains(Layer.ALBEDO) ? 1 : 0) + (asksForDirect(layers) ? 1 : 0) + (layers.contains(Layer.LIGHT) ? lights + 1 : 0))
                + (layers.contains(Layer.NORMAL) || layers.contains(Layer.DEPTH) ? FirstHits.SIZE : 0) + (layers.contains(Layer.OBJECT) ? 1 : 0);
    }

    /** Goes on with what was kept. */
    void load(float[] numbers) {
        int at = 0;
        for (PassSums one : asked) {
            at = one.load(numbers, at);
        }
        sight.hits.clear();
        at = asksForHits ? sight.hits.load(numbers, at) : at;
        object = asksForObject ? (int) numbers[at++] : 0;
        if (isGuided) {
            guides.sums.load(numbers, at);
        }
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
        at = asksForHits ? sight.hits.sums.save(numbers, at) : at;
        if (asksForObject) {
            numbers[at++] = object;
        }
        if (isGuided) {
            guides.sums.save(numbers, at);
        }
    }

    /** What guides is taken from the sample that was added last as well, if anything is to be guided. */
    void guide() {
        if (isGuided) {
            guides.add(2 * Sampler.scramble(light.count() - 1) / Sampler.SCRAMBLES, sight.guide);
        }
    }

    /** A pass has ended, be it whole or the last. Which object most samples meet is known from the first one. */
    void endPass(boolean isFirst) {
        sight.hits.sums.round();
        guides.sums.round();
        object = isFirst ? sight.hits.mostFrequent() : object;
        if (light.areWhole()) {
            judge();
        }
    }

    @Override
    void sumDirect() {
        sight.close();
        sight.sumDirect();
    }

    /** How near the light was to the true one after the last whole pass. */
    @Override
    double interval() {
        return interval;
    }

    @Override
    int object() {
        return object;
    }
}
