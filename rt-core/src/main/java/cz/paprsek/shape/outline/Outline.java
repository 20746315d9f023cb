package cz.paprsek.shape.outline;

import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Line;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * Closed contours of straight pieces, arcs of ellipses and Bézier curves in the plane. A point is inside if a line from there to far away crosses
 * them an odd number of times; of those of a letter, if they do not go around it as often in one direction as in the other.
 */
public final class Outline {
    /** The largest coordinate. */
    static final double LARGEST = 1e9;
    static final int MOST_PIECES = 20_000;
    private static final int FINE = 64;

    private final List<List<Piece>> contours;
    private final Piece[] pieces;
    private final boolean isWound;
    /** Of each piece, how far around its contour it begins, what share of that it is, and whether it runs the other way. */
    private final double[] starts;
    private final double[] shares;
    private final boolean[] isReversed;
    private final double minX;
    private final double minY;
    private final double maxX;
    private final double maxY;

    /**
     * Reads one.
     *
     * @param what has it, for messages: {@code extrude}
     * @param path as SVG has it, or empty
     * @param points corners, or empty
     * @throws IllegalArgumentException with one sentence if it is none
     */
    public static Outline of(String what, String path, String points) {
        Require.that(path.isBlank() != points.isBlank(), path.isBlank() ? what + " needs a path, or points" : what + " has either a path or points, not both; remove one of them");
        Outline outline = new Outline(path.isBlank() ? new PathReader(what, points).points() : new PathReader(what, path).path(), false);
        Require.that(outline.isArea(),
                what + (path.isBlank() ? " points" : " path") + " must enclose something, but is empty, a point or a line");
        Require.that(outline.pieces.length <= MOST_PIECES, what + " must have at most " + MOST_PIECES + " pieces, but has " + outline.pieces.length);
        return outline;
    }

    /** That of a letter, of lines and Bézier curves: where its contours lie over each other it is one. */
    public static Outline wound(String path) {
        return new Outline(new PathReader("letter", path).path(), true);
    }

    private Outline(List<List<Piece>> contours, boolean isWound) {
        this.contours = contours;
        this.isWound = isWound;
        pieces = contours.stream().flatMap(List::stream).toArray(Piece[]::new);
        starts = new double[pieces.length];
        shares = new double[pieces.length];
        isReversed = new boolean[pieces.length];
        int first = 0;
        for (List<Piece> contour : contours) {
            measure(contour, first);
            first += contour.size();
        }
        double[] box = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (Piece piece : pieces) {
            DoubleStream.concat(DoubleStream.of(0, 1), piece.turns()).forEach(u -> {
                box[0] = Math.min(box[0], end(piece, u, true));
                box[1] = Math.min(box[1], end(piece, u, false));
                box[2] = Math.max(box[2], end(piece, u, true));
                box[3] = Math.max(box[3], end(piece, u, false));
            });
        }
        minX = box[0];
        minY = box[1];
        maxX = box[2];
        maxY = box[3];
    }

    /** Pieces that are known to close, in any order. */
    static Outline of(List<Piece> pieces) {
        return new Outline(List.of(pieces), false);
    }

    /** A coordinate; at the ends that which the neighbours have. */
    private static double end(Piece piece, double u, boolean isX) {
        return u == 0 ? (isX ? piece.x0 : piece.y0) : u == 1 ? (isX ? piece.x1 : piece.y1) : isX ? piece.x(u) : piece.y(u);
    }

    private void measure(List<Piece> contour, int first) {
        double whole = 0;
        for (int i = 0; i < contour.size(); i++) {
            Piece piece = contour.get(i);
            isReversed[first + i] = piece.isBackward();
            starts[first + i] = whole;
            shares[first + i] = length(piece);
            whole += shares[first + i];
        }
        for (int i = first; i < first + contour.size(); i++) {
            starts[i] /= whole;
            shares[i] /= whole;
        }
    }

    private static double length(Piece piece) {
        return IntStream.range(0, FINE).mapToDouble(i -> StrictMath.hypot(piece.x((i + 1.0) / FINE) - piece.x((double) i / FINE),
                piece.y((i + 1.0) / FINE) - piece.y((double) i / FINE))).sum();
    }

    public double minX() {
        return minX;
    }

    public double minY() {
        return minY;
    }

    public double maxX() {
        return maxX;
    }

    public double maxY() {
        return maxY;
    }

    /** Whether it can enclose anything. */
    public boolean isArea() {
        return pieces.length > 1 && maxX > minX && maxY > minY && !contours.stream().allMatch(Outline::isFlat);
    }

