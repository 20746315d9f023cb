package cz.paprsek.shape.placed;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;

/** A convex primitive that is met in its own space, through the map that leads there. */
public abstract class LocalConvex extends Convex {
    protected final Affine toLocal;
    private final Bounds bounds;

    protected LocalConvex(int part, Affine toWorld, Bounds worldBounds) {
        super(part);
        this.toLocal = toWorld.inverse();
        this.bounds = worldBounds;
    }

    /** As {@link #clip(Ray)}, for the line in the shape's own space. */
    protected abstract boolean clip(Line line, Ray ray);

    /** Calls {@link Hit#normal} for a point on a face, both in the shape's own space. */
    protected abstract void describe(int face, double x, double y, double z, Affine toLocal, Hit hit);

    /** Calls {@link Hit#map} for a point on a face, both in the shape's own space. */
    protected abstract void map(int face, double x, double y, double z, Hit hit);

    @Override
    public Bounds bounds() {
        return bounds;
    }

    @Override
    public double cost() {
        return 2;
    }

    @Override
    protected boolean clip(Ray ray) {
        return clip(ray.in(toLocal), ray);
    }

    @Override
    public void describe(int face, Hit hit) {
        describe(face, toLocal.pointX(hit.px, hit.py, hit.pz), toLocal.pointY(hit.px, hit.py, hit.pz),
                toLocal.pointZ(hit.px, hit.py, hit.pz), toLocal, hit);
    }

    @Override
    public void map(int face, Hit hit) {
        map(face, toLocal.pointX(hit.px, hit.py, hit.pz), toLocal.pointY(hit.px, hit.py, hit.pz), toLocal.pointZ(hit.px, hit.py, hit.pz), hit);
        hit.tangentFrom(toLocal);
    }

    /**
     * Narrows the ray's stretch to where low ≤ o + t·d ≤ high along one axis.
     *
     * @param lowFace the face at low; the one at high is the next number
     * @return whether anything is left
     */
    protected static boolean narrow(Ray ray, double o, double d, double low, double high, int lowFace) {
        double r = 1 / d;
        if (Double.isInfinite(r)) {
            return o >= low && o <= high;
        }
        double atLow = (low - o) * r;
        double atHigh = (high - o) * r;
        return d > 0 ? narrow(ray, atLow, lowFace, atHigh, lowFace + 1) : narrow(ray, atHigh, lowFace + 1, atLow, lowFace);
    }

    /** Opens the ray's stretch to the whole line. */
    protected static void open(Ray ray) {
        ray.enter = Double.NEGATIVE_INFINITY;
        ray.leave = Double.POSITIVE_INFINITY;
    }
}
