package cz.paprsek.drawing;

import cz.paprsek.math.Vec3;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.scene.Camera;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/** The world as a camera sees it, on a picture of a given size: drawn by the {@link Eye} that also makes the rays. */
public final class CameraView {
    /** Lines end where they are this much nearer to the eye's plane than the farther of their ends. */
    private static final double NEAR = 1e-4;
    /** Of how many straight pieces a curve is made. */
    private static final int PIECES = 48;

    private final Eye eye;
    private final double longest;

    /**
     * @param width of the picture, in any unit, above 0
     * @param height of the picture, in the same unit, above 0
     */
    public CameraView(Camera camera, double width, double height) {
        Objects.requireNonNull(camera, "camera");
        eye = Eye.of(camera, width, height);
        // No curve that is seen as one goes farther from one of its pieces to the next: it has left the picture on one side and come back on the other.
        longest = Math.min(width, height) / 2;
    }

    /**
     * The ray through a point of the picture, and through the middle of a lens: where it starts, and a point of it.
     *
     * @param distance of that point, along the view; along the ray where straight lines are curves
     * @return two points; none where the picture shows nothing
     */
    public List<Vec3> ray(double x, double y, double distance) {
        Ray ray = new Ray(new Spans());
        if (!eye.start(ray, x, y)) {
            return List.of();
        }
        Vec3 start = new Vec3(ray.ox, ray.oy, ray.oz);
        Vec3 direction = new Vec3(ray.dx, ray.dy, ray.dz);
        double ahead = eye.keepsLines() ? eye.depth(start.plus(direction)) : 1;
        return List.of(start, start.plus(direction.times(distance / ahead)));
    }

    /** What the picture shows of a line: nothing, one straight piece, or many where straight lines are curves. */
    public List<Segment> line(Vec3 from, Vec3 to) {
        return eye.keepsLines() ? straight(from, to) : curve(from, to);
    }

    /** Only what is before the eye. */
    private List<Segment> straight(Vec3 from, Vec3 to) {
        double fromDepth = eye.depth(from);
        double toDepth = eye.depth(to);
        double near = NEAR * Math.max(fromDepth, toDepth);
        if (near <= 0) {
            return List.of();
        }
        Vec3 begin = fromDepth < near ? between(from, to, (near - fromDepth) / (toDepth - fromDepth)) : from;
        Vec3 end = toDepth < near ? between(from, to, (near - fromDepth) / (toDepth - fromDepth)) : to;
        double[] a = new double[2];
        double[] b = new double[2];
        return eye.project(begin, a) && eye.project(end, b) ? List.of(new Segment(a[0], a[1], b[0], b[1])) : List.of();
    }

    private List<Segment> curve(Vec3 from, Vec3 to) {
        List<Segment> pieces = new ArrayList<>(PIECES);
        double[] last = new double[2];
        double[] next = new double[2];
        boolean wasSeen = eye.project(from, last);
        for (int i = 1; i <= PIECES; i++) {
            boolean isSeen = eye.project(between(from, to, (double) i / PIECES), next);
            Segment piece = new Segment(last[0], last[1], next[0], next[1]);
            if (wasSeen && isSeen && piece.length() < longest) {
                pieces.add(piece);
            }
            wasSeen = isSeen;
            last = next.clone();
        }
        return pieces;
    }

    private static Vec3 between(Vec3 from, Vec3 to, double share) {
        return from.plus(to.minus(from).times(share));
    }
}
