package cz.paprsek.shape.placed;

import cz.paprsek.tree.Frustum;
import cz.paprsek.tree.Leaves;

/**
 * Scratch of one worker: rays that start in one place, side by side, so that all of them are asked in one plain loop which of them meet a ball: the JVM makes
 * vectors of it. Each then meets the same surfaces as if it were alone, in the same way.
 */
public final class Sheaf implements Leaves {
    private final Surface[] surfaces;
    private final Balls balls;
    private Frustum around = new Frustum();
    private Ray[] rays = {};
    private double[] dx = {};
    private double[] dy = {};
    private double[] dz = {};
    /** Squares of half the chords of a ball, and how far away their middles are. */
    private double[] half = {};
    private double[] middle = {};
    private int count;
    private double reach;
    private boolean hasMet;

    /** A sheaf that meets surfaces, each of which has a number, and may have a ball around it. */
    public Sheaf(Surface[] surfaces, Balls balls) {
        this.surfaces = surfaces;
        this.balls = balls;
    }

    /** Whether any of the surfaces has a ball around it: if none has, none is met, and no rays need be added. */
    public boolean isOfUse() {
        return balls.areAny();
    }

    /** Starts an empty sheaf with room for so many rays. */
    public void start(int most) {
        count = 0;
        if (rays.length < most) {
            rays = new Ray[most];
            dx = new double[most];
            dy = new double[most];
            dz = new double[most];
            half = new double[most];
            middle = new double[most];
        }
    }

    /** Adds a ray, which has just been started where all others are. */
    public void add(Ray ray) {
        int i = count++;
        if (rays[i] != ray) {
            rays[i] = ray;
        }
        dx[i] = ray.dx;
        dy[i] = ray.dy;
        dz[i] = ray.dz;
    }

    /** Says what lies around all rays that have been added, before any of them meets anything. */
    public void bind(Frustum frustum) {
        if (around != frustum) {
            around = frustum;
        }
        reach = Double.POSITIVE_INFINITY;
        hasMet = false;
    }

    @Override
    public double reach() {
        if (hasMet) {
            hasMet = false;
            reach = 0;
            for (int i = 0; i < count && reach < Double.POSITIVE_INFINITY; i++) {
                reach = Math.max(reach, rays[i].reach);
            }
        }
        return reach;
    }

    @Override
    public boolean take(int first, int end) {
        if (!balls.haveAll(first, end)) {
            return false;
        }
        for (int i = end - 1; i >= first; i--) {
            balls.nearest(surfaces[i], i, this);
        }
        return true;
    }

    /** Meets a surface with those rays whose lines meet the ball around it: by the arithmetic of {@link Ball}. */
    void nearest(Surface surface, double x, double y, double z, double r2) {
        if (!around.meetsBall(x, y, z, r2)) {
            return;
        }
        double lx = x - rays[0].ox;
        double ly = y - rays[0].oy;
        double lz = z - rays[0].oz;
        double[] dxs = dx;
        double[] dys = dy;
        double[] dzs = dz;
        double[] halves = half;
        double[] middles = middle;
        int all = count;
        for (int i = 0; i < all; i++) {
            double along = lx * dxs[i] + ly * dys[i] + lz * dzs[i];
            double px = lx - along * dxs[i];
            double py = ly - along * dys[i];
            double pz = lz - along * dzs[i];
            middles[i] = along;
            halves[i] = r2 - (px * px + py * py + pz * pz);
        }
        double radius = Math.sqrt(r2);
        for (int i = 0; i < all; i++) {
            // What lies behind a ray's hit is not met.
            if (halves[i] > 0 && middles[i] - radius < rays[i].reach) {
                surface.nearest(rays[i]);
                hasMet = true;
            }
        }
    }
}
