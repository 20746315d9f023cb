package cz.paprsek.render.buffer;

import cz.paprsek.math.Bounds;
import cz.paprsek.shape.placed.Ball;
import cz.paprsek.shape.placed.Balls;
import cz.paprsek.shape.placed.Surface;
import java.util.Arrays;
import java.util.function.BooleanSupplier;

/** Where a light would see bodies: no part of one is outside of its outline. For one thread. */
final class LightOutlines {
    /** By so much a body is taken to begin nearer to the light, or to end farther from it, than reckoned. */
    private static final double ROUNDING = 1e-6;
    /** A ball is an outline where it is seen under less than a right angle, clearly. */
    private static final double ROUND = 0.9;

    private final LightView view;
    private final Surface[] surfaces;
    private final Balls balls;
    private final boolean[] opaque;
    private final int[] which;
    /** By body: least u and v, greatest u and v. */
    private final double[] edges;
    /** Up to where from the light nothing of a body is. */
    private final float[] near;

    /** The body that was taken last, and the ball around it: where its middle is seen, as a direction or a place, and its squared radius there with that of a cell added and taken away. */
    private final double[] ball = new double[4];
    private double alongU;
    private double alongV;
    private double alongW;
    private double outer;
    private double inner;
    private boolean isRound;

    /** @param which the bodies that are seen, all of them before the light */
    LightOutlines(LightView view, Surface[] surfaces, Balls balls, boolean[] opaque, int[] which) {
        this.view = view;
        this.surfaces = surfaces;
        this.balls = balls;
        this.opaque = opaque;
        this.which = which;
        edges = new double[4 * which.length];
        near = new float[which.length];
    }

    /** Finds the outlines; false if it is told to stop. */
    boolean find(Bounds[] boxes, BooleanSupplier stop) {
        for (int k = 0; k < which.length; k++) {
            if (k % LightCells.BATCH == 0 && stop.getAsBoolean()) {
                return false;
            }
            double least = outline(boxes[which[k]].padded(), k);
            if (balls.putAround(which[k], ball)) {
                least = Math.max(least, narrow(k));
            }
            near[k] = (float) (Math.max(0, least) * (1 - ROUNDING));
        }
        return true;
    }

    int body(int k) {
        return which[k];
    }

    float near(int k) {
        return near[k];
    }

    double edge(int k, int which) {
        return edges[4 * k + which];
    }

    /** The numbers of all, those that begin nearer to the light before others. */
    int[] nearestFirst() {
        long[] keys = new long[which.length];
        for (int k = 0; k < keys.length; k++) {
            keys[k] = (long) Float.floatToRawIntBits(near[k]) << Integer.SIZE | k;
        }
        Arrays.sort(keys);
        return Arrays.stream(keys).mapToInt(key -> (int) key).toArray();
    }

