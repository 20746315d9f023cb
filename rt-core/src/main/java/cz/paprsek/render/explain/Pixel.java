package cz.paprsek.render.explain;

import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.math.Require;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;

/**
 * One pixel of a picture: its light is that of its rays, each times its weight.
 *
 * @param column from 0 at the left
 * @param row from 0 at the top
 * @param rays the rays from the eye; one, a regular grid row by row, or random ones
 * @param places where each ray goes through the pixel
 * @param weights of each ray: all the same, or one for those that the pixel's filter adds and one for those that it takes away
 * @param exposure in stops: each doubles the light that is shown
 * @param tone how light is fitted to a screen
 */
public record Pixel(int column, int row, List<TracedRay> rays, List<Place> places, List<Double> weights, double exposure, Tone tone) {
    /**
     * A point of the picture, in pixels from the top left corner of one: wide filters reach beyond it.
     *
     * @param x to the right
     * @param y downwards
     */
    public record Place(double x, double y) {}

    public Pixel {
        Objects.requireNonNull(tone, "tone");
        rays = List.copyOf(rays);
        places = List.copyOf(places);
        weights = List.copyOf(weights);
        Require.that(!rays.isEmpty(), "a pixel needs at least one ray");
        Require.that(places.size() == rays.size(), "a pixel's rays need a place each");
        Require.that(weights.size() == rays.size() && weights.stream().distinct().count() <= 2, "a pixel's rays need a weight each, of two at most");
    }

    /** Which of its rays, counted from 0, brings the light that is nearest to the pixel's; of several the first. */
    public int typical() {
        LinearRgb light = light();
        return IntStream.range(0, rays.size()).boxed().min(Comparator.comparingDouble(i -> rays.get(i).light().distance(light))).orElseThrow();
    }

    /** Whether its filter takes the light of some rays away. */
    public boolean isSharpened() {
        return weights.stream().distinct().count() > 1;
    }

    /** The pixel's light; rounded to floats, exactly that of the picture. Rays of one weight are summed first; less than no light is none. */
    public LinearRgb light() {
        LinearRgb all = weights.stream().distinct().map(this::light).reduce(LinearRgb::plus).orElseThrow();
        return isSharpened() ? new LinearRgb(Math.max(0, all.red()), Math.max(0, all.green()), Math.max(0, all.blue())) : all;
    }

    /** Its light as it is shown: exposed and toned, linear. */
    public LinearRgb developed() {
        LinearRgb exposed = light().times(StrictMath.pow(2, exposure));
        return new LinearRgb(tone.of(exposed.red()), tone.of(exposed.green()), tone.of(exposed.blue()));
    }

    /** Whether it is shown otherwise than it is. */
    public boolean isDeveloped() {
        return exposure != 0 || tone != Tone.NONE;
    }

    private LinearRgb light(double weight) {
        LinearRgb sum = LinearRgb.BLACK;
        for (int i = 0; i < rays.size(); i++) {
            if (weights.get(i) == weight) {
                sum = sum.plus(rays.get(i).light());
            }
        }
        return sum.times(weight);
    }
}
