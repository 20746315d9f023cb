package cz.paprsek.render.explain;

import cz.paprsek.math.Require;
import java.util.List;

/**
 * One pixel of a picture: its light is the average of that of its rays.
 *
 * @param column from 0 at the left
 * @param row from 0 at the top
 * @param rays the rays from the eye, row by row; one, or a regular grid
 */
public record Pixel(int column, int row, List<TracedRay> rays) {
    public Pixel {
        rays = List.copyOf(rays);
        Require.that(!rays.isEmpty(), "a pixel needs at least one ray");
    }

    /** The pixel's light; rounded to floats, exactly that of the picture. */
    public LinearRgb light() {
        LinearRgb sum = LinearRgb.BLACK;
        for (TracedRay ray : rays) {
            sum = sum.plus(ray.light());
        }
        return sum.times(1.0 / rays.size());
    }
}