    /** A grid over all of them. */
    LightGrid grid(int rows, double nearest) {
        double[] all = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int i = 0; i < edges.length; i++) {
            all[i % 4] = i % 4 < 2 ? Math.min(all[i % 4], edges[i]) : Math.max(all[i % 4], edges[i]);
        }
        return new LightGrid(rows, all[0], all[1], all[2], all[3], nearest);
    }

    /** Sets the outline to that of a box; the least distance from the light to it. */
    private double outline(Bounds box, int k) {
        double u1 = Double.POSITIVE_INFINITY;
        double v1 = Double.POSITIVE_INFINITY;
        double u2 = Double.NEGATIVE_INFINITY;
        double v2 = Double.NEGATIVE_INFINITY;
        double w1 = Double.POSITIVE_INFINITY;
        for (int corner = 0; corner < 8; corner++) {
            double x = ((corner & 1) == 0 ? box.minX() : box.maxX()) - view.x;
            double y = ((corner & 2) == 0 ? box.minY() : box.maxY()) - view.y;
            double z = ((corner & 4) == 0 ? box.minZ() : box.maxZ()) - view.z;
            double w = x * view.wx + y * view.wy + z * view.wz;
            double factor = view.factor(w);
            double u = (x * view.ux + y * view.uy + z * view.uz) * factor;
            double v = (x * view.vx + y * view.vy + z * view.vz) * factor;
            u1 = Math.min(u1, u);
            v1 = Math.min(v1, v);
            u2 = Math.max(u2, u);
            v2 = Math.max(v2, v);
            w1 = Math.min(w1, w);
        }
        edges[4 * k] = u1;
        edges[4 * k + 1] = v1;
        edges[4 * k + 2] = u2;
        edges[4 * k + 3] = v2;
        if (view.isFar) {
            return w1;
        }
        double x = Math.max(0, Math.max(box.minX() - view.x, view.x - box.maxX()));
        double y = Math.max(0, Math.max(box.minY() - view.y, view.y - box.maxY()));
        double z = Math.max(0, Math.max(box.minZ() - view.z, view.z - box.maxZ()));
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** Narrows the outline to that of the ball; the least distance from the light to that. */
    private double narrow(int k) {
        locate();
        double r2 = ball[3];
        double r = Math.sqrt(r2);
        if (view.isFar) {
            narrow(k, alongU - r, alongV - r, alongU + r, alongV + r);
            return alongW - r;
        }
        double below = alongW * alongW - r2;
        if (alongW > 0 && below > ROUNDING * alongW * alongW) {
            double halfU = Math.sqrt(r2 * (alongU * alongU + below));
            double halfV = Math.sqrt(r2 * (alongV * alongV + below));
            narrow(k, (alongU * alongW - halfU) / below, (alongV * alongW - halfV) / below, (alongU * alongW + halfU) / below, (alongV * alongW + halfV) / below);
        }
        return Math.sqrt(alongU * alongU + alongV * alongV + alongW * alongW) - r;
    }

    private void narrow(int k, double u1, double v1, double u2, double v2) {
        edges[4 * k] = Math.max(edges[4 * k], u1);
        edges[4 * k + 1] = Math.max(edges[4 * k + 1], v1);
        edges[4 * k + 2] = Math.min(edges[4 * k + 2], u2);
        edges[4 * k + 3] = Math.min(edges[4 * k + 3], v2);
    }

    /** Where the middle of the ball lies from the light. */
    private void locate() {
        double x = ball[0] - view.x;
        double y = ball[1] - view.y;
        double z = ball[2] - view.z;
        alongU = x * view.ux + y * view.uy + z * view.uz;
        alongV = x * view.vx + y * view.vy + z * view.vz;
        alongW = x * view.wx + y * view.wy + z * view.wz;
    }

    /**
     * Makes ready to ask of a body where it is seen.
     *
     * @param half from the middle of a cell to its corners
     * @return beyond which distance from the light nothing that it hides can matter; infinite if it hides nothing
     */
    float take(int k, double half) {
        isRound = balls.putAround(which[k], ball);
        if (!isRound) {
            return Float.POSITIVE_INFINITY;
        }
        locate();
        double distance = Math.sqrt(alongU * alongU + alongV * alongV + alongW * alongW);
        double r = Math.sqrt(ball[3]);
        if (view.isFar) {
            outer = (r + half) * (r + half);
            inner = r > half ? (r - half) * (r - half) : -1;
            distance = alongW;
        } else {
            double sine = r / distance;
            isRound = sine < ROUND && sine + half < ROUND;
            alongU /= distance;
            alongV /= distance;
            alongW /= distance;
            // A cell is seen under an angle that is less than its half; sines of sums.
            double cosine = Math.sqrt(1 - Math.min(1, sine * sine));
            double larger = sine * Math.sqrt(1 - Math.min(1, half * half)) + cosine * half;
            double smaller = sine * Math.sqrt(1 - Math.min(1, half * half)) - cosine * half;
            outer = larger * larger;
            inner = smaller > 0 ? smaller * smaller : -1;
        }
        boolean hides = isRound && inner > 0 && opaque[which[k]] && surfaces[which[k]] instanceof Ball;
        return hides ? (float) ((distance + r) * (1 + ROUNDING)) : Float.POSITIVE_INFINITY;
    }

    /** Whether a cell may show any of the body, by its middle. */
    boolean mayBeIn(double u, double v) {
        return !isRound || squaredSine(u, v) <= outer;
    }

    /** Whether it hides all else in a cell. */
    boolean fills(double u, double v) {
        return isRound && squaredSine(u, v) < inner;
    }

    /** Of the angle between the middle of the ball and that of a cell; from far away their squared distance. */
    private double squaredSine(double u, double v) {
        if (view.isFar) {
            return (u - alongU) * (u - alongU) + (v - alongV) * (v - alongV);
        }
        double a = v * alongW - alongV;
        double b = alongU - u * alongW;
        double c = u * alongV - v * alongU;
        return (a * a + b * b + c * c) / (1 + u * u + v * v);
    }
}
