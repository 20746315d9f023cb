package cz.paprsek.render.join;

import cz.paprsek.image.Image;
import cz.paprsek.math.Require;
import cz.paprsek.render.denoise.Denoiser;
import cz.paprsek.render.work.Workers;
import java.util.List;
import java.util.Objects;
import java.util.function.BooleanSupplier;

/** What {@linkplain cz.paprsek.render.RenderOptions#ofPart parts} of a picture tell of its noise, which is taken out when they have been put together. */
public final class JoinedNoise {
    private JoinedNoise() {}

    /** Whether a plane is one of those that tell of noise. */
    public static boolean has(String plane) {
        return Denoiser.PLANES.contains(Objects.requireNonNull(plane, "plane"));
    }

    /** Whether those of some planes that tell of noise are all there are, in their order, behind all others; or none of them does. */
    public static boolean areWhole(List<String> planes) {
        Objects.requireNonNull(planes, "planes");
        long others = planes.stream().filter(plane -> !has(plane)).count();
        return others == planes.size() || planes.subList((int) others, planes.size()).equals(Denoiser.PLANES);
    }

    /**
     * Takes it out: to the last bit as if the picture had been rendered as a whole.
     *
     * @param image is changed
     * @param told on the planes of noise, in their order, row by row from the top left
     * @param threads how many workers, 1–1024
     * @param stop is asked again and again whether nobody wants it any more
     * @return false if it was stopped half-way, or the calling thread was interrupted, which it stays
     * @throws IllegalArgumentException if that is not as many planes of as many numbers as there must be
     */
    public static boolean takeOut(Image image, List<float[]> told, int threads, BooleanSupplier stop) {
        Objects.requireNonNull(image, "image");
        Objects.requireNonNull(stop, "stop");
        Require.within("threads", threads, 1, 1024);
        Require.that(told.size() == Denoiser.PLANES.size() && told.stream().allMatch(plane -> plane.length == image.width() * image.height()),
                "noise is told on " + Denoiser.PLANES.size() + " planes of as many numbers as there are pixels");
        try (Workers workers = new Workers("paprsek-denoise")) {
            return Denoiser.run(image, told, workers, threads, stop);
        }
    }
}
