package cz.paprsek.shape.placed;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;

/** A shape as placed in the world, ready to be hit: the render half of a {@link cz.paprsek.shape.Shape}. Immutable. */
public abstract class Surface {
    /** The box around it, world space; may be unbounded. */
    public abstract Bounds bounds();

    /** About how long it takes to meet a ray, in units of what a sphere takes. */
    public double cost() {
        return 1;
    }

    /** Lowers the ray's max to the first boundary between its min and max, and notes what was hit, if there is one. The one it starts at is none. */
    public abstract void nearest(Ray ray);

    /** Whether there is a boundary between the end of what the ray's start touches and its max. */
    public abstract boolean occludes(Ray ray);

    /** Pushes every boundary between the ray's min and max. */
    public abstract void crossings(Ray ray, Spans out);

    /** Whether a point of the world lies inside; never in what has no inside. Not for the hot path: it allocates. */
    public boolean contains(Vec3 point) {
        return false;
    }
}
