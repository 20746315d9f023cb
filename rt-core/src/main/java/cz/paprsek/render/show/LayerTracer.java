package cz.paprsek.render.show;

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
    /** Of each sample, the number of the object it meets. */
    private final int[] objects;
    private final double[] normal = new double[3];
    private final double[] left = new double[3];
    private double distance;
    private int met;
    /** How many rays' accounts are open: that of the eye's is the first. */
    private int open;
    /** Of the sample at hand. */
    private int object;
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
        objects = new int[sampling.most()];
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
        Arrays.fill(normal, 0);
        distance = 0;
        met = 0;
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
        object = 0;
        albedoRed = 0;
        albedoGreen = 0;
        albedoBlue = 0;
        isDirectKnown = false;
        Arrays.fill(left, 1);
        traceAlone(eye, x, y, number);
        Level level = alone();
        boolean isSeen = object > 0 || !transparent;
        objects[number] = object;
        light.add(isSeen ? level.red : 0, isSeen ? level.green : 0, isSeen ? level.blue : 0, level.isNegative);
        double share = object > 0 ? 1 : 0;
        cover.add(share, share, share, level.isNegative);
        albedo.add(albedoRed, albedoGreen, albedoBlue, level.isNegative);
        direct.add(isSeen ? directRed : 0, isSeen ? directGreen : 0, isSeen ? directBlue : 0, level.isNegative);
    }

    private void expose(int x, int y, Film film) {
        albedo.mean();
        direct.mean();
        double k = 1.0 / Math.max(1, met);
        int plane = 0;
        for (Layer layer : layers) {
            switch (layer) {
                case NORMAL -> set(film, plane, x, y, k * normal[0], k * normal[1], k * normal[2]);
                case ALBEDO -> set(film, plane, x, y, albedo.red, albedo.green, albedo.blue);
                case DEPTH -> film.setPlane(plane, x, y, k * distance);
                case OBJECT -> film.setPlane(plane, x, y, mostFrequent());
                case DIRECT -> set(film, plane, x, y, direct.red, direct.green, direct.blue);
                case INDIRECT -> set(film, plane, x, y, Math.max(0, light.red - direct.red), Math.max(0, light.green - direct.green), Math.max(0, light.blue - direct.blue));
                case SAMPLES -> film.setPlane(plane, x, y, light.count());
            }
            plane += layer.planes().size();
        }
    }

    private static void set(Film film, int plane, int x, int y, double first, double second, double third) {
        film.setPlane(plane, x, y, first);
        film.setPlane(plane + 1, x, y, second);
        film.setPlane(plane + 2, x, y, third);
    }

    /** Of the objects that the samples meet, the one that most do; of several the first in the scene. */
    private int mostFrequent() {
        Arrays.sort(objects, 0, light.count());
        int most = 0;
        int winner = 0;
        int run = 0;
        for (int i = 0; i < light.count(); i++) {
            run = i > 0 && objects[i] == objects[i - 1] ? run + 1 : 1;
            if (run > most) {
                most = run;
                winner = objects[i];
            }
        }
        return winner;
    }

    @Override
    public void met(Level level) {
        if (open++ == 0) {
            note(level, scene.parts().object(level.ray.part));
            double diffusion = scene.parts().finish(level.ray.part).diffusion;
            albedoRed = diffusion * level.colorRed;
            albedoGreen = diffusion * level.colorGreen;
            albedoBlue = diffusion * level.colorBlue;
        }
    }

    private void note(Level level, int number) {
        object = number + 1;
        normal[0] += level.hit.sx;
        normal[1] += level.hit.sy;
        normal[2] += level.hit.sz;
        distance += level.ray.max;
        met++;
    }

    @Override
    public void following(boolean refracted, double red, double green, double blue) {
        if (open == 1 && !isDirectKnown) {
            keepDirect(alone());
        }
    }

    @Override
    public void missed(Level level) {
        endOfAll(level);
    }

    /** Bodies of lights are bodies like others; the disc of a sun is sky. */
    @Override
    public void seen(Level level, int lamp) {
        if (open == 0 && Double.isFinite(level.ray.max)) {
            note(level, scene.scene().objects().size() + lamp);
        }
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
    }

    @Override
    public void ended(Level level) {
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
