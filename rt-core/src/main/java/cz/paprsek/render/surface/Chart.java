package cz.paprsek.render.surface;

import cz.paprsek.material.Pattern;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.texture.Texture;
import cz.paprsek.shape.placed.Part;
import java.util.Objects;

/** Scratch of one level: how a picture lies around a hit, and how much of it the pixel covers. */
final class Chart {
    /** Slopes of u and v are found so far on both sides, relative to the numbers behind a point. */
    private static final double STEP = 0x1p-24;
    /** So far u and v do not grow on such a short way: there is a seam between. */
    private static final double JUMP = 0.05;

    /** Two directions across the normal that light is reckoned with, of length 1, right-handed before it. */
    private double ax;
    private double ay;
    private double az;
    private double bx;
    private double by;
    private double bz;
    /** How fast u and v grow along the one and the other. */
    private double uA;
    private double vA;
    private double uB;
    private double vB;
    /** How much they grow on the way to the neighbouring pixels' points. */
    private double uX;
    private double vX;
    private double uY;
    private double vY;
    private double fromU;
    private double fromV;

    /** Lays a picture on the surface around the level's hit, and sets the hit's u and v. */
    void lay(Level level, Mapping mapping) {
        Hit hit = level.hit;
        int face = level.ray.face < 0 ? ~level.ray.face : level.ray.face;
        Part part = Objects.requireNonNull(level.part);
        mapping.map(hit, part, face);
        // Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6(1), 2017.
        double sign = Math.copySign(1, hit.sz);
        double k = -1 / (sign + hit.sz);
        double m = hit.sx * hit.sy * k;
        ax = 1 + sign * hit.sx * hit.sx * k;
        ay = sign * m;
        az = -sign * hit.sx;
        bx = m;
        by = sign + hit.sy * hit.sy * k;
        bz = -hit.sy;
        double step = STEP * hit.size;
        grow(level, mapping, part, face, step * ax, step * ay, step * az);
        uA = fromU / step;
        vA = fromV / step;
        grow(level, mapping, part, face, step * bx, step * by, step * bz);
        uB = fromU / step;
        vB = fromV / step;
        double[] point = level.footprint.point;
        uX = growthU(point, 0);
        vX = growthV(point, 0);
        uY = growthU(point, 3);
        vY = growthV(point, 3);
    }

    /** Finds how much u and v grow on a way, as the mean of there and back; over a seam, what they do on this side of it. */
    private void grow(Level level, Mapping mapping, Part part, int face, double x, double y, double z) {
        step(level, mapping, part, face, x, y, z);
        double u = fromU;
        double v = fromV;
        step(level, mapping, part, face, -x, -y, -z);
        boolean isThere = Math.abs(u) + Math.abs(v) < JUMP;
        boolean isBack = Math.abs(fromU) + Math.abs(fromV) < JUMP;
        fromU = isThere && isBack ? (u - fromU) / 2 : isThere ? u : isBack ? -fromU : 0;
        fromV = isThere && isBack ? (v - fromV) / 2 : isThere ? v : isBack ? -fromV : 0;
    }

    private void step(Level level, Mapping mapping, Part part, int face, double x, double y, double z) {
        Hit hit = level.hit;
        Hit probe = level.probe;
        probe.px = hit.px + x;
        probe.py = hit.py + y;
        probe.pz = hit.pz + z;
        probe.unitNormal(hit.nx, hit.ny, hit.nz);
        mapping.map(probe, part, face);
        fromU = probe.u - hit.u;
        fromV = probe.v - hit.v;
    }

    private double growthU(double[] way, int i) {
        return uA * (way[i] * ax + way[i + 1] * ay + way[i + 2] * az) + uB * (way[i] * bx + way[i + 1] * by + way[i + 2] * bz);
    }

    private double growthV(double[] way, int i) {
        return vA * (way[i] * ax + way[i + 1] * ay + way[i + 2] * az) + vB * (way[i] * bx + way[i + 1] * by + way[i + 2] * bz);
    }

    /** How much of u the pixel covers. */
    double wideU() {
        return Math.max(Math.abs(uX), Math.abs(uY));
    }

    double wideV() {
        return Math.max(Math.abs(vX), Math.abs(vY));
    }

    /** Sets a hit's colour to what a picture has there: at its nearest point only if it is to be so. */
    void look(Texture texture, Pattern.Filter filter, double u, double v, Hit out) {
        switch (filter) {
            case NEAREST -> texture.nearest(u, v, out);
            case BILINEAR -> texture.bilinear(u, v, out);
            case SMOOTH -> texture.smooth(u, v, uX, vX, uY, vY, out);
        }
    }

    /** Sets the slope in the world of what grows so fast with u and v. */
    void slope(double alongU, double alongV, double[] out) {
        double a = alongU * uA + alongV * vA;
        double b = alongU * uB + alongV * vB;
        out[0] = a * ax + b * bx;
        out[1] = a * ay + b * by;
        out[2] = a * az + b * bz;
    }

    /**
     * Bends the normal that light is reckoned with.
     *
     * @param x of the new one along the direction in which u grows and v does not
     * @param y of it across, where v grows
     * @param z of it along the old one
     */
    void bend(double x, double y, double z, Hit hit) {
        double area = uA * vB - uB * vA;
        double side = area < 0 ? -1 : 1;
        // Where u grows and v does not.
        double alongA = side * vB;
        double alongB = -side * vA;
        double length = Math.sqrt(alongA * alongA + alongB * alongB);
        if (!(length > 0)) {
            return;
        }
        alongA /= length;
        alongB /= length;
        double a = x * alongA - side * y * alongB;
        double b = x * alongB + side * y * alongA;
        hit.bend(a * ax + b * bx + z * hit.sx, a * ay + b * by + z * hit.sy, a * az + b * bz + z * hit.sz);
    }
}
