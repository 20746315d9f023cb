package cz.paprsek.shape.placed;

import java.util.Optional;

/** A primitive that every line meets in one stretch at most. */
public abstract class Convex extends Volume implements Part {
    final int part;

    protected Convex(int part) {
        this.part = part;
    }

    /** Finds the stretch of the line inside and sets the ray's enter, leave and their faces; false if there is none. */
    protected abstract boolean clip(Ray ray);

    /** As {@link #clip}, but of a ray that starts on the surface only what follows: the far side if it starts inwards, else nothing. */
    final boolean meets(Ray ray) {
        if (part != ray.left) {
            return clip(ray);
        }
        if (!ray.inwards || !clip(ray)) {
            return false;
        }
        ray.enter = Double.NEGATIVE_INFINITY;
        ray.leave = Math.max(ray.leave, 0);
        return true;
    }

    /** Writes middle and squared radius of a ball around it, larger by more than rounding; the radius is infinite if none is known. */
    protected void putAround(double[] into, int at) {
        into[at + 3] = Double.POSITIVE_INFINITY;
    }

    @Override
    public final Optional<Carved> carved() {
        return Optional.of(Carved.of(this));
    }

    @Override
    public void spans(Ray ray, Spans out) {
        if (meets(ray) && ray.enter < ray.reach && ray.leave > ray.min) {
            push(ray, out);
        }
    }

    @Override
    public void combine(Combination operation, int left, Ray ray, Spans out) {
        boolean isMet = meets(ray) && ray.enter < ray.reach && ray.leave > ray.min;
        if (!isMet || !out.combine(operation, left, ray.enter, ray.enterFace, ray.leave, ray.leaveFace, part, ray.scale)) {
            int right = out.size();
            if (isMet) {
                push(ray, out);
            }
            out.combine(operation, left, right, ray.scale);
        }
    }

    private void push(Ray ray, Spans out) {
        out.add(ray.enter, part, ray.enterFace);
        out.add(ray.leave, part, ray.leaveFace);
    }

    @Override
    public void nearest(Ray ray) {
        if (!meets(ray)) {
            return;
        }
        if (ray.enter > ray.min) {
            if (ray.enter < ray.reach) {
                ray.accept(ray.enter, part, ray.enterFace);
            }
        } else if (ray.leave > ray.min && ray.leave < ray.reach) {
            ray.accept(ray.leave, part, ray.leaveFace);
        }
    }

    @Override
    public boolean occludes(Ray ray) {
        return meets(ray)
                && ((ray.enter > ray.contact && ray.enter < ray.max) || (ray.leave > ray.contact && ray.leave < ray.max));
    }

    /** Narrows the ray's stretch to [enter, leave]; whether anything is left. */
    protected static boolean narrow(Ray ray, double enter, int enterFace, double leave, int leaveFace) {
        if (enter > ray.enter) {
            ray.enter = enter;
            ray.enterFace = enterFace;
        }
        if (leave < ray.leave) {
            ray.leave = leave;
            ray.leaveFace = leaveFace;
        }
        return ray.enter < ray.leave;
    }
}
