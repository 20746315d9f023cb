package cz.paprsek.shape.outline;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;

/**
 * An outline in the plane z = 0, moved up to z = height, where it is so many times as large and has been turned.
 *
 * <p>Untwisted, a ray is a straight line in the plane of the outline, seen from where all its copies meet: (x, y)/(1 + (taper − 1)·z/height).
 * That line is crossed with the outline once, exactly. Twisted, it is a curve there, followed in chords of {@value #STEP} degrees that are halved
 * wherever an end and the crossings between disagree: only what a ray cuts off a corner between two of them can be lost, 1/3000 of the radius deep.
 */
public final class Extruded extends Volume implements Part {
    /** The number of the face at z = 0; that at the other end has the next. */
    public static final int BOTTOM = 0;
    /** The numbers of the sides begin here, two for each piece. */
    public static final int FIRST_SIDE = 2;
    private static final double STEP = 3;
    private static final int MOST_HALVINGS = 20;
    private static final int MOST_STEPS = 40;

    private final int part;
    private final Affine toLocal;
    private final Bounds worldBounds;
    private final Bounds box;
    private final Outline outline;
    private final double height;
    /** How fast it grows with z, and how fast it turns, in radians. */
    private final double growth;
    private final double turning;

    /**
     * Places it.
     *
     * @param box around it in its own space
     * @param twist in degrees, from +x to +y
     * @param taper how large the other end is; 0 for a point
     */
    public Extruded(int part, Affine toWorld, Bounds box, Outline outline, double height, double twist, double taper) {
        this.part = part;
        this.box = box;
        this.outline = outline;
        this.height = height;
        toLocal = toWorld.inverse();
        worldBounds = box.transformed(toWorld);
        growth = (taper - 1) / height;
        turning = twist * Math.PI / 180 / height;
    }

    @Override
    public Bounds bounds() {
        return worldBounds;
    }

    @Override
    public double cost() {
        return 5 + outline.count() * (turning == 0 ? 0.5 : 20);
    }

    @Override
    public void spans(Ray ray, Spans out) {
        Line line = ray.in(toLocal);
        double low = Math.max(Math.max(first(line.ox, line.dx, box.minX(), box.maxX()), first(line.oy, line.dy, box.minY(), box.maxY())),
                first(line.oz, line.dz, 0, height));
        double high = Math.min(Math.min(last(line.ox, line.dx, box.minX(), box.maxX()), last(line.oy, line.dy, box.minY(), box.maxY())),
                last(line.oz, line.dz, 0, height));
        if (!(low < high)) {
            return;
        }
        // From the middle of what lies in the box: large numbers would lose small outlines far away.
        double middle = (low + high) / 2;
        line.ox += middle * line.dx;
        line.oy += middle * line.dy;
        line.oz += middle * line.dz;
        line.clear();
        int mark = out.size();
        if (turning == 0) {
            straight(line, middle, first(line.oz, line.dz, 0, height), last(line.oz, line.dz, 0, height), out);
        } else {
            twisted(line, middle, low - middle, high - middle, out);
        }
        if (part == ray.left) {
            out.leaveFrom(mark, ray.inwards);
        }
    }

    static double first(double o, double d, double low, double high) {
        double at = d > 0 ? (low - o) / d : (high - o) / d;
        return d != 0 && !Double.isNaN(at) ? at : o >= low && o <= high ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
    }

    static double last(double o, double d, double low, double high) {
        double at = d > 0 ? (high - o) / d : (low - o) / d;
        return d != 0 && !Double.isNaN(at) ? at : o >= low && o <= high ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
    }

    /** With o′ + t·d′ = (x, y, size) the ray in the plane is the line o′ × d′, and what lies w along it, b·x − a·y, is met at t = (s₀·w − p)/(q − s₁·w). */
    private void straight(Line line, double middle, double low, double high, Spans out) {
        double s0 = 1 + growth * line.oz;
        double s1 = growth * line.dz;
        double a = line.oy * s1 - s0 * line.dy;
        double b = s0 * line.dx - line.ox * s1;
        double c = line.ox * line.dy - line.oy * line.dx;
        if (a == 0 && b == 0) {
            // Along the sides, or through where they all meet.
            if (outline.contains(line.ox / s0, line.oy / s0, line)) {
                out.add(middle + low, part, line.dz > 0 ? BOTTOM : BOTTOM + 1);
                out.add(middle + high, part, line.dz > 0 ? BOTTOM + 1 : BOTTOM);
            }
            return;
        }
        outline.cross(a, b, c, 0, line);
        line.sort();
        outline.keepRims(line);
        double p = line.ox * b - line.oy * a;
        double q = line.dx * b - line.dy * a;
        int fromLid = line.dz > 0 ? BOTTOM : BOTTOM + 1;
        for (int i = 0; i + 1 < line.crossings(); i += 2) {
            double enter = along(line.t(i), s0, s1, p, q);
            double leave = along(line.t(i + 1), s0, s1, p, q);
            if (Math.max(enter, low) < Math.min(leave, high)) {
                out.add(middle + Math.max(enter, low), part, enter > low ? side(line.face(i), true) : fromLid);
                out.add(middle + Math.min(leave, high), part, leave < high ? side(line.face(i + 1), false) : BOTTOM + 1 - fromLid);
            }
        }
    }

