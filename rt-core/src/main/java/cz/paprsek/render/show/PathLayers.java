package cz.paprsek.render.show;

import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.integrate.Paths;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.surface.World;
import java.util.List;

/**
 * The tracer of paths, watched for what rays from the eye meet first, and for where their light comes from: how much of a pixel is covered, and what goes to layers.
 * The picture's light is the same to the last bit.
 */
public final class PathLayers extends Paths {
    private final Passes sampling;
    private final PathSums sums;
    private final float[] kept;

    /** @param guided whether a denoiser is to be guided */
    public PathLayers(World scene, int maxDepth, Passes sampling, List<Layer> layers, boolean transparent, boolean guided) {
        this(scene, maxDepth, sampling, new PathSums(scene, sampling, layers, transparent, guided), guided);
    }

    private PathLayers(World scene, int maxDepth, Passes sampling, PathSums sums, boolean guided) {
        super(scene, maxDepth, sampling, sums.sight);
        this.sampling = sampling;
        this.sums = sums;
        kept = new float[kept(sampling, sums.layers, sums.transparent, guided, scene.lamps().length)];
    }

    /**
     * How many numbers of a pixel are kept from pass to pass: first the sums of its light, and last, if a denoiser is guided, its {@link Guides}.
     *
     * @param lights how many the scene has
     */
    public static int kept(Passes sampling, List<Layer> layers, boolean transparent, boolean guided, int lights) {
        return PathSums.kept(sampling, layers, transparent, guided, lights);
    }

    @Override
    protected void pass(Eye eye, int x, int y, Film film) {
        film.kept(x, y, kept);
        sums.load(kept);
        int before = sums.light.count();
        int more = further();
        if (more == 0) {
            return;
        }
        for (int i = 0; i < more; i++) {
            sums.sight.begin();
            traceAlone(eye, x, y, before + i);
            sums.add(alone());
            sums.guide();
        }
        if (isCancelled()) {
            return;
        }
        sums.endPass(before == 0);
        if (sums.light.areWhole()) {
            sums.save(kept);
            film.keep(x, y, kept);
        }
        sums.expose(x, y, film);
        if (further() > 0) {
            film.wantMore(1);
        }
    }

    private int further() {
        return Math.max(sampling.further(sums.light), sums.transparent ? sampling.further(sums.cover) : 0);
    }
}
