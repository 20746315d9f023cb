package cz.paprsek.render.show;

import cz.paprsek.material.Rgb;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.integrate.Witness;
import cz.paprsek.render.light.Lamp;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import java.util.Arrays;

/** Sums what a mode other than shaded shows of a pixel's rays. Scratch of one worker. */
final class Sight extends Witness {
    final boolean numbers;
    private final World scene;
    private final RenderMode mode;
    private final DepthRange range;
    private final double[] all = new double[3];
    private final double[] arrived = new double[3];
    /** What substances leave of the light that is told next. */
    private final double[] left = {1, 1, 1};
    private double red;
    private double green;
    private double blue;
    private int seen;

    /** @param numbers whether distances are shown as they are */
    Sight(World scene, RenderMode mode, DepthRange range, boolean numbers) {
        this.scene = scene;
        this.mode = mode;
        this.range = range;
        this.numbers = numbers;
        for (Lamp lamp : scene.lamps()) {
            all[0] += lamp.red();
            all[1] += lamp.green();
            all[2] += lamp.blue();
        }
    }

    /** Begins a pixel. */
    void clear() {
        red = 0;
        green = 0;
        blue = 0;
        seen = 0;
    }

    /** Makes the level's light what so many rays come to. */
    void show(int samples, Level level) {
        if (numbers && mode == RenderMode.DEPTH) {
            // A distance that is partly of nothing is none.
            double distance = red / Math.max(1, seen);
            level.light(distance, distance, distance);
        } else {
            double k = 1.0 / samples;
            level.light(k * red, k * green, k * blue);
        }
    }

    /** A ray from the eye has been traced. */
    void endRay() {
        if (mode == RenderMode.SHADOWS) {
            add(share(0), share(1), share(2));
            Arrays.fill(arrived, 0);
        }
    }

    private double share(int channel) {
        return all[channel] > 0 ? arrived[channel] / all[channel] : 0;
    }

    @Override
    public void met(Level level) {
        shape(level, scene.index(scene.parts().object(level.ray.part)));
    }

    private void shape(Level level, int object) {
        Hit hit = level.hit;
        switch (mode) {
            case NORMALS -> add(encoded(hit.sx), encoded(hit.sy), encoded(hit.sz));
            case UV -> {
                scene.map(level);
                add(NumberedCells.color(hit.u, hit.v));
            }
            case DEPTH -> {
                double shown = numbers ? level.ray.max : range.brightness(level.ray.max);
                add(shown, shown, shown);
            }
            case OBJECTS -> add(ObjectColors.of(object));
            case SHADED, RAYS, NODES, SAMPLES, ERROR, SHADOWS -> {
                // What these show is known when the pixel is done.
            }
        }
    }

    /** Lights that are seen are bodies like others, but show no light that falls on them. */
    @Override
    public void seen(Level level, int lamp) {
        if (Double.isFinite(level.ray.max)) {
            shape(level, scene.scene().objects().size() + lamp);
        }
    }

    @Override
    public void dimmed(double red, double green, double blue) {
        left[0] = red;
        left[1] = green;
        left[2] = blue;
    }

    @Override
    public void sought(int lamp, Arrival arrival, double facing, double visibility) {
        if (mode == RenderMode.SHADOWS) {
            Lamp light = scene.lamps()[lamp];
            double share = visibility / light.samples();
            arrived[0] += share * left[0] * light.red();
            arrived[1] += share * left[1] * light.green();
            arrived[2] += share * left[2] * light.blue();
            Arrays.fill(left, 1);
        }
    }

    private void add(Rgb color) {
        add(color.linearRed(), color.linearGreen(), color.linearBlue());
    }

    private void add(double r, double g, double b) {
        seen++;
        red += r;
        green += g;
        blue += b;
    }

    /** A component of a normal, −1 to 1, as light that is encoded as 0–255. */
    private static double encoded(double component) {
        return Rgb.linear(Math.min(255, Math.max(0, 127.5 * (component + 1))));
    }
}