    /** Beyond where the copies meet, what is ahead on the line comes first or last on the ray. */
    private static double along(double w, double s0, double s1, double p, double q) {
        double below = q - s1 * w;
        return below > 0 ? (s0 * w - p) / below : s1 > 0 ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
    }

    /** The number of a side, from that of a crossing: even if the solid lies to the left of the piece, (y′, −x′) leading out of it. */
    private static int side(int crossing, boolean isEntered) {
        boolean rises = crossing % 2 != 0;
        return FIRST_SIDE + (crossing & ~1) + (rises == isEntered ? 1 : 0);
    }

    private void twisted(Line line, double middle, double low, double high, Spans out) {
        double swept = Math.abs(turning * line.dz) * (high - low) * 180 / Math.PI;
        int steps = (int) Math.max(1, Math.min(10_000, Math.ceil(swept / STEP)));
        int mark = out.size();
        boolean isInside = holds(line, low);
        int fromLid = line.dz > 0 ? BOTTOM : BOTTOM + 1;
        if (isInside) {
            out.add(middle + low, part, fromLid);
        }
        double from = low;
        for (int i = 1; i <= steps; i++) {
            double to = i == steps ? high : low + (high - low) * i / steps;
            boolean isInsideNext = holds(line, to);
            follow(line, middle, from, to, isInside, isInsideNext, MOST_HALVINGS, out);
            from = to;
            isInside = isInsideNext;
        }
        if ((out.size() - mark) % 2 != 0) {
            out.add(middle + high, part, BOTTOM + 1 - fromLid);
        }
    }

    private boolean holds(Line line, double t) {
        double x = line.ox + t * line.dx;
        double y = line.oy + t * line.dy;
        double z = line.oz + t * line.dz;
        return outline.contains(inPlaneX(x, y, z), inPlaneY(x, y, z), line);
    }

    /** Adds the boundaries between two places of which it is known whether they lie inside. */
    private void follow(Line line, double middle, double from, double to, boolean isInside, boolean isInsideNext, int halvings, Spans out) {
        int count = chord(line, from, to);
        if (count == 0 && isInside == isInsideNext) {
            return;
        }
        if (count == 1 && isInside != isInsideNext) {
            refine(line, middle, from, to, isInside, out);
        } else if (halvings > 0) {
            double half = (from + to) / 2;
            boolean isInsideThere = holds(line, half);
            follow(line, middle, from, half, isInside, isInsideThere, halvings - 1, out);
            follow(line, middle, half, to, isInsideThere, isInsideNext, halvings - 1, out);
        } else if (isInside != isInsideNext) {
            out.add(middle + (from + to) / 2, part, side(count > 0 ? line.face(0) : 0, !isInside));
        }
    }

    /** Leaves with the line where the straight way between two places of the ray, in the plane, crosses the outline, from 0 to 1. */
    private int chord(Line line, double from, double to) {
        double x = line.ox + from * line.dx;
        double y = line.oy + from * line.dy;
        double z = line.oz + from * line.dz;
        double x0 = inPlaneX(x, y, z);
        double y0 = inPlaneY(x, y, z);
        x = line.ox + to * line.dx;
        y = line.oy + to * line.dy;
        z = line.oz + to * line.dz;
        double a = y0 - inPlaneY(x, y, z);
        double b = inPlaneX(x, y, z) - x0;
        double start = b * x0 - a * y0;
        double length = a * a + b * b;
        line.clear();
        outline.cross(a, b, -(a * x0 + b * y0), 0, line);
        int all = line.crossings();
        line.clear();
        for (int i = 0; i < all; i++) {
            double at = (line.t(i) - start) / length;
            if (at > 0 && at <= 1) {
                line.cross(at, line.face(i));
            }
        }
        return line.crossings();
    }

