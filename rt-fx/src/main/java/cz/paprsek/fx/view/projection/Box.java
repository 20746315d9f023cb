package cz.paprsek.fx.view.projection;

/** A rectangle in a projection's plane, upright; empty when a minimum lies above its maximum. */
record Box(double minU, double minV, double maxU, double maxV) {
    static final Box EMPTY = new Box(
            Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY);

    static Box of(double u0, double v0, double u1, double v1) {
        return new Box(Math.min(u0, u1), Math.min(v0, v1), Math.max(u0, u1), Math.max(v0, v1));
    }

    boolean isEmpty() {
        return minU > maxU || minV > maxV;
    }

    double width() {
        return maxU - minU;
    }

    double height() {
        return maxV - minV;
    }

    double centreU() {
        return (minU + maxU) / 2;
    }

    double centreV() {
        return (minV + maxV) / 2;
    }

    Box union(Box other) {
        return new Box(Math.min(minU, other.minU), Math.min(minV, other.minV), Math.max(maxU, other.maxU), Math.max(maxV, other.maxV));
    }

    /** The same elsewhere. */
    Box moved(double u, double v) {
        return new Box(minU + u, minV + v, maxU + u, maxV + v);
    }

    Box with(double u, double v) {
        return new Box(Math.min(minU, u), Math.min(minV, v), Math.max(maxU, u), Math.max(maxV, v));
    }

    boolean contains(double u, double v, double margin) {
        return u >= minU - margin && u <= maxU + margin && v >= minV - margin && v <= maxV + margin;
    }

    boolean contains(Box other) {
        return other.minU >= minU && other.maxU <= maxU && other.minV >= minV && other.maxV <= maxV;
    }
}
