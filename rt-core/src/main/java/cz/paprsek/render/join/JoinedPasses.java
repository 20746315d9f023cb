package cz.paprsek.render.join;

import cz.paprsek.image.Image;
import cz.paprsek.math.Require;
import cz.paprsek.render.sample.PassSums;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import java.util.Objects;

/**
 * A picture of paths that is put together of its passes, each of which was made by itself: to the same bytes as if they had been made one after the other. For pictures of light
 * alone, without layers, opacity or judging. A pass is made by itself if a {@link cz.paprsek.render.TileStore} tells, of each pixel, the number of the paths before it, and no sums.
 */
public final class JoinedPasses {
    private final int size;
    private final PassSums own;
    private final PassSums next;
    private final float[] kept;
    /** By rows. */
    private final float[][] sums;

    /** None yet. */
    public JoinedPasses(int width, int height, PixelFilter filter) {
        Image.requireRoom(width, height);
        Passes passes = passes(filter);
        size = passes.kept();
        own = passes.newSums();
        next = passes.newSums();
        kept = new float[size];
        sums = new float[height][size * width];
    }

    private static Passes passes(PixelFilter filter) {
        return new Passes(RenderSettings.DEFAULT.withIntegrator(Integrator.PATH).withFilter(Objects.requireNonNull(filter, "filter")), false);
    }

    /** How many numbers are kept of each pixel: those of the film from {@link cz.paprsek.render.RenderOptions#keptFrom} on. */
    public static int size(PixelFilter filter) {
        return passes(filter).kept();
    }

    /**
     * Adds the next pass of a pixel.
     *
     * @param numbers what was kept of it
     */
    public void add(int x, int y, float[] numbers) {
        Objects.requireNonNull(numbers, "numbers");
        Require.that(numbers.length == size, size + " numbers are kept of a pixel, not " + numbers.length);
        load(x, y);
        next.load(numbers, 0);
        own.join(next);
        own.save(kept, 0);
        System.arraycopy(kept, 0, sums[y], size * x, size);
    }

    private void load(int x, int y) {
        copy(x, y, kept);
        own.load(kept, 0);
    }

    /** What is kept of the passes of a pixel so far: as if one machine had made them. */
    void copy(int x, int y, float[] into) {
        System.arraycopy(sums[y], size * x, into, 0, size);
    }

    /** Puts a pixel to which all passes have been added on an image. */
    public void develop(int x, int y, Image into) {
        Objects.requireNonNull(into, "into");
        load(x, y);
        own.mean();
        into.set(x, y, own.red, own.green, own.blue);
    }
}
