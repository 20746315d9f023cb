package cz.paprsek.shape.placed;

import cz.paprsek.math.Vec3;
import java.util.Optional;

/** A solid as placed in the world. What it must know is {@link #spans}; a primitive may answer the rest faster. */
public abstract class Volume extends Surface {
    /**
     * Pushes the boundaries of the stretches of the ray's whole line inside the solid, sorted, entering and leaving in turn.
     * Stretches that do not reach between the ray's min and max may be left out. Of a primitive that the ray starts from, the boundary it
     * starts at counts as lying far behind.
     */
    public abstract void spans(Ray ray, Spans out);

    /**
     * Combines the boundaries of another solid, pushed from {@code left} on, with its own.
     *
     * @param out holds these boundaries, and takes those of the combination in their place
     */
    public void combine(Combination operation, int left, Ray ray, Spans out) {
        int right = out.size();
        spans(ray, out);
        out.combine(operation, left, right, ray.scale);
    }

    /** This, if the first boundary that a ray meets can be told without all others. */
    public Optional<Carved> carved() {
        return Optional.empty();
    }

    @Override
    public void nearest(Ray ray) {
        Spans spans = ray.spans;
        int mark = spans.size();
        spans(ray, spans);
        int i = mark;
        while (i < spans.size() && spans.t(i) <= ray.min) {
            i++;
        }
        if (i < spans.size() && spans.t(i) < ray.reach) {
            ray.accept(spans.t(i), spans.part(i), spans.face(i));
        }
        spans.release(mark);
    }

    @Override
    public boolean occludes(Ray ray) {
        return occludesByAll(ray);
    }

    final boolean occludesByAll(Ray ray) {
        Spans spans = ray.spans;
        int mark = spans.size();
        spans(ray, spans);
        boolean found = false;
        for (int i = mark; i < spans.size(); i++) {
            found |= spans.t(i) > ray.contact && spans.t(i) < ray.max;
        }
        spans.release(mark);
        return found;
    }

    @Override
    public void crossings(Ray ray, Spans out) {
        int mark = out.size();
        spans(ray, out);
        out.clip(mark, ray.min, ray.max);
    }

    @Override
    public boolean contains(Vec3 point) {
        if (!bounds().contains(point)) {
            return false;
        }
        Ray ray = new Ray(new Spans());
        ray.start(point.x(), point.y(), point.z(), 1, 0, 0);
        return holdsOrigin(ray);
    }

    /** Whether the ray's origin lies inside; the ray's min must be 0 and its max infinite. */
    public boolean holdsOrigin(Ray ray) {
        Spans spans = ray.spans;
        int mark = spans.size();
        spans(ray, spans);
        int before = 0;
        while (mark + before < spans.size() && spans.t(mark + before) <= 0) {
            before++;
        }
        spans.release(mark);
        return before % 2 != 0;
    }
}
