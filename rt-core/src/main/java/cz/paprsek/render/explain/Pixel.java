package cz.paprsek.render.explain;

import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.math.Require;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.ScenePath;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
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

    /**
     * One pixel of a picture of paths: what its light is made of, by the ways that it came and by where it comes from.
     *
     * @param column from 0 at the left
     * @param row from 0 at the top
     * @param samples the light that each path brought, in the order in which they were traced
     * @param light the pixel's light; rounded to floats, exactly that of the picture
     * @param interval how far the value that is shown may be from the true one, 0 to 1; below 0 if that cannot be trusted, or of less than 64 paths is not known
     * @param ways what each class of paths brings, the brightest first; together the pixel's light
     * @param sources what comes from each light and from what else shines, the brightest first; together the pixel's light
     * @param examples paths as they are typical of the brightest classes
     * @param exposure in stops: each doubles the light that is shown
     * @param tone how light is fitted to a screen
     */
    public record PathPixel(int column, int row, List<LinearRgb> samples, LinearRgb light, double interval, List<Way> ways, List<Way> sources, List<Example> examples,
            double exposure, Tone tone) {
        public PathPixel {
            samples = List.copyOf(samples);
            Objects.requireNonNull(light, "light");
            ways = List.copyOf(ways);
            sources = List.copyOf(sources);
            examples = List.copyOf(examples);
            Objects.requireNonNull(tone, "tone");
            Require.that(!samples.isEmpty(), "a pixel needs at least one path");
        }

        /** Its light as it is shown: exposed and toned, linear. */
        public LinearRgb developed() {
            LinearRgb exposed = light.times(StrictMath.pow(2, exposure));
            return new LinearRgb(tone.of(exposed.red()), tone.of(exposed.green()), tone.of(exposed.blue()));
        }

        /** Which share of the pixel's light a part of it is, by what eyes find bright; 0 of a black pixel. */
        public double share(LinearRgb part) {
            double all = luminance(light);
            return all > 0 ? luminance(part) / all : 0;
        }

        /** @source ITU-R BT.709 */
        private static double luminance(LinearRgb light) {
            return 0.2126 * light.red() + 0.7152 * light.green() + 0.0722 * light.blue();
        }

        /** What light begins with. */
        public enum Source { LIGHT, SURFACE, SKY, AMBIENT }

        /**
         * Light that came one way, as the surfaces say that it met.
         *
         * @param source what it begins with
         * @param shines the light, or the body that gives off light of its own; empty for the sky, the background, and ambient light
         * @param surfaces the objects that it met, from there to the eye; not that with which it begins
         * @param isShortened whether it met more surfaces between its source and the first of them, which are not told
         * @param paths how many paths brought any
         * @param light what the pixel gets of it
         * @param halfWidth how far that may be from the truth, with the confidence that is asked for; empty of less than 64 paths
         */
        public record Way(Source source, Optional<InScene<? extends ScenePath>> shines, List<InScene<? extends ScenePath>> surfaces, boolean isShortened, int paths, LinearRgb light,
                Optional<LinearRgb> halfWidth) {
            public Way {
                Objects.requireNonNull(source, "source");
                Objects.requireNonNull(shines, "shines");
                surfaces = List.copyOf(surfaces);
                Objects.requireNonNull(light, "light");
                Objects.requireNonNull(halfWidth, "halfWidth");
            }
        }

        /**
         * A path that is typical of a class: of those that brought light that way, one whose light is near to their mean.
         *
         * @param way number of the class among {@link PathPixel#ways}, from 0
         * @param sample number of the path, from 0
         * @param ray the path from the eye on, with the light that it brought all in all
         * @param brought what of it came this way
         */
        public record Example(int way, int sample, TracedRay ray, LinearRgb brought) {
            public Example {
                Objects.requireNonNull(ray, "ray");
                Objects.requireNonNull(brought, "brought");
            }
        }
    }
}
