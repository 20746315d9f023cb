package cz.paprsek.shape.field;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;

/**
 * Where a formula is below 0, within a box.
 *
 * <p>A stretch of a ray is left out if the formula cannot be 0 on it, by bounds of its values, or by its value in the middle and bounds of its slope.
 * Where the slope cannot be 0, it is 0 once if the ends differ, and that place is found by halves and secants. All other stretches are cut in the middle, the
 * nearer half first, down to a 2⁻⁴⁰th of what lies in the box. So no crossing is missed, but a pair of them that is nearer to each other than that; and a
 * ray that lies in the surface, where nothing ever decides, is given up after {@value #MOST_STRETCHES} stretches.
 *
 * @source Mitchell, Robust Ray Intersection with Interval Arithmetic, Graphics Interface 1990
 */
public final class Implicit extends Volume implements Part {
    /** The number of the surface; the faces of the box have the next ones, −x, +x, −y and so on. */
    public static final int SURFACE = 0;
    private static final int DEEPEST = 40;
    private static final int MOST_STRETCHES = 20_000;
    private static final int MOST_STEPS = 100;
    /** From where rays start on it, it is looked for behind them so far, as a share of what lies in the box. */
    private static final double BEHIND = 1e-3;

    private final int part;
    private final Affine toLocal;
    private final Bounds worldBounds;
    private final double[] box;
    private final Field field;

    /** Places it. */
    public Implicit(int part, Affine toWorld, Bounds box, Field field) {
        this.part = part;
        this.box = new double[] {box.minX(), box.minY(), box.minZ(), box.maxX(), box.maxY(), box.maxZ()};
        this.field = field;
        toLocal = toWorld.inverse();
        worldBounds = box.transformed(toWorld);
    }

    @Override
    public Bounds bounds() {
        return worldBounds;
    }

    @Override
    public double cost() {
        return 20 + field.room();
    }

    @Override
    public void spans(Ray ray, Spans out) {
        int mark = out.size();
        look(ray, out, Double.POSITIVE_INFINITY);
        if (part == ray.left) {
            out.leaveFrom(mark, ray.inwards);
        }
    }

