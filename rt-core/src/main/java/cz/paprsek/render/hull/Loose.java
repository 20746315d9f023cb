package cz.paprsek.render.hull;

import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.tree.Row;
import org.jspecify.annotations.Nullable;

/** A few bodies within walls, met as they come: boxes around them cost more. Immutable. */
public class Loose {
    private final Surface[] surfaces;
    private final boolean[] opaque;
    private final boolean areOpaque;

    /** @param opaque which of the bodies are */
    public Loose(Surface[] surfaces, boolean[] opaque) {
        this.surfaces = surfaces;
        this.opaque = opaque;
        boolean all = true;
        for (boolean one : opaque) {
            all &= one;
        }
        areOpaque = all;
    }

    /** Of one worker. */
    public static final class Scratch {
        final double[] halves = new double[Row.MOST];
        int rays;
    }

    /** Whether the worker's next ray is to meet them so, rather than as if in a tree. */
    public boolean take(Scratch scratch) {
        return true;
    }

    /** As how many leaves of a tree they count. */
    public int visits() {
        return 0;
    }

    /** As of a surface. */
    public void nearest(Ray ray, Scratch scratch) {
        for (Surface surface : surfaces) {
            surface.nearest(ray);
        }
    }

    /**
     * Looks for what stands between the ray's min and max.
     *
     * @param through receives the boundaries of transparent bodies; incomplete if the answer is not null
     * @return the first opaque body found, or null
     */
    public @Nullable Surface occluder(Ray ray, Spans through, Scratch scratch) {
        if (areOpaque) {
            for (Surface surface : surfaces) {
                if (surface.occludes(ray)) {
                    return surface;
                }
            }
            return null;
        }
        for (int i = 0; i < surfaces.length; i++) {
            if (blocks(surfaces[i], opaque[i], ray, through)) {
                return surfaces[i];
            }
        }
        return null;
    }

    /** Whether a body is opaque and stands in the way; the boundaries of one that is not are pushed. */
    public static boolean blocks(Surface surface, boolean isOpaque, Ray ray, Spans through) {
        if (isOpaque) {
            return surface.occludes(ray);
        }
        surface.crossings(ray, through);
        return false;
    }
}
