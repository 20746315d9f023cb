package cz.paprsek.shape.placed;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;

/**
 * A body that its box closes: what lies of a line in the box is looked through from its beginning, as far as it is needed. The faces of the box have the
 * numbers 1 to 6, −x, +x, −y and so on; all others are its own.
 */
public abstract class InBox extends Volume implements Part {
    /** From where rays start on it, it is looked for behind them so far, as a share of what lies in the box. */
    private static final double BEHIND = 1e-3;

    protected final int part;
    protected final Affine toLocal;
    /** Least x, y and z, then the greatest, own space. */
    protected final double[] box;
    private final Bounds worldBounds;

    protected InBox(int part, Affine toWorld, Bounds box) {
        this.part = part;
        this.box = new double[] {box.minX(), box.minY(), box.minZ(), box.maxX(), box.maxY(), box.maxZ()};
        toLocal = toWorld.inverse();
        worldBounds = box.transformed(toWorld);
    }

    /**
     * Pushes the boundaries of a line from a place in the box on, in rising order: if the body holds that place, first where the line comes into the box,
     * and if it holds the end, last where it leaves it. Both are in the ray's {@code enter} and {@code leave}, with the faces.
     *
     * @param line own space
     * @param ray whose line it is
     * @param from where to begin
     * @param enough no more boundaries are wanted than the first one beyond this
     */
    protected abstract void look(Line line, Ray ray, double from, double enough, Spans out);

    @Override
    public final Bounds bounds() {
        return worldBounds;
    }

    @Override
    public final void spans(Ray ray, Spans out) {
        int mark = out.size();
        look(ray, out, Double.POSITIVE_INFINITY);
        if (part == ray.left) {
            out.leaveFrom(mark, ray.inwards);
        }
    }

    @Override
    public final void nearest(Ray ray) {
        if (part == ray.left) {
            super.nearest(ray);
            return;
        }
        Spans spans = ray.spans;
        int mark = spans.size();
        look(ray, spans, ray.min);
        int last = spans.size() - 1;
        for (int i = mark; i <= last; i++) {
            if (spans.t(i) > ray.min && spans.t(i) < ray.reach) {
                ray.accept(spans.t(i), spans.part(i), spans.face(i));
                break;
            }
        }
        spans.release(mark);
    }

    @Override
    public final boolean occludes(Ray ray) {
        if (part == ray.left) {
            return super.occludes(ray);
        }
        Spans spans = ray.spans;
        int mark = spans.size();
        look(ray, spans, ray.contact);
        boolean found = false;
        for (int i = mark; i < spans.size(); i++) {
            found |= spans.t(i) > ray.contact && spans.t(i) < ray.max;
        }
        spans.release(mark);
        return found;
    }

    private void look(Ray ray, Spans out, double enough) {
        Line line = ray.in(toLocal);
        double low = Double.NEGATIVE_INFINITY;
        double high = Double.POSITIVE_INFINITY;
        int enterFace = 1;
        int leaveFace = 1;
        for (int axis = 0; axis < 3; axis++) {
            double o = axis == 0 ? line.ox : axis == 1 ? line.oy : line.oz;
            double d = axis == 0 ? line.dx : axis == 1 ? line.dy : line.dz;
            if (d == 0) {
                if (!(o >= box[axis] && o <= box[3 + axis])) {
                    return;
                }
                continue;
            }
            double first = ((d > 0 ? box[axis] : box[3 + axis]) - o) / d;
            double last = ((d > 0 ? box[3 + axis] : box[axis]) - o) / d;
            if (first > low) {
                low = first;
                enterFace = 1 + 2 * axis + (d > 0 ? 0 : 1);
            }
            if (last < high) {
                high = last;
                leaveFace = 1 + 2 * axis + (d > 0 ? 1 : 0);
            }
        }
        if (!(low < high)) {
            return;
        }
        double from = Math.max(low, part == ray.left ? -BEHIND * (high - low) : Math.min(0, ray.min));
        // To the end, wherever the ray stops: the last digits of a crossing must not hang on what else has been met.
        if (from < high) {
            ray.enter = low;
            ray.leave = high;
            ray.enterFace = enterFace;
            ray.leaveFace = leaveFace;
            look(line, ray, from, enough, out);
        }
    }

    /** Describes a hit on a face of the box; false if the face is none. */
    protected final boolean describesSide(int face, Hit hit) {
        if (face < 1 || face > 6) {
            return false;
        }
        int axis = (face - 1) / 2;
        double sign = face % 2 == 0 ? 1 : -1;
        hit.normal(toLocal, axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0);
        return true;
    }

    /**
     * Maps a hit on a face of the box, which has the whole picture, but for the tangent's way to the world.
     *
     * @param x where the hit is, own space
     */
    protected final void mapSide(int face, double x, double y, double z, Hit hit) {
        double u = (x - box[0]) / (box[3] - box[0]);
        double v = (y - box[1]) / (box[4] - box[1]);
        double w = (z - box[2]) / (box[5] - box[2]);
        switch (face) {
            case 1 -> hit.map(w, v, 0, 0, 1);
            case 2 -> hit.map(1 - w, v, 0, 0, -1);
            case 3 -> hit.map(u, w, 1, 0, 0);
            case 4 -> hit.map(u, 1 - w, 1, 0, 0);
            case 5 -> hit.map(1 - u, v, -1, 0, 0);
            default -> hit.map(u, v, 1, 0, 0);
        }
    }
}
