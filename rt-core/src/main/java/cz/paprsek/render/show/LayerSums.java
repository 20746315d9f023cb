package cz.paprsek.render.show;

import cz.paprsek.render.film.Film;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.sample.PixelSums;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;

/** All that is summed of a pixel's samples for its light and its layers. Scratch of one worker. */
class LayerSums<S extends PixelSums> {
    final S light;
    /** Which share of the pixel is covered. */
    final S cover;
    final S albedo;
    final S direct;
    /** Of each light, and last of all that comes from none. */
    final List<S> sources;
    final FirstSight sight;
    final List<Layer> layers;
    final boolean transparent;
    private final World scene;

    /** @param others makes sums by which the samples are not judged */
    LayerSums(World scene, FirstSight sight, List<Layer> layers, boolean transparent, Supplier<S> judged, Supplier<S> others) {
        this.scene = scene;
        this.sight = sight;
        this.layers = layers;
        this.transparent = transparent;
        light = judged.get();
        cover = transparent ? judged.get() : others.get();
        albedo = others.get();
        direct = others.get();
        sources = Stream.generate(others).limit(layers.contains(Layer.LIGHT) ? scene.lamps().length + 1 : 0).toList();
    }

    final void clear() {
        light.clear();
        cover.clear();
        albedo.clear();
        direct.clear();
        sources.forEach(PixelSums::clear);
        sight.hits.clear();
    }

    /** Adds a ray from the eye that has been watched, and what it brought. */
    final void add(Level level) {
        boolean isNegative = level.isNegative;
        boolean isMet = sight.isMet();
        boolean isSeen = isMet || !transparent;
        light.meets |= isMet;
        add(isSeen, light, level.red, level.green, level.blue, isNegative);
        add(isMet, cover, 1, 1, 1, isNegative);
        add(true, albedo, sight.albedoRed, sight.albedoGreen, sight.albedoBlue, isNegative);
        sumDirect();
        add(isSeen, direct, sight.red, sight.green, sight.blue, isNegative);
        for (int i = 0; i < sources.size(); i++) {
            sight.sum(i, scene.lamps().length);
            add(isSeen, sources.get(i), sight.red, sight.green, sight.blue, isNegative);
        }
    }

    /** Closes the ledger, and has it sum what comes straight to what is seen. */
    void sumDirect() {
        sight.sumFirst();
        sight.close();
    }

    private void add(boolean isSeen, S to, double red, double green, double blue, boolean isNegative) {
        to.add(isSeen ? red : 0, isSeen ? green : 0, isSeen ? blue : 0, isNegative);
    }

    /** The number of the object that most samples meet, from 1; 0 for none. */
    int object() {
        return sight.hits.mostFrequent();
    }

    /** How near the light is to the true one. */
    double interval() {
        return light.interval();
    }

    /** Brings the means to the film. */
    final void expose(int x, int y, Film film) {
        light.mean();
        if (transparent) {
            cover.mean();
            film.set(x, y, light.red, light.green, light.blue, cover.red);
        } else {
            film.set(x, y, light.red, light.green, light.blue);
        }
        direct.mean();
        FirstHits hits = sight.hits;
        int plane = 0;
        for (Layer layer : layers) {
            switch (layer) {
                case NORMAL -> film.setPlanes(plane, x, y, hits.normalX(), hits.normalY(), hits.normalZ());
                case ALBEDO -> expose(albedo, plane, x, y, film);
                case DEPTH -> film.setPlane(plane, x, y, hits.distance());
                case OBJECT -> film.setPlane(plane, x, y, object());
                case DIRECT -> film.setPlanes(plane, x, y, direct.red, direct.green, direct.blue);
                case INDIRECT -> film.setPlanes(plane, x, y, Math.max(0, light.red - direct.red), Math.max(0, light.green - direct.green), Math.max(0, light.blue - direct.blue));
                case SAMPLES -> film.setPlane(plane, x, y, light.count());
                case ERROR -> film.setPlane(plane, x, y, interval());
                case LIGHT -> exposeSources(plane, x, y, film);
            }
            plane += layer.planes(scene.scene().lights()).size();
        }
    }

    private void expose(S sums, int plane, int x, int y, Film film) {
        sums.mean();
        film.setPlanes(plane, x, y, sums.red, sums.green, sums.blue);
    }

    private void exposeSources(int plane, int x, int y, Film film) {
        for (int i = 0; i < sources.size(); i++) {
            expose(sources.get(i), plane + 3 * i, x, y, film);
        }
    }
}
