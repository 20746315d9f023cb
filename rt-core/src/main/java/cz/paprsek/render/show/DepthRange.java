package cz.paprsek.render.show;

import cz.paprsek.material.Rgb;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.integrate.Whitted;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.World;
import java.util.Arrays;

/** The distances that the eye sees in a picture, by which depths become brightnesses. */
public record DepthRange(double nearest, double farthest) {
    /** For pictures that show no depths. */
    public static final DepthRange NONE = new DepthRange(0, 0);

    /** Rays along each side of the picture that are asked for their distance: a coarse grid is enough for a good contrast. */
    private static final int GRID = 64;
    /** A plain that goes on to the horizon would leave all before it in one white: what is so many times as far as half of all that is seen is told apart no more. */
    private static final double FAR = 3;
    /** What nothing but the background is darker than, as an sRGB channel. */
    private static final double DARKEST = 25;

    /** Looks through a grid of points all over the picture. */
    public static DepthRange of(World scene, Eye eye, int width, int height) {
        Whitted tracer = new Whitted(scene, 1, Sampling.grid(1));
        double[] seen = new double[GRID * GRID];
        int count = 0;
        for (int row = 0; row < GRID; row++) {
            for (int column = 0; column < GRID; column++) {
                tracer.startAlone(eye, (column + 0.5) * width / GRID, (row + 0.5) * height / GRID);
                tracer.findAlone();
                if (tracer.alone().ray.part >= 0) {
                    seen[count++] = tracer.alone().ray.max;
                }
            }
        }
        if (count == 0) {
            return NONE;
        }
        Arrays.sort(seen, 0, count);
        return new DepthRange(seen[0], Math.min(seen[count - 1], FAR * seen[count / 2]));
    }

    /** Light that is encoded as 255 where it is nearest, falling evenly with the distance. */
    public double brightness(double distance) {
        double share = farthest > nearest ? (farthest - distance) / (farthest - nearest) : 1;
        return Rgb.linear(DARKEST + (255 - DARKEST) * Math.min(1, Math.max(0, share)));
    }
}
