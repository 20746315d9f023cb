package cz.paprsek.render.integrate;

import cz.paprsek.ray.Hit;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.PartTable;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import java.util.function.IntPredicate;

/** How much of light surfaces let through that a shadow ray crosses: scratch of one worker. */
final class Veils {
    private final PartTable parts;
    private final Level level;
    private double[] shares = new double[16];

    /** How many surfaces the ray goes through that {@link #product} was last asked of. */
    int crossed;

    Veils(PartTable parts, Spans spans) {
        this.parts = parts;
        this.level = new Level(spans);
    }

    /**
     * The share of light that gets through all boundaries that a ray meets. The smallest share comes first, so that the product does not depend on the order in which the
     * surfaces were found.
     *
     * @param mark from which on they were pushed
     * @param isMet which of them are met
     */
    double product(Ray ray, Spans spans, int mark, IntPredicate isMet) {
        int most = spans.size() - mark;
        if (most > shares.length) {
            shares = new double[2 * most];
        }
        int count = 0;
        for (int i = mark; i < mark + most; i++) {
            if (!isMet.test(i)) {
                continue;
            }
            double share = transparency(ray, spans, i);
            int at = count++;
            for (; at > 0 && shares[at - 1] > share; at--) {
                shares[at] = shares[at - 1];
            }
            shares[at] = share;
        }
        crossed = count;
        double product = 1;
        for (int i = 0; i < count; i++) {
            product *= shares[i];
        }
        return product;
    }

    /** The share of light that gets through one of the boundaries that a ray has met. */
    double transparency(Ray ray, Spans spans, int boundary) {
        Finish finish = parts.finish(spans.part(boundary));
        return finish.isVeil() ? at(ray, spans.t(boundary), spans.part(boundary), spans.face(boundary), finish) : finish.transparency;
    }

    private double at(Ray ray, double t, int number, int face, Finish finish) {
        Part part = parts.part(number, level.copied);
        Hit hit = level.hit;
        hit.px = ray.ox + t * ray.dx;
        hit.py = ray.oy + t * ray.dy;
        hit.pz = ray.oz + t * ray.dz;
        hit.size = Math.abs(t) + Math.abs(hit.px) + Math.abs(hit.py) + Math.abs(hit.pz);
        part.describe(face < 0 ? ~face : face, hit);
        level.ray.face = face;
        level.part = part;
        return finish.transparencyAt(level);
    }
}
