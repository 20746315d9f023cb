package cz.paprsek.render.show;

import cz.paprsek.ray.Arrival;
import cz.paprsek.render.account.Ledger;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.integrate.Paths;
import cz.paprsek.render.sample.PassSums;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import java.util.List;

/**
 * The tracer of paths, watched for what rays from the eye meet first, and for where their light comes from: how much of a pixel is covered, and what goes to layers.
 * The picture's light is the same to the last bit.
 */
public final class PathLayers extends Paths {
    private final World scene;
    private final Passes sampling;
    private final List<Layer> layers;
    private final boolean transparent;
    private final PathSums sums;
    private final float[] kept;
    private final Ledger ledger = new Ledger();
    /** How many rays' accounts are open: that of the eye's is the first. */
    private int open;
    private double albedoRed;
    private double albedoGreen;
    private double albedoBlue;

    public PathLayers(World scene, int maxDepth, Passes sampling, List<Layer> layers, boolean transparent) {
        super(scene, maxDepth, sampling);
        this.scene = scene;
        this.sampling = sampling;
        this.layers = layers;
        this.transparent = transparent;
        sums = new PathSums(sampling, layers, transparent, scene.lamps().length);
        kept = new float[kept(sampling, layers, transparent, scene.lamps().length)];
    }

    /**
     * How many numbers of a pixel are kept from pass to pass.
     *
     * @param lights how many the scene has
     */
    public static int kept(Passes sampling, List<Layer> layers, boolean transparent, int lights) {
        return PathSums.kept(sampling, layers, transparent, lights);
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
            sample(eye, x, y, before + i);
        }
        if (isCancelled()) {
            return;
        }
        sums.endPass(before == 0);
        if (sums.light.areWhole()) {
            sums.save(kept);
            film.keep(x, y, kept);
        }
        expose(x, y, film);
        if (further() > 0) {
            film.wantMore(1);
        }
    }

    private int further() {
        return Math.max(sampling.further(sums.light), transparent ? sampling.further(sums.cover) : 0);
    }

    private void sample(Eye eye, int x, int y, int number) {
        open = 0;
        albedoRed = 0;
        albedoGreen = 0;
        albedoBlue = 0;
        sums.hits.begin();
        ledger.clear();
        traceAlone(eye, x, y, number);
        ledger.close();
        Level level = alone();
        boolean isSeen = sums.hits.object() > 0 || !transparent;
        sums.light.meets |= sums.hits.object() > 0;
        add(isSeen, sums.light, level.red, level.green, level.blue);
        add(sums.hits.object() > 0, sums.cover, 1, 1, 1);
        add(true, sums.albedo, albedoRed, albedoGreen, albedoBlue);
        ledger.sumDirect();
        add(isSeen, sums.direct, ledger.red, ledger.green, ledger.blue);
        for (int i = 0; i < sums.sources.size(); i++) {
            ledger.sum(i, i < scene.lamps().length);
            add(isSeen, sums.sources.get(i), ledger.red, ledger.green, ledger.blue);
        }
    }

    private void add(boolean isSeen, PassSums to, double red, double green, double blue) {
        to.add(isSeen ? red : 0, isSeen ? green : 0, isSeen ? blue : 0, alone().isNegative);
    }

    private void expose(int x, int y, Film film) {
        PassSums light = sums.light;
        light.mean();
        if (transparent) {
            sums.cover.mean();
            film.set(x, y, light.red, light.green, light.blue, sums.cover.red);
        } else {
            film.set(x, y, light.red, light.green, light.blue);
        }
        PassSums direct = sums.direct;
        direct.mean();
        int plane = 0;
        for (Layer layer : layers) {
            switch (layer) {
                case NORMAL -> film.setPlanes(plane, x, y, sums.hits.normalX(), sums.hits.normalY(), sums.hits.normalZ());
                case ALBEDO -> expose(sums.albedo, plane, x, y, film);
                case DEPTH -> film.setPlane(plane, x, y, sums.hits.distance());
                case OBJECT -> film.setPlane(plane, x, y, sums.object());
                case DIRECT -> film.setPlanes(plane, x, y, direct.red, direct.green, direct.blue);
                case INDIRECT -> film.setPlanes(plane, x, y, Math.max(0, light.red - direct.red), Math.max(0, light.green - direct.green), Math.max(0, light.blue - direct.blue));
                case SAMPLES -> film.setPlane(plane, x, y, light.count());
                case ERROR -> film.setPlane(plane, x, y, sums.interval());
                case LIGHT -> exposeSources(plane, x, y, film);
            }
            plane += layer.planes(scene.scene().lights()).size();
        }
    }

    private static void expose(PassSums sums, int plane, int x, int y, Film film) {
        sums.mean();
        film.setPlanes(plane, x, y, sums.red, sums.green, sums.blue);
    }

    private void exposeSources(int plane, int x, int y, Film film) {
        for (int i = 0; i < sums.sources.size(); i++) {
            expose(sums.sources.get(i), plane + 3 * i, x, y, film);
        }
    }

    @Override
    public void following(boolean refracted, double red, double green, double blue) {
        ledger.following(red, green, blue);
    }

    @Override
    public void missed(Level level) {
        ledger.arrived(level, Ledger.SKY);
    }

    @Override
    public void met(Level level) {
        if (open++ == 0) {
            sums.hits.meet(level, scene.parts().object(level.ray.part));
            double diffusion = scene.parts().finish(level.ray.part).diffusion;
            albedoRed = diffusion * level.colorRed;
            albedoGreen = diffusion * level.colorGreen;
            albedoBlue = diffusion * level.colorBlue;
        }
        ledger.met(level);
    }

    /** Bodies of lights are bodies like others; the disc of a sun is sky. */
    @Override
    public void seen(Level level, int lamp) {
        if (open == 0 && Double.isFinite(level.ray.max)) {
            sums.hits.meet(level, scene.scene().objects().size() + lamp);
        }
        ledger.arrived(level, lamp);
    }

    @Override
    public void sought(int lamp, Arrival arrival, double facing, double visibility) {
        ledger.sought(lamp);
    }

    @Override
    public void illuminated(double diffuse, double highlight, double red, double green, double blue) {
        ledger.illuminated(red, green, blue);
    }

    @Override
    public void averaged(int lamp, double red, double green, double blue) {
        ledger.averaged(lamp, red, green, blue);
    }

    @Override
    public void emitted(double red, double green, double blue) {
        ledger.emitted(red, green, blue);
    }

    @Override
    public void absorbed(int body, double length, double red, double green, double blue) {
        ledger.absorbed(red, green, blue);
    }

    @Override
    public void ended(Level level) {
        open--;
        ledger.ended();
    }
}