    /** Whether it only goes to and fro along a line. */
    private static boolean isFlat(List<Piece> contour) {
        Piece longest = contour.stream().max(Comparator.comparingDouble(piece -> Math.abs(piece.x1 - piece.x0) + Math.abs(piece.y1 - piece.y0))).orElseThrow();
        return contour.stream().allMatch(piece -> piece instanceof Straight && (longest.x1 - longest.x0) * (piece.y1 - piece.y0) == (longest.y1 - longest.y0) * (piece.x1 - piece.x0));
    }

    /** How many pieces it has. */
    public int count() {
        return pieces.length;
    }

    Piece piece(int i) {
        return pieces[i];
    }

    /** How far around its contour a point of a piece lies, from 0 to 1. */
    double around(int piece, double u) {
        return starts[piece] + shares[piece] * (isReversed[piece] ? 1 - u : u);
    }

    boolean isReversed(int piece) {
        return isReversed[piece];
    }

    /** Notes where a line crosses it, unsorted; the faces of piece i are first + 2·i and the next. */
    void cross(double a, double b, double c, int first, Line out) {
        for (int i = 0; i < pieces.length; i++) {
            pieces[i].cross(a, b, c, first + 2 * i, out);
        }
    }

    /** Keeps of a line's crossings, which are in their order, those where it goes in or out. */
    void keepRims(Line line) {
        if (!isWound) {
            return;
        }
        int all = line.crossings();
        line.clear();
        int wound = 0;
        for (int i = 0; i < all; i++) {
            int next = wound + turn(line.face(i));
            if (wound == 0 || next == 0) {
                line.cross(line.t(i), line.face(i));
            }
            wound = next;
        }
    }

    /** Which way round a contour goes whose crossing has this number. */
    private static int turn(int face) {
        return face % 2 != 0 ? 1 : -1;
    }

    /** Whether a point lies inside. What the line has crossed stays as it is. */
    boolean contains(double x, double y, Line room) {
        if (!(x >= minX && x <= maxX && y >= minY && y <= maxY)) {
            return false;
        }
        int mark = room.crossings();
        cross(0, 1, -y, 0, room);
        int right = 0;
        int wound = 0;
        for (int i = mark; i < room.crossings(); i++) {
            boolean isRight = room.t(i) > x;
            right += isRight ? 1 : 0;
            wound += isRight ? turn(room.face(i)) : 0;
        }
        room.keep(mark);
        return isWound ? wound != 0 : right % 2 != 0;
    }

    /**
     * The contours as closed polygons whose corners lie on them.
     *
     * @param tolerance how far curves may be from them
     * @return of each contour its corners, the first one again at the end; z is 0
     */
    public List<List<Vec3>> polygons(double tolerance) {
        List<List<Vec3>> all = new ArrayList<>();
        int i = 0;
        for (List<Piece> contour : contours) {
            List<Vec3> corners = new ArrayList<>();
            for (Piece piece : contour) {
                double[] parameters = parameters(piece, tolerance);
                for (int k = 0; k + 1 < parameters.length; k++) {
                    double u = parameters[isReversed[i] ? parameters.length - 1 - k : k];
                    corners.add(new Vec3(end(piece, u, true), end(piece, u, false), 0));
                }
                i++;
            }
            corners.add(corners.get(0));
            all.add(corners);
        }
        return all;
    }

    /** Whether there are only lines. */
    public boolean isStraight() {
        return Arrays.stream(pieces).allMatch(Straight.class::isInstance);
    }

    /** All contours as cubic Bézier curves, four points each, those of one contour after the other; arcs in several, which are off by less than 1e-7 of their radius. */
    public List<Vec3> curves() {
        List<Vec3> points = new ArrayList<>();
        for (Piece piece : pieces) {
            double[] controls = piece.controls();
            for (int i = 0; i < controls.length; i += 2) {
                points.add(new Vec3(controls[i], controls[i + 1], 0));
            }
        }
        return points;
    }

    /** Where a piece is cut to be straight within a tolerance, from 0 to 1. */
    static double[] parameters(Piece piece, double tolerance) {
        if (piece instanceof Straight) {
            return new double[] {0, 1};
        }
        int steps = 2;
        while (steps < 2048 && bulge(piece, steps) > tolerance) {
            steps *= 2;
        }
        int parts = steps;
        return DoubleStream.concat(IntStream.rangeClosed(0, parts).mapToDouble(i -> (double) i / parts), piece.turns()).sorted().distinct().toArray();
    }

    private static double bulge(Piece piece, int steps) {
        double most = 0;
        for (int i = 0; i < steps; i++) {
            double from = (double) i / steps;
            double to = (i + 1.0) / steps;
            double middle = (from + to) / 2;
            most = Math.max(most, StrictMath.hypot(piece.x(middle) - (piece.x(from) + piece.x(to)) / 2, piece.y(middle) - (piece.y(from) + piece.y(to)) / 2));
        }
        return most;
    }
}
