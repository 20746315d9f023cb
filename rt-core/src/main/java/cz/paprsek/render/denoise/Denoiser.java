package cz.paprsek.render.denoise;

import cz.paprsek.image.Image;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.show.Guides;
import cz.paprsek.render.work.Workers;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * Takes the noise out of a picture of paths. Each pixel becomes what a plane says that is laid through its neighbours: light as a linear function of their colours, normals and
 * distances, and of their place. Neighbours count as far as noise may explain how they differ from the pixel, of which the paths' own variances tell. The paths are taken as two
 * halves: of each, the other half says which neighbours count, and how good what was found is; so of several ways that with the least error is chosen, pixel by pixel.
 * What was found first then says anew, with less noise, which neighbours count, and planes are laid once more.
 *
 * @source Rousselle, Knaus and Zwicker, 2012, and Bitterli et al., 2016, as cited in {@link Likeness} and {@link Fit}
 */
public final class Denoiser {
    /** How many numbers of a pixel it works with: light and spread of both halves, guides twice, doubts, what is found twice, and the first guess. */
    public static final int NUMBERS = 70;

    /** The names of what is known of each pixel before it begins. */
    public static final List<String> PLANES = IntStream.range(0, Noisy.planes(Guides.COUNT)).mapToObj(i -> "noise." + i).toList();

    /** How many variances neighbours may be from the pixel, in each way: the one keeps faint edges, the other is smooth. */
    private static final float[] BY_NOISE = {0.4f, 1.5f};
    private static final float[] BY_GUESS = {0.5f, 3};
    /** How far around two pixels is compared: farther where there is more noise. */
    private static final int AROUND_NOISE = 2;
    private static final int AROUND_GUESS = 1;

    private final Film film;
    private final Image image;
    private final Passes paths;
    private final int kept;
    private final BooleanSupplier stop;

    /**
     * Of a picture that is whole.
     *
     * @param image what becomes of the film
     * @param kept how many numbers of a pixel are kept: the sums of its light first, its guides last
     */
    public Denoiser(Film film, Image image, Passes paths, int kept, BooleanSupplier stop) {
        this.film = Objects.requireNonNull(film, "film");
        this.image = Objects.requireNonNull(image, "image");
        this.paths = Objects.requireNonNull(paths, "paths");
        this.kept = kept;
        this.stop = Objects.requireNonNull(stop, "stop");
    }

    /** Changes the image; false if the calling thread was interrupted, or all is to stop. */
    public boolean run(Workers workers, int threads) {
        Noisy noisy = new Noisy(image.width(), image.height(), Guides.COUNT);
        return gather(noisy, workers, threads) && clean(noisy, image, workers, threads, stop);
    }

    private boolean gather(Noisy noisy, Workers workers, int threads) {
        return Stage.run(workers, threads, noisy, () -> new Gathering(film, paths, kept, noisy), stop);
    }

    /** What there is to know of the noise, as the {@link #PLANES}; empty if the calling thread was interrupted, or all is to stop. */
    public Optional<List<float[]>> tell(Workers workers, int threads) {
        Noisy noisy = new Noisy(image.width(), image.height(), Guides.COUNT);
        return gather(noisy, workers, threads) ? Optional.of(noisy.planes()) : Optional.empty();
    }

    /**
     * Takes the noise out of an image that has been put together; false as {@link #run}.
     *
     * @param told what its parts {@linkplain #tell told}, as the {@link #PLANES}
     */
    public static boolean run(Image image, List<float[]> told, Workers workers, int threads, BooleanSupplier stop) {
        return clean(new Noisy(image.width(), image.height(), Guides.COUNT, told), image, workers, threads, stop);
    }

    /** Puts into an image what is left of a noisy one without its noise; false as {@link #run}. */
    static boolean clean(Noisy noisy, Image image, Workers workers, int threads, BooleanSupplier stop) {
        Noisy calm = new Noisy(noisy);
        Noisy guess = new Noisy(noisy.width, noisy.height, 0);
        Found first = new Found(BY_NOISE.length, noisy.width, noisy.height);
        Found second = new Found(BY_GUESS.length, noisy.width, noisy.height);
        return Stage.run(workers, threads, noisy, () -> new Calming(noisy, calm), stop)
                && Stage.run(workers, threads, noisy, () -> new Fitting(calm, calm, AROUND_NOISE, BY_NOISE, first), stop)
                && Stage.run(workers, threads, noisy, () -> new Choosing(calm, first, guess::setLight), stop)
                && Stage.run(workers, threads, noisy, () -> new Guessing(calm, guess), stop)
                && Stage.run(workers, threads, noisy, () -> new Fitting(calm, guess, AROUND_GUESS, BY_GUESS, second), stop)
                && Stage.run(workers, threads, noisy, () -> new Choosing(calm, second.and(first), (x, y, halves) -> show(image, x, y, halves)), stop);
    }

    private static void show(Image image, int x, int y, double[][] halves) {
        double red = Math.max(0, (halves[0][0] + halves[1][0]) / 2);
        double green = Math.max(0, (halves[0][1] + halves[1][1]) / 2);
        double blue = Math.max(0, (halves[0][2] + halves[1][2]) / 2);
        if (!(red + green + blue <= Float.MAX_VALUE)) {
            // Lights so bright that their squares are not numbers: the pixel stays as it was traced.
            return;
        }
        if (image.isTransparent()) {
            image.set(x, y, red, green, blue, image.alpha(x, y));
        } else {
            image.set(x, y, red, green, blue);
        }
    }
}
