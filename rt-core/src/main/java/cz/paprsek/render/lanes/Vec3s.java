package cz.paprsek.render.lanes;

import cz.paprsek.math.Vec3;

/**
 * Many vectors side by side. What is asked of all of them is done in short plain loops, for which the JVM has instructions that take several numbers at once; for a loop of more than some sixty
 * operations it uses none. Scratch of one worker; each number is the same as of one vector by itself.
 */
public final class Vec3s {
    public double[] x = {};
    public double[] y = {};
    public double[] z = {};

    /** Makes room for so many; what was there before is lost if there was less. */
    public void reserve(int count) {
        if (x.length < count) {
            x = new double[count];
            y = new double[count];
            z = new double[count];
        }
    }

    /** Makes one of them a vector. */
    public void set(int i, double vx, double vy, double vz) {
        x[i] = vx;
        y[i] = vy;
        z[i] = vz;
    }

    /**
     * Makes the first so many a + u·b + v·c.
     *
     * @param u one number for each
     * @param v likewise
     */
    public void combine(Vec3 a, double[] u, Vec3 b, double[] v, Vec3 c, int count) {
        combine(a.x(), u, b.x(), v, c.x(), x, count);
        combine(a.y(), u, b.y(), v, c.y(), y, count);
        combine(a.z(), u, b.z(), v, c.z(), z, count);
    }

    private static void combine(double a, double[] u, double b, double[] v, double c, double[] out, int count) {
        for (int i = 0; i < count; i++) {
            out[i] = a + u[i] * b + v[i] * c;
        }
    }

    /** Makes the first so many the ways to a point from others. */
    public void towards(double px, double py, double pz, Vec3s from, int count) {
        subtract(px, from.x, x, count);
        subtract(py, from.y, y, count);
        subtract(pz, from.z, z, count);
    }

    private static void subtract(double p, double[] from, double[] out, int count) {
        for (int i = 0; i < count; i++) {
            out[i] = p - from[i];
        }
    }

    /**
     * Makes the first so many of length 1.
     *
     * @param lengths receives their lengths before
     */
    public void normalize(double[] lengths, int count) {
        double[] vx = x;
        double[] vy = y;
        double[] vz = z;
        for (int i = 0; i < count; i++) {
            lengths[i] = Math.sqrt(vx[i] * vx[i] + vy[i] * vy[i] + vz[i] * vz[i]);
        }
        for (int i = 0; i < count; i++) {
            double k = 1 / lengths[i];
            vx[i] *= k;
            vy[i] *= k;
            vz[i] *= k;
        }
    }

    /**
     * Finds the scalar products with others.
     *
     * @param products receives those of the first so many
     */
    public void dot(Vec3s other, double[] products, int count) {
        double[] ax = x;
        double[] ay = y;
        double[] az = z;
        double[] bx = other.x;
        double[] by = other.y;
        double[] bz = other.z;
        for (int i = 0; i < count; i++) {
            products[i] = ax[i] * bx[i] + ay[i] * by[i] + az[i] * bz[i];
        }
    }
}
