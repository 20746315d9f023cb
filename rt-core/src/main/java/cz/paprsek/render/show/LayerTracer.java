package cz.paprsek.render.show;

import cz.paprsek.ray.Arrival;
import cz.paprsek.render.account.Ledger;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.film.Film.Layer;
import cz.paprsek.render.integrate.Whitted;
import cz.paprsek.render.sample.PixelSums;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * The tracer that renders pictures, watched for what rays from the eye meet first: how much of a pixel is covered, and what goes to layers. The
 * picture's light is the same to the last bit.
 */
public final class LayerTracer extends Whitted {
    private final World scene;
    private final Sampling sampling;
    private final List<Layer> layers;
    private final boolean transparent;
    private final PixelSums light;
    private final PixelSums cover;
    private final PixelSums albedo;
    private final PixelSums direct;
    /** Of each light, and last of all that comes from none. */
    private final List<PixelSums> sources;
    private final FirstHits hits = new FirstHits();
    private final Ledger ledger = new Ledger();
    private final double[] left = new double[3];
    /** How many rays' accounts are open: that of the eye's is the first. */
    private int open;
    /** Of the sample at hand. */
    private double albedoRed;
    private double albedoGreen;
    private double albedoBlue;
    private double directRed;
    private double directGreen;
    private double directBlue;
    private boolean isDirectKnown;

    public LayerTracer(World scene, int maxDepth, Sampling sampling, List<Layer> layers, boolean transparent) {
        super(scene, maxDepth, sampling);
        this.scene = scene;
        this.sampling = sampling;
        this.layers = layers;
        this.transparent = transparent;
        light = sampling.newSums();
        cover = sampling.newSums();
        albedo = sampling.newSums();
        direct = sampling.newSums();
        sources = Stream.generate(sampling::newSums).limit(layers.contains(Layer.LIGHT) ? scene.lamps().length + 1 : 0).toList();
    }

    @Override
    public void block(Eye eye, int x, int y, int width, int height, Film film) {
        for (int i = 0; i < width * height && !isCancelled(); i++) {
            pixel(eye, x + i % width, y + i / width, film);
        }
    }

    private void pixel(Eye eye, int x, int y, Film film) {
        light.clear();
        cover.clear();
        albedo.clear();
        direct.clear();
        sources.forEach(PixelSums::clear);
        hits.clear();
        for (int more = sampling.rays(); more > 0 && !isCancelled(); more = Math.max(sampling.further(light), transparent ? sampling.further(cover) : 0)) {
            for (int i = 0; i < more; i++) {
                sample(eye, x, y, light.count());
            }
        }
        light.mean();
        if (transparent) {
            cover.mean();
            film.set(x, y, light.red, light.green, light.blue, cover.red);
        } else {
            film.set(x, y, light.red, light.green, light.blue);
        }
        expose(x, y, film);
    }

    private void sample(Eye eye, int x, int y, int number) {
        open = 0;
        hits.begin();
        ledger.clear();
        albedoRed = 0;
        albedoGreen = 0;
        albedoBlue = 0;
        isDirectKnown = false;
        Arrays.fill(left, 1);
        traceAlone(eye, x, y, number);
        Level level = alone();
        boolean isSeen = hits.object() > 0 || !transparent;
        light.add(isSeen ? level.red : 0, isSeen ? level.green : 0, isSeen ? level.blue : 0, level.isNegative);
        double share = hits.object() > 0 ? 1 : 0;
        cover.add(share, share, share, level.isNegative);
        albedo.add(albedoRed, albedoGreen, albedoBlue, level.isNegative);
        direct.add(isSeen ? directRed : 0, isSeen ? directGreen : 0, isSeen ? directBlue : 0, level.isNegative);
        ledger.close();
        for (int i = 0; i < sources.size(); i++) {
            ledger.sum(i, i < scene.lamps().length);
            sources.get(i).add(isSeen ? ledger.red : 0, isSeen ? ledger.green : 0, isSeen ? ledger.blue : 0, level.isNegative);
        }
    }

    private void expose(int x, int y, Film film) {
        albedo.mean();
        direct.mean();
        int plane = 0;
        for (Layer layer : layers) {
            switch (layer) {
                case NORMAL -> film.setPlanes(plane, x, y, hits.normalX(), hits.normalY(), hits.normalZ());
                case ALBEDO -> film.setPlanes(plane, x, y, albedo.red, albedo.green, albedo.blue);
                case DEPTH -> film.setPlane(plane, x, y, hits.distance());
                case OBJECT -> film.setPlane(plane, x, y, hits.mostFrequent());
                case DIRECT -> film.setPlanes(plane, x, y, direct.red, direct.green, direct.blue);
                case INDIRECT -> film.setPlanes(plane, x, y, Math.max(0, light.red - direct.red), Math.max(0, light.green - direct.green), Math.max(0, light.blue - direct.blue));
                case SAMPLES -> film.setPlane(plane, x, y, light.count());
                case ERROR -> film.setPlane(plane, x, y, light.interval());
                case LIGHT -> exposeSources(plane, x, y, film);
            }
            plane += layer.planes(scene.scene().lights()).size();
        }
    }

    private void exposeSources(int plane, int x, int y, Film film) {
        for (int i = 0; i < sources.size(); i++) {
            PixelSums one = sources.get(i);
            one.mean();
            film.setPlanes(plane + 3 * i, x, y, one.red, one.green, one.blue);
        }
    }

    @Override
    public void met(Level level) {
        if (open++ == 0) {
            hits.meet(level, scene.parts().object(level.ray.part));
            double diffusion = scene.parts().finish(level.ray.part).diffusion;
            albedoRed = diffusion * level.colorRed;
            albedoGreen = diffusion * level.colorGreen;
            albedoBlue = diffusion * level.colorBlue;
        }
        ledger.met(level);
    }

    @Override
    public void following(boolean refracted, double red, double green, double blue) {
        if (open == 1 && !isDirectKnown) {
            keepDirect(alone());
        }
        ledger.following(red, green, blue);
    }

    @Override
    public void missed(Level level) {
        ledger.arrived(level, Ledger.SKY);
        endOfAll(level);
    }

    /** Bodies of lights are bodies like others; the disc of a sun is sky. */
    @Override
    public void seen(Level level, int lamp) {
        if (open == 0 && Double.isFinite(level.ray.max)) {
            hits.meet(level, scene.scene().objects().size() + lamp);
        }
        ledger.arrived(level, lamp);
        endOfAll(level);
    }

    /** Of a ray that leads to no other, all light is direct, and what substances take from it has been taken. */
    private void endOfAll(Level level) {
        if (open == 0) {
            keepDirect(level);
        }
        Arrays.fill(left, 1);
    }

    @Override
    public void absorbed(int body, double length, double red, double green, double blue) {
        left[0] = red;
        left[1] = green;
        left[2] = blue;
        ledger.absorbed(red, green, blue);
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
    public void ended(Level level) {
        ledger.ended();
        if (--open == 0) {
            if (isDirectKnown) {
                directRed *= left[0];
                directGreen *= left[1];
                directBlue *= left[2];
            } else {
                keepDirect(level);
            }
        }
        Arrays.fill(left, 1);
    }

    private void keepDirect(Level level) {
        directRed = level.red;
        directGreen = level.green;
        directBlue = level.blue;
        isDirectKnown = true;
    }
}
