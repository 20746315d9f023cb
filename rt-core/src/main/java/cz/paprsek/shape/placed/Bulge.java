package cz.paprsek.shape.placed;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Line;

/**
 * A convex body that a function tells: below 0 inside and above 0 outside, and convex along every line. From either end of the box around the
 * body Newton's method then leads to the surface without ever stepping over it, and away from it where a line passes by.
 */
public abstract class Bulge extends LocalConvex {
    /** Where a line touches, each step is half as long as the one before. */
    private static final int MOST_STEPS = 200;

    private final double lowX;
    private final double lowY;
    private final double lowZ;
    private final double highX;
    private final double highY;
    private final double highZ;

    /** @param box around the body in its own space */
    protected Bulge(int part, Affine toWorld, Bounds worldBounds, Bounds box) {
        super(part, toWorld, worldBounds);
        lowX = box.minX();
        lowY = box.minY();
        lowZ = box.minZ();
        highX = box.maxX();
        highY = box.maxY();
        highZ = box.maxZ();
    }

    /** Writes the function at o + t·d, and how fast it grows with t, as the first two. */
    protected abstract void form(Line line, double t, double[] out);

    /** The face that a point of the surface belongs to. */
    protected int faceAt(double x, double y, double z) {
        return 0;
    }

    @Override
    public double cost() {
        return 6;
    }

    /** Met from the middle of what lies in the box: the distance to it would take digits from the numbers there. */
    @Override
    protected boolean clip(Line line, Ray ray) {
        open(ray);
        if (!narrow(ray, line.ox, line.dx, lowX, highX, 0) || !narrow(ray, line.oy, line.dy, lowY, highY, 0) || !narrow(ray, line.oz, line.dz, lowZ, highZ, 0)) {
            return false;
        }
        double middle = (ray.enter + ray.leave) / 2;
        double half = (ray.leave - ray.enter) / 2;
        line.ox += middle * line.dx;
        line.oy += middle * line.dy;
        line.oz += middle * line.dz;
        double enter = end(line, -half, half, ray.breaks);
        double leave = enter <= half ? end(line, half, -half, ray.breaks) : enter;
        if (!(enter < leave)) {
            return false;
        }
        ray.enter = middle + enter;
        ray.leave = middle + leave;
        ray.enterFace = faceAt(line.ox + enter * line.dx, line.oy + enter * line.dy, line.oz + enter * line.dz);
        ray.leaveFace = faceAt(line.ox + leave * line.dx, line.oy + leave * line.dy, line.oz + leave * line.dz);
        return true;
    }

    /** Where the line meets the body on the way from one end of the box to the other; no number if it does not. */
    private double end(Line line, double from, double to, double[] room) {
        double t = from;
        for (int i = 0; i < MOST_STEPS; i++) {
            form(line, t, room);
            if (!(room[0] > 0)) {
                return t;
            }
            double next = t - room[0] / room[1];
            // Also if it grows the way the line goes, or does not change: then it is no way to the body.
            if (!(from < to ? next >= t && next <= to : next <= t && next >= to)) {
                return Double.NaN;
            }
            if (next == t) {
                return t;
            }
            t = next;
        }
        return t;
    }
}
