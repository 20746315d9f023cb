package cz.paprsek.render.hull;

import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.tree.Row;
import org.jspecify.annotations.Nullable;

/** A few bodies in any scene, of which a ray asks the balls around them all at once, and then meets those that it may. */
public final class Few extends Loose {
    /** Vectors are slow until they are compiled, which small pictures do not wait for. */
    private static final int MANY = 1 << 18;

    private final Surface[] surfaces;
    private final boolean[] opaque;
    private final Row row;

    /**
     * Bodies in a row.
     *
     * @param opaque which of them are
     * @param row the balls around them
     */
    public Few(Surface[] surfaces, boolean[] opaque, Row row) {
        super(surfaces, opaque);
        this.surfaces = surfaces;
        this.opaque = opaque;
        this.row = row;
    }

    @Override
    public boolean take(Scratch scratch) {
        return scratch.rays == MANY || ++scratch.rays == MANY;
    }

    /** As one leaf. */
    @Override
    public int visits() {
        return 1;
    }

    @Override
    public void nearest(Ray ray, Scratch scratch) {
        double[] halves = scratch.halves;
        row.ask(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, halves);
        for (int i = surfaces.length - 1; i >= 0; i--) {
            if (halves[i] > 0) {
                surfaces[i].nearest(ray);
            }
        }
    }

    @Override
    public @Nullable Surface occluder(Ray ray, Spans through, Scratch scratch) {
        double[] halves = scratch.halves;
        row.ask(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, halves);
        for (int i = surfaces.length - 1; i >= 0; i--) {
            if (halves[i] > 0 && blocks(surfaces[i], opaque[i], ray, through)) {
                return surfaces[i];
            }
        }
        return null;
    }
}