    @Override
    public void nearest(Ray ray) {
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
    public boolean occludes(Ray ray) {
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

    /**
     * Pushes the boundaries.
     *
     * @param enough no more are wanted than the first one beyond this
     */
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
        if (!(from < high)) {
            return;
        }
        // From the middle of what lies in the box: the distance to it would take digits from the numbers there.
        double middle = (low + high) / 2;
        line.ox += middle * line.dx;
        line.oy += middle * line.dy;
        line.oz += middle * line.dz;
        double[] room = ray.room(1 + field.room());
        boolean isInside = value(line, from - middle, room) < 0;
        boolean isInsideAtEnd = value(line, high - middle, room) < 0;
        if (isInside) {
            out.add(low, part, enterFace);
            if (low > enough) {
                return;
            }
        }
        room[field.room()] = MOST_STRETCHES;
        boolean isEnough = search(line, from - middle, high - middle, isInside, isInsideAtEnd, 0, middle, enough, room, out);
        if (isInsideAtEnd && !isEnough) {
            out.add(high, part, leaveFace);
        }
    }

    private double value(Line line, double t, double[] room) {
        return field.value(line.ox + t * line.dx, line.oy + t * line.dy, line.oz + t * line.dz, room);
    }

    /**
     * Pushes the boundaries within a stretch of which both ends are known.
     *
     * @return whether there are enough
     */
    private boolean search(Line line, double from, double to, boolean isInside, boolean isInsideAtEnd, int depth, double middle, double enough, double[] room, Spans out) {
        double half = (to - from) / 2;
        double centre = from + half;
        boolean isCut = depth < DEEPEST && --room[field.room()] > 0;
        if (isCut) {
            int bounds = field.along(line, from, to, room);
            double least = room[bounds];
            double most = room[bounds + 1];
            double slowest = room[bounds + 2];
            double fastest = room[bounds + 3];
            // What is no number at an end is outside, and not within the bounds.
            boolean areAlike = isInside == isInsideAtEnd;
            if (areAlike && (least >= 0 || most < 0 || Double.isNaN(least))) {
                return false;
            }
            isCut = !(slowest > 0 || fastest < 0);
            double reach = Math.max(-slowest, fastest) * half;
            if (isCut && reach < Double.POSITIVE_INFINITY) {
                int at = field.along(line, centre, centre, room);
                if (areAlike && (room[at] - reach * (1 + 1e-15) > 0 || room[at + 1] + reach * (1 + 1e-15) < 0)) {
                    return false;
                }
            }
        }
        if (isCut) {
            boolean isInsideThere = value(line, centre, room) < 0;
            return search(line, from, centre, isInside, isInsideThere, depth + 1, middle, enough, room, out)
                    || search(line, centre, to, isInsideThere, isInsideAtEnd, depth + 1, middle, enough, room, out);
        }
        if (isInside == isInsideAtEnd) {
            return false;
        }
        double t = middle + crossing(line, from, to, isInside, room);
        out.add(t, part, SURFACE);
        return t > enough;
    }

    /** Where the sign changes, by secants of which the end that stays counts half (Illinois), and by halves wherever these are slow. */
    private double crossing(Line line, double from, double to, boolean isInside, double[] room) {
        double low = from;
        double high = to;
        double atLow = value(line, low, room);
        double atHigh = value(line, high, room);
        double t = low;
        for (int i = 0; i < MOST_STEPS; i++) {
            double width = high - low;
            double next = i % 4 == 3 ? low + width / 2 : low - atLow * width / (atHigh - atLow);
            next = next > low && next < high ? next : low + width / 2;
            if (!(next > low && next < high) || Math.abs(next - t) <= 1e-16 * (Math.abs(next) + width)) {
                return next;
            }
            t = next;
            double value = value(line, t, room);
            if (value < 0 == isInside) {
                low = t;
                atLow = value;
                atHigh /= 2;
            } else {
                high = t;
                atHigh = value;
                atLow /= 2;
            }
            if (value == 0) {
                return t;
            }
        }
        return t;
    }

    /** The slopes along the axes, by lines through the point; where the surface is bent, in the middle between both sides. */
    @Override
    public void describe(int face, Hit hit) {
        if (face != SURFACE) {
            int axis = (face - 1) / 2;
            double sign = face % 2 == 0 ? 1 : -1;
            hit.normal(toLocal, axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0);
            return;
        }
        double[] at = {toLocal.pointX(hit.px, hit.py, hit.pz), toLocal.pointY(hit.px, hit.py, hit.pz), toLocal.pointZ(hit.px, hit.py, hit.pz), 0, 0, 0};
        System.arraycopy(at, 0, at, 3, 3);
        double[] room = field.newRoom();
        double x = slope(at, 0, room);
        double y = slope(at, 1, room);
        double z = slope(at, 2, room);
        boolean isDirection = x * x + y * y + z * z > 0;
        hit.normal(toLocal, isDirection ? x : 0, isDirection ? y : 1, isDirection ? z : 0);
    }

    private double slope(double[] at, int axis, double[] room) {
        int bounds = field.within(at, axis, room);
        double slope = (room[bounds + 2] + room[bounds + 3]) / 2;
        if (Math.abs(slope) <= Double.MAX_VALUE) {
            return slope;
        }
        double step = 1e-6 * (box[3 + axis] - box[axis]);
        double above = field.value(at[0] + (axis == 0 ? step : 0), at[1] + (axis == 1 ? step : 0), at[2] + (axis == 2 ? step : 0), room);
        double below = field.value(at[0] - (axis == 0 ? step : 0), at[1] - (axis == 1 ? step : 0), at[2] - (axis == 2 ? step : 0), room);
        return (above - below) / (2 * step);
    }

    /** The surface as a globe about the middle of the box, its faces each once. */
    @Override
    public void map(int face, Hit hit) {
        double x = toLocal.pointX(hit.px, hit.py, hit.pz);
        double y = toLocal.pointY(hit.px, hit.py, hit.pz);
        double z = toLocal.pointZ(hit.px, hit.py, hit.pz);
        double u = (x - box[0]) / (box[3] - box[0]);
        double v = (y - box[1]) / (box[4] - box[1]);
        double w = (z - box[2]) / (box[5] - box[2]);
        switch (face) {
            case SURFACE -> globe(x - (box[0] + box[3]) / 2, y - (box[1] + box[4]) / 2, z - (box[2] + box[5]) / 2, hit);
            case 1 -> hit.map(w, v, 0, 0, 1);
            case 2 -> hit.map(1 - w, v, 0, 0, -1);
            case 3 -> hit.map(u, w, 1, 0, 0);
            case 4 -> hit.map(u, 1 - w, 1, 0, 0);
            case 5 -> hit.map(1 - u, v, -1, 0, 0);
            default -> hit.map(u, v, 1, 0, 0);
        }
        hit.tangentFrom(toLocal);
    }

    /** Along the surface v does not grow where its direction from the middle changes as on the globe. */
    private void globe(double x, double y, double z, Hit hit) {
        hit.mapGlobe(x, y, z);
        // The normal in the space of the body, of any length: its map is the transpose's inverse of the points'.
        Affine back = toLocal.inverse();
        double nx = back.xx() * hit.nx + back.yx() * hit.ny + back.zx() * hit.nz;
        double ny = back.xy() * hit.nx + back.yy() * hit.ny + back.zy() * hit.nz;
        double nz = back.xz() * hit.nx + back.yz() * hit.ny + back.zz() * hit.nz;
        double a = -(hit.tx * nx + hit.ty * ny + hit.tz * nz) / (x * nx + y * ny + z * nz);
        if (Math.abs(a) < Double.MAX_VALUE) {
            hit.map(hit.u, hit.v, hit.tx + a * x, hit.ty + a * y, hit.tz + a * z);
        }
    }
}
