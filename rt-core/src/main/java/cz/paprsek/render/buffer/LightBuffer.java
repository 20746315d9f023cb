package cz.paprsek.render.buffer;

import cz.paprsek.render.hull.Loose;
import cz.paprsek.shape.placed.Balls;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import org.jspecify.annotations.Nullable;

/**
 * Which bodies can stand in the way of a light that comes from one place: a grid over what would be seen from there, each cell of which knows the bodies that it shows, the nearest to the light first. A
 * shadow ray stays within one cell, and asks those of them that begin nearer to the light than it does; they are a few, where a search through a tree goes through many boxes. Immutable.
 *
 * @source Haines and Greenberg, The Light Buffer: A Shadow-Testing Accelerator, IEEE Computer Graphics and Applications 6(9), 1986
 */
public final class LightBuffer {
    /** By so much farther from the light than a ray starts bodies are asked, which is more than rounding does. */
    private static final double FARTHER = 1 + 1e-6;

    private final Surface[] surfaces;
    private final Balls balls;
    private final boolean[] opaque;
    private final LightView view;
    private final LightGrid grid;
    private final int[] starts;
    private final int[] entries;
    /** Those that are too large for the grid: asked by every ray. */
    private final int[] large;

    LightBuffer(Surface[] surfaces, Balls balls, boolean[] opaque, LightView view, LightGrid grid, LightCells cells, int[] large) {
        this.surfaces = surfaces;
        this.balls = balls;
        this.opaque = opaque;
        this.view = view;
        this.grid = grid;
        this.starts = cells.starts;
        this.entries = cells.entries;
        this.large = large;
    }

    /** Whether it knows what stands in the way of a shadow ray: unless that starts so far out that rounding might take it into another cell. */
    public boolean knows(Ray ray) {
        return ray.scale < grid.farthest;
    }

    /**
     * Looks for what stands between the min and max of a ray that leads to the light.
     *
     * @param through receives the boundaries of transparent bodies; incomplete if the answer is not null
     * @return the first opaque body found, or null
     */
    public @Nullable Surface occluder(Ray ray, Spans through) {
        for (int i : large) {
            if (balls.mayBeMet(i, ray) && Loose.blocks(surfaces[i], opaque[i], ray, through)) {
                return surfaces[i];
            }
        }
        double x = ray.ox - view.x;
        double y = ray.oy - view.y;
        double z = ray.oz - view.z;
        double along = x * view.wx + y * view.wy + z * view.wz;
        double factor = view.factor(along);
        double u = ((x * view.ux + y * view.uy + z * view.uz) * factor - grid.minU) * grid.perU;
        double v = ((x * view.vx + y * view.vy + z * view.vz) * factor - grid.minV) * grid.perV;
        if (!(along > 0 && u >= 0 && u < grid.size && v >= 0 && v < grid.size)) {
            return null;
        }
        int cell = ((int) v) * grid.size + (int) u;
        int reach = Float.floatToRawIntBits((float) (((view.isFar ? along : ray.max) + 2 * ray.contact) * FARTHER));
        for (int at = 2 * starts[cell], end = 2 * starts[cell + 1]; at < end && entries[at + 1] <= reach; at += 2) {
            int i = entries[at];
            if (balls.mayBeMet(i, ray) && Loose.blocks(surfaces[i], opaque[i], ray, through)) {
                return surfaces[i];
            }
        }
        return null;
    }
}
