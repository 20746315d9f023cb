package cz.paprsek.render.integrate;

import cz.paprsek.ray.Hit;
import cz.paprsek.render.glow.Glows;
import cz.paprsek.render.surface.Bodies;
import cz.paprsek.render.surface.Contacts;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.PartTable;
import cz.paprsek.render.surface.World;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.tree.Entries;

/** Finds what rays hit, bodies and the lights that are seen, and where: scratch of one worker. */
final class Intersector {
    final Bodies.Finder finder;
    final Contacts contacts;
    private final Bodies bodies;
    private final PartTable parts;
    private final Glows glows;

    /** How many rays have hit something so far. */
    long hits;

    Intersector(World scene, Spans spans) {
        bodies = scene.bodies();
        parts = scene.parts();
        glows = scene.glows().forOneWorker();
        finder = bodies.newFinder();
        contacts = new Contacts(scene, finder, spans);
    }

    /** Nodes of the tree visited so far, leaves included, those of bundles not. */
    long nodeVisits() {
        return finder.visited();
    }

    /** Finds what the level's ray hits, and where. */
    void find(Level level, Entries among) {
        Ray ray = level.ray;
        bodies.nearest(ray, among, finder);
        if (ray.part >= 0 && (ray.max <= ray.contact || level.media.areAround())) {
            contacts.settle(level);
        }
        glows.nearest(ray);
        if (ray.part >= 0) {
            hits++;
            locate(level, ray, level.hit);
        }
    }

    private void locate(Level level, Ray ray, Hit hit) {
        hit.px = ray.ox + ray.max * ray.dx;
        hit.py = ray.oy + ray.max * ray.dy;
        hit.pz = ray.oz + ray.max * ray.dz;
        hit.hint = ray.hint;
        hit.size = ray.max + Math.abs(hit.px) + Math.abs(hit.py) + Math.abs(hit.pz);
        if (glows.has(ray.part)) {
            glows.describe(ray.part, ray.face, hit);
            return;
        }
        boolean flipped = ray.face < 0;
        parts.part(ray.part, level.copied).describe(flipped ? ~ray.face : ray.face, hit);
        if (flipped) {
            hit.turn();
        }
    }
}