    private void refine(Line line, double middle, double from, double to, boolean isInside, Spans out) {
        double low = from;
        double high = to;
        double t = low;
        int face = line.face(0);
        for (int i = 0; i < MOST_STEPS; i++) {
            double next = low + line.t(0) * (high - low);
            if (Math.abs(next - t) <= 4e-16 * (Math.abs(middle) + Math.abs(next)) || !(next > low && next < high)) {
                t = next;
                break;
            }
            t = next;
            if (holds(line, t) == isInside) {
                low = t;
            } else {
                high = t;
            }
            if (chord(line, low, high) != 1) {
                break;
            }
            face = line.face(0);
        }
        out.add(middle + t, part, side(face, !isInside));
    }

    private double size(double z) {
        return Math.max(1e-300, 1 + growth * z);
    }

    /** Where a point lies in the outline at z = 0. */
    private double inPlaneX(double x, double y, double z) {
        return turning == 0 ? x / size(z) : (x * StrictMath.cos(turning * z) + y * StrictMath.sin(turning * z)) / size(z);
    }

    private double inPlaneY(double x, double y, double z) {
        return turning == 0 ? y / size(z) : (y * StrictMath.cos(turning * z) - x * StrictMath.sin(turning * z)) / size(z);
    }

    /**
     * With q the point in the plane, n the normal there, ω the turning and s the size, the normal is (R·n, −s·ω·n·(−q_y, q_x) − s′·n·q), R the
     * turn at z.
     */
    @Override
    public void describe(int face, Hit hit) {
        if (face < FIRST_SIDE) {
            hit.normal(toLocal, 0, 0, face == BOTTOM ? -1 : 1);
            return;
        }
        double x = toLocal.pointX(hit.px, hit.py, hit.pz);
        double y = toLocal.pointY(hit.px, hit.py, hit.pz);
        double z = toLocal.pointZ(hit.px, hit.py, hit.pz);
        double qx = inPlaneX(x, y, z);
        double qy = inPlaneY(x, y, z);
        Piece piece = outline.piece((face - FIRST_SIDE) / 2);
        double sign = face % 2 == 0 ? 1 : -1;
        double u = piece.parameter(qx, qy);
        if (piece.dx(u) == 0 && piece.dy(u) == 0) {
            // A curve may start at rest.
            u = u < 0.5 ? u + 1e-6 : u - 1e-6;
        }
        double nx = sign * piece.dy(u);
        double ny = -sign * piece.dx(u);
        double cos = turning == 0 ? 1 : StrictMath.cos(turning * z);
        double sin = turning == 0 ? 0 : StrictMath.sin(turning * z);
        double nz = -size(z) * turning * (ny * qx - nx * qy) - growth * (nx * qx + ny * qy);
        hit.normal(toLocal, nx * cos - ny * sin, nx * sin + ny * cos, nz);
    }

    /** Around each contour once, with v from one end to the other; the ends as the box around the outline. */
    @Override
    public void map(int face, Hit hit) {
        double x = toLocal.pointX(hit.px, hit.py, hit.pz);
        double y = toLocal.pointY(hit.px, hit.py, hit.pz);
        double z = toLocal.pointZ(hit.px, hit.py, hit.pz);
        double qx = inPlaneX(x, y, z);
        double qy = inPlaneY(x, y, z);
        double tx = face == BOTTOM ? -1 : 1;
        double ty = 0;
        double u = (qx - outline.minX()) / (outline.maxX() - outline.minX());
        double v = (qy - outline.minY()) / (outline.maxY() - outline.minY());
        if (face >= FIRST_SIDE) {
            int number = (face - FIRST_SIDE) / 2;
            Piece piece = outline.piece(number);
            double at = piece.parameter(qx, qy);
            double sign = face % 2 == 0 ? 1 : -1;
            tx = sign * piece.dx(at);
            ty = sign * piece.dy(at);
            double around = outline.around(number, at);
            u = sign > 0 == outline.isReversed(number) ? 1 - around : around;
            v = z / height;
        } else if (face == BOTTOM) {
            u = 1 - u;
        }
        double cos = turning == 0 ? 1 : StrictMath.cos(turning * z);
        double sin = turning == 0 ? 0 : StrictMath.sin(turning * z);
        hit.map(u, v, tx * cos - ty * sin, tx * sin + ty * cos, 0);
        hit.tangentFrom(toLocal);
    }
}
