package cz.paprsek.shape.outline;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * An outline, x the distance from the axis and y along it, turned about the y axis from +x towards −z. Straight pieces make cones, met exactly;
 * curves are cut into pieces that are at most 1/{@value #FINENESS} of the outline's size away, with the normals of the curve. Where a ray may cross
 * is worked out for each piece by itself; whether it enters or leaves there, by asking whether the middles between are inside.
 */
public final class Lathed extends Volume implements Part {
    private static final double FINENESS = 50_000;
    /** By how much a crossing may seem to lie beside its piece, relative to the numbers it is made of. */
    private static final double SLACK = 1e-12;

    private final int part;
    private final Affine toLocal;
    private final Bounds worldBounds;
    private final Bounds box;
    /** Of straight pieces only. */
    private final Outline outline;
    /** Of each piece, in fours, the normals of the curve at its ends. */
    private final double[] normals;
    /** Of each piece how far around its contour it begins and ends. */
    private final double[] arounds;
    private final double angle;
    private final double size;

    /**
     * Places it.
     *
     * @param box around it in its own space
     * @param angle in degrees, 360 for all around
     */
    public Lathed(int part, Affine toWorld, Bounds box, Outline curved, double angle) {
        this.part = part;
        this.box = box;
        this.angle = angle * Math.PI / 180;
        toLocal = toWorld.inverse();
        worldBounds = box.transformed(toWorld);
        size = Math.max(curved.maxX(), curved.maxY() - curved.minY());
        List<Piece> all = new ArrayList<>();
        List<double[]> ends = new ArrayList<>();
        for (int i = 0; i < curved.count(); i++) {
            Piece piece = curved.piece(i);
            double[] cuts = Outline.parameters(piece, tolerance(curved));
            for (int k = 0; k + 1 < cuts.length; k++) {
                boolean isLast = k + 2 == cuts.length;
                all.add(new Straight(k == 0 ? piece.x0 : piece.x(cuts[k]), k == 0 ? piece.y0 : piece.y(cuts[k]),
                        isLast ? piece.x1 : piece.x(cuts[k + 1]), isLast ? piece.y1 : piece.y(cuts[k + 1])));
                ends.add(new double[] {normalX(piece, cuts[k]), normalY(piece, cuts[k]), normalX(piece, cuts[k + 1]), normalY(piece, cuts[k + 1]),
                        curved.around(i, cuts[k]), curved.around(i, cuts[k + 1])});
            }
        }
        outline = Outline.of(all);
        normals = ends.stream().flatMapToDouble(one -> Arrays.stream(one, 0, 4)).toArray();
        arounds = ends.stream().flatMapToDouble(one -> Arrays.stream(one, 4, 6)).toArray();
    }

    /** How far curves may be from what is met. */
    public static double tolerance(Outline outline) {
        return Math.max(outline.maxX(), outline.maxY() - outline.minY()) / FINENESS;
    }

    private static double normalX(Piece piece, double u) {
        double x = piece.dx(u);
        double y = piece.dy(u);
        return x == 0 && y == 0 ? piece.y1 - piece.y0 : y / StrictMath.hypot(x, y);
    }

    private static double normalY(Piece piece, double u) {
        double x = piece.dx(u);
        double y = piece.dy(u);
        return x == 0 && y == 0 ? piece.x0 - piece.x1 : -x / StrictMath.hypot(x, y);
    }

    @Override
    public Bounds bounds() {
        return worldBounds;
    }

    @Override
    public double cost() {
        return 10 + outline.count();
    }

    @Override
    public void spans(Ray ray, Spans out) {
        Line line = ray.in(toLocal);
        double low = Math.max(Math.max(Extruded.first(line.ox, line.dx, box.minX(), box.maxX()), Extruded.first(line.oy, line.dy, box.minY(), box.maxY())),
                Extruded.first(line.oz, line.dz, box.minZ(), box.maxZ()));
        double high = Math.min(Math.min(Extruded.last(line.ox, line.dx, box.minX(), box.maxX()), Extruded.last(line.oy, line.dy, box.minY(), box.maxY())),
                Extruded.last(line.oz, line.dz, box.minZ(), box.maxZ()));
        if (!(low < high)) {
            return;
        }
        double middle = (low + high) / 2;
        line.ox += middle * line.dx;
        line.oy += middle * line.dy;
        line.oz += middle * line.dz;
        line.clear();
        candidates(line);
        line.sort();
        int mark = out.size();
        boolean isInside = false;
        int count = line.crossings();
        for (int i = 0; i < count; i++) {
            boolean isInsideNext = i + 1 < count && holds(line, (line.t(i) + line.t(i + 1)) / 2);
            if (isInside != isInsideNext) {
                out.add(middle + line.t(i), part, face(line, line.face(i), line.t(i), isInsideNext));
                isInside = isInsideNext;
            }
        }
        if (part == ray.left) {
            out.leaveFrom(mark, ray.inwards);
        }
    }

    /** Where the ray may cross a piece: the cones, x² + z² = (r + k·(y − y₀))², and the planes at either end of a turn that is not whole. */
    private void candidates(Line line) {
        double dd = line.dx * line.dx + line.dz * line.dz;
        double od = line.ox * line.dx + line.oz * line.dz;
        double oo = line.ox * line.ox + line.oz * line.oz;
        for (int i = 0; i < outline.count(); i++) {
            Piece piece = outline.piece(i);
            double rise = piece.y1 - piece.y0;
            if (rise == 0) {
                double t = (piece.y0 - line.oy) / line.dy;
                double square = oo + t * (2 * od + t * dd);
                double least = Math.min(piece.x0, piece.x1) - SLACK * size;
                double most = Math.max(piece.x0, piece.x1) + SLACK * size;
                if (square <= most * most && (least <= 0 || square >= least * least)) {
                    line.cross(t, i);
                }
                continue;
            }
            double slope = (piece.x1 - piece.x0) / rise;
            double w = piece.x0 + slope * (line.oy - piece.y0);
            double dw = slope * line.dy;
            double a = dd - dw * dw;
            double b = od - w * dw;
            double c = oo - w * w;
            double square = b * b - a * c;
            if (square >= 0) {
                double q = -(b + Math.copySign(Math.sqrt(square), b));
                candidate(line, q / a, piece, i, w, dw);
                candidate(line, c / q, piece, i, w, dw);
            }
        }
        if (angle < 2 * Math.PI) {
            double sin = StrictMath.sin(angle);
            double cos = StrictMath.cos(angle);
            plane(line, -line.oz / line.dz, outline.count());
            plane(line, -(line.ox * sin + line.oz * cos) / (line.dx * sin + line.dz * cos), outline.count() + 1);
        }
    }

    private void candidate(Line line, double t, Piece piece, int number, double w, double dw) {
        double y = line.oy + t * line.dy;
        double slack = SLACK * size;
        if (y >= Math.min(piece.y0, piece.y1) - slack && y <= Math.max(piece.y0, piece.y1) + slack && w + t * dw >= -slack) {
            line.cross(t, number);
        }
    }

    private static void plane(Line line, double t, int number) {
        if (Math.abs(t) <= Double.MAX_VALUE) {
            line.cross(t, number);
        }
    }

    private boolean holds(Line line, double t) {
        double x = line.ox + t * line.dx;
        double z = line.oz + t * line.dz;
        return outline.contains(Math.sqrt(x * x + z * z), line.oy + t * line.dy, line) && (angle >= 2 * Math.PI || turn(x, z) <= angle);
    }

    private static double turn(double x, double z) {
        double turn = StrictMath.atan2(-z, x);
        return turn < 0 ? turn + 2 * Math.PI : turn;
    }

    /** Twice the number of the piece, and one more if the solid lies to its right. */
    private int face(Line line, int piece, double t, boolean isEntered) {
        if (piece >= outline.count()) {
            return 2 * piece;
        }
        double x = line.ox + t * line.dx;
        double z = line.oz + t * line.dz;
        Piece straight = outline.piece(piece);
        double rho = Math.sqrt(x * x + z * z);
        double outwards = rho > 0 ? (straight.y1 - straight.y0) * (x * line.dx + z * line.dz) / rho : 0;
        double rate = outwards - (straight.x1 - straight.x0) * line.dy;
        return 2 * piece + (rate < 0 == isEntered ? 0 : 1);
    }

    @Override
    public void describe(int face, Hit hit) {
        double x = toLocal.pointX(hit.px, hit.py, hit.pz);
        double y = toLocal.pointY(hit.px, hit.py, hit.pz);
        double z = toLocal.pointZ(hit.px, hit.py, hit.pz);
        int number = face / 2;
        if (number == outline.count()) {
            hit.normal(toLocal, 0, 0, 1);
        } else if (number > outline.count()) {
            hit.normal(toLocal, -StrictMath.sin(angle), 0, -StrictMath.cos(angle));
        } else {
            double rho = Math.sqrt(x * x + z * z);
            double u = outline.piece(number).parameter(rho, y);
            double sign = face % 2 == 0 ? 1 : -1;
            double outwards = sign * (normals[4 * number] + u * (normals[4 * number + 2] - normals[4 * number]));
            double up = sign * (normals[4 * number + 1] + u * (normals[4 * number + 3] - normals[4 * number + 1]));
            hit.normal(toLocal, rho > 0 ? outwards * x / rho : outwards, up, rho > 0 ? outwards * z / rho : 0);
        }
    }

    /** As around a cylinder, with v the way along the contour; the ends of a turn as the box around the outline. */
    @Override
    public void map(int face, Hit hit) {
        double x = toLocal.pointX(hit.px, hit.py, hit.pz);
        double y = toLocal.pointY(hit.px, hit.py, hit.pz);
        double z = toLocal.pointZ(hit.px, hit.py, hit.pz);
        double rho = Math.sqrt(x * x + z * z);
        int number = face / 2;
        double across = (rho - outline.minX()) / (outline.maxX() - outline.minX());
        double up = (y - outline.minY()) / (outline.maxY() - outline.minY());
        if (number == outline.count()) {
            hit.map(across, up, 1, 0, 0);
        } else if (number > outline.count()) {
            hit.map(1 - across, up, -StrictMath.cos(angle), 0, StrictMath.sin(angle));
        } else {
            double u = outline.piece(number).parameter(rho, y);
            double around = arounds[2 * number] + u * (arounds[2 * number + 1] - arounds[2 * number]);
            boolean falls = arounds[2 * number + 1] < arounds[2 * number];
            hit.mapAround(x, z, face % 2 == 0 == falls ? 1 - around : around);
        }
        hit.tangentFrom(toLocal);
    }
}
