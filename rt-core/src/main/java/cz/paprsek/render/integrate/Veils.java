package cz.paprsek.render.integrate;

import cz.paprsek.ray.Hit;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.PartTable;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;

/** How much of light surfaces let through that a shadow ray crosses: scratch of one worker. */
final class Veils {
    private final PartTable parts;
    private final Level level;

    Veils(PartTable parts, Spans spans) {
        this.parts = parts;
        this.level = new Level(spans);
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
