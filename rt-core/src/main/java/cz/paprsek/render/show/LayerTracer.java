package cz.paprsek.render.show;

import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.integrate.Whitted;
import cz.paprsek.render.sample.PixelSums;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.World;
import java.util.List;

/**
 * The tracer that renders pictures, watched for what rays from the eye meet first: how much of a pixel is covered, and what goes to layers. The
 * picture's light is the same to the last bit.
 */
public final class LayerTracer extends Whitted {
    private final Sampling sampling;
    private final LayerSums<PixelSums> sums;

    public LayerTracer(World scene, int maxDepth, Sampling sampling, List<Layer> layers, boolean transparent) {
        this(scene, maxDepth, sampling, new LayerSums<>(scene, new FirstSight(scene), layers, transparent, sampling::newSums, sampling::newOtherSums));
    }

    private LayerTracer(World scene, int maxDepth, Sampling sampling, LayerSums<PixelSums> sums) {
        super(scene, maxDepth, sampling, sums.sight);
        this.sampling = sampling;
        this.sums = sums;
    }

    @Override
    public void block(Eye eye, int x, int y, int width, int height, Film film) {
        for (int i = 0; i < width * height && !isCancelled(); i++) {
            pixel(eye, x + i % width, y + i / width, film);
        }
    }

    private void pixel(Eye eye, int x, int y, Film film) {
        sums.clear();
        for (int more = sampling.rays(); more > 0 && !isCancelled(); more = Math.max(sampling.further(sums.light), sums.transparent ? sampling.further(sums.cover) : 0)) {
            for (int i = 0; i < more; i++) {
                sums.sight.begin();
                traceAlone(eye, x, y, sums.light.count());
                sums.add(alone());
            }
        }
        sums.expose(x, y, film);
    }
}
