package cz.paprsek.render.hull;

import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/** Bodies without end: every ray meets them. Immutable. */
public final class Endless {
    private final Surface[] surfaces;
    private final boolean[] opaque;
    private final int[] order;

    /**
     * Some of many bodies.
     *
     * @param order their numbers, rising
     */
    public Endless(Surface[] all, boolean[] allOpaque, int[] order) {
        this.order = order;
        surfaces = Arrays.stream(order).mapToObj(i -> all[i]).toArray(Surface[]::new);
        opaque = new boolean[order.length];
        for (int i = 0; i < order.length; i++) {
            opaque[i] = allOpaque[order[i]];
        }
    }

    private Endless(Endless all, int[] kept) {
        order = Arrays.stream(kept).map(i -> all.order[i]).toArray();
        surfaces = Arrays.stream(kept).mapToObj(i -> all.surfaces[i]).toArray(Surface[]::new);
        opaque = new boolean[kept.length];
        for (int i = 0; i < kept.length; i++) {
            opaque[i] = all.opaque[kept[i]];
        }
    }

    /** Without those that are not kept. */
    public Endless only(IntPredicate isKept) {
        return new Endless(this, IntStream.range(0, order.length).filter(i -> isKept.test(order[i])).toArray());
    }

    /** Whether there are none. */
    public boolean isNone() {
        return surfaces.length == 0;
    }

    /** As of a surface. */
    public void nearest(Ray ray) {
        for (Surface surface : surfaces) {
            surface.nearest(ray);
        }
    }

    /** As of a surface. */
    public void crossings(Ray ray, Spans out) {
        for (Surface surface : surfaces) {
            surface.crossings(ray, out);
        }
    }

    /**
     * Looks for what stands between the ray's min and max.
     *
     * @param through receives the boundaries of transparent bodies; incomplete if the answer is not null
     * @return the first opaque body found, or null
     */
    public @Nullable Surface occluder(Ray ray, Spans through) {
        for (int i = 0; i < surfaces.length; i++) {
            if (Loose.blocks(surfaces[i], opaque[i], ray, through)) {
                return surfaces[i];
            }
        }
        return null;
    }
}
