package cz.paprsek.shape.field;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.placed.InBox;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;

/**
 * Where a formula is below 0, within a box.
 *
 * <p>A stretch of a ray is left out if the formula cannot be 0 on it, by bounds of its values, or by its value in the middle and bounds of its slope.
 * Where the slope cannot be 0, it is 0 once if the ends differ, and that place is found by halves and secants. All other stretches are cut in the middle, the
 * nearer half first, down to a 2⁻⁴⁰th of what lies in the box. So no crossing is missed, but a pair of them that is nearer to each other than that. A
 * ray that lies in the surface, where nothing ever decides, is cut more coarsely after a thousand stretches, so that there are never many thousand and what comes behind is still found.
 *
 * @source Mitchell, Robust Ray Intersection with Interval Arithmetic, Graphics Interface 1990
 */
public final class Implicit extends InBox {
    /** The number of the surface. */
    public static final int SURFACE = 0;
    private static final int DEEPEST = 40;
    /** After so many stretches they are no more cut so finely, and after as many more coarsely: what is undecided that long is so all along. */
    private static final int MANY_STRETCHES = 1000;
    private static final int FINE = 20;
    private static final int COARSE = 10;
    private static final int MOST_STEPS = 100;
    private final Field field;

    /** Places it. */
    public Implicit(int part, Affine toWorld, Bounds box, Field field) {
        super(part, toWorld, box);
        this.field = field;
    }

    @Override
    public double cost() {
        return 20 + field.room();
    }

    @Override
    protected void look(Line line, Ray ray, double from, double enough, Spans out) {
        double low = ray.enter;
        double high = ray.leave;
        int leaveFace = ray.leaveFace;
        // From the middle of what lies in the box: the distance to it would take digits from the numbers there.
        double middle = (low + high) / 2;
        line.ox += middle * line.dx;
        line.oy += middle * line.dy;
        line.oz += middle * line.dz;
        double[] room = ray.room(1 + field.room());
        boolean isInside = value(line, from - middle, room) < 0;
        boolean isInsideAtEnd = value(line, high - middle, room) < 0;
        if (isInside) {
            out.add(low, part, ray.enterFace);
            if (low > enough) {
                return;
            }
        }
        room[field.room()] = 0;
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
        double passed = room[field.room()]++;
        boolean isCut = depth < (passed < MANY_STRETCHES ? DEEPEST : passed < 2 * MANY_STRETCHES ? FINE : COARSE);
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
            if (isCut && areAlike && reach < Double.POSITIVE_INFINITY) {
                int at = field.along(line, centre, centre, room);
                if (room[at] - reach * (1 + 1e-15) > 0 || room[at + 1] + reach * (1 + 1e-15) < 0) {
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
        if (describesSide(face, hit)) {
            return;
        }
        double px = toLocal.pointX(hit.px, hit.py, hit.pz);
        double py = toLocal.pointY(hit.px, hit.py, hit.pz);
        double pz = toLocal.pointZ(hit.px, hit.py, hit.pz);
        double[] room = hit.room(field.room());
        double x = slope(px, py, pz, 0, room);
        double y = slope(px, py, pz, 1, room);
        double z = slope(px, py, pz, 2, room);
        boolean isDirection = x * x + y * y + z * z > 0;
        hit.normal(toLocal, isDirection ? x : 0, isDirection ? y : 1, isDirection ? z : 0);
    }

    private double slope(double x, double y, double z, int axis, double[] room) {
        int bounds = field.at(x, y, z, axis, room);
        double slope = (room[bounds + 2] + room[bounds + 3]) / 2;
        if (Math.abs(slope) <= Double.MAX_VALUE) {
            return slope;
        }
        double step = 1e-6 * (box[3 + axis] - box[axis]);
        double above = field.value(x + (axis == 0 ? step : 0), y + (axis == 1 ? step : 0), z + (axis == 2 ? step : 0), room);
        double below = field.value(x - (axis == 0 ? step : 0), y - (axis == 1 ? step : 0), z - (axis == 2 ? step : 0), room);
        return (above - below) / (2 * step);
    }

    /** The surface as a globe about the middle of the box, its faces each once. */
    @Override
    public void map(int face, Hit hit) {
        double x = toLocal.pointX(hit.px, hit.py, hit.pz);
        double y = toLocal.pointY(hit.px, hit.py, hit.pz);
        double z = toLocal.pointZ(hit.px, hit.py, hit.pz);
        if (face == SURFACE) {
            globe(x - (box[0] + box[3]) / 2, y - (box[1] + box[4]) / 2, z - (box[2] + box[5]) / 2, hit);
        } else {
            mapSide(face, x, y, z, hit);
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
