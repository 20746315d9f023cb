package cz.paprsek.render.integrate;

import cz.paprsek.render.sample.Turn;

/**
 * Rough surfaces as little facets that mirror: how their normals are spread about that of the surface, and how they stand in each other's way. Scratch
 * of one worker.
 *
 * @source Walter et al., Microfacet Models for Refraction through Rough Surfaces, EGSR 2007; Heitz, Sampling the GGX Distribution of Visible Normals,
 *     JCGT 7(4), 2018
 */
final class Ggx {
    private final Turn turn = new Turn();
    /** The facet's normal that was chosen last, of length 1, world space. */
    double x;
    double y;
    double z;

    /**
     * How many facets, per solid angle, are turned so far from the surface's normal: ∫ D·cos = 1 over the half of all directions.
     *
     * @param cosine between a facet's normal and the surface's, above 0
     */
    static double spread(double cosine, double alpha) {
        double square = alpha * alpha;
        double c = cosine * cosine;
        double t = c * (square - 1) + 1;
        return square / (Math.PI * t * t);
    }

    /**
     * Smith's share G₁ of the facets that are seen from a direction.
     *
     * @param cosine between that and the surface's normal, above 0
     */
    static double seen(double cosine, double alpha) {
        double c = cosine * cosine;
        double square = alpha * alpha;
        return 2 * cosine / (cosine + Math.sqrt(square + (1 - square) * c));
    }

    /**
     * Chooses a facet's normal among those seen from a direction: with density G₁·D·max(0, v·m)/(n·v).
     *
     * @param nx the surface's normal, of length 1
     * @param vx the direction, of length 1, n·v above 0
     * @param u random, 0–1
     * @param v random, 0–1
     */
    void choose(double nx, double ny, double nz, double vx, double vy, double vz, double alpha, double u, double v) {
        // Two directions across the normal: Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6(1), 2017.
        double sign = Math.copySign(1, nz);
        double a = -1 / (sign + nz);
        double b = nx * ny * a;
        double sx = 1 + sign * nx * nx * a;
        double sy = sign * b;
        double sz = -sign * nx;
        double ty = sign + ny * ny * a;
        double tz = -ny;
        // The view, on facets stretched to a hemisphere.
        double p = alpha * (vx * sx + vy * sy + vz * sz);
        double q = alpha * (vx * b + vy * ty + vz * tz);
        double w = vx * nx + vy * ny + vz * nz;
        double k = 1 / Math.sqrt(p * p + q * q + w * w);
        p *= k;
        q *= k;
        w *= k;
        double across = Math.sqrt(p * p + q * q);
        double e = across > 0 ? -q / across : 1;
        double f = across > 0 ? p / across : 0;
        double radius = Math.sqrt(u);
        turn.by(v);
        double first = radius * turn.cosine;
        double half = (1 + w) / 2;
        double second = (1 - half) * Math.sqrt(1 - first * first) + half * radius * turn.sine;
        double up = Math.sqrt(Math.max(0, 1 - first * first - second * second));
        // first·(e, f, 0) + second·(p, q, w)×(e, f, 0) + up·(p, q, w), and back to facets as they are.
        double mp = alpha * (first * e - second * w * f + up * p);
        double mq = alpha * (first * f + second * w * e + up * q);
        double mw = Math.max(1e-12, second * (p * f - q * e) + up * w);
        double length = 1 / Math.sqrt(mp * mp + mq * mq + mw * mw);
        mp *= length;
        mq *= length;
        mw *= length;
        x = mp * sx + mq * b + mw * nx;
        y = mp * sy + mq * ty + mw * ny;
        z = mp * sz + mq * tz + mw * nz;
    }
}
