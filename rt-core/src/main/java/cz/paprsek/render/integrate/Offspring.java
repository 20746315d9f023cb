package cz.paprsek.render.integrate;

import cz.paprsek.ray.Hit;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.PartTable;
import cz.paprsek.render.surface.World;

/** Starts the rays that a hit gives rise to, and counts them. */
final class Offspring {
    private final World scene;
    private final PartTable parts;
    /** Whether rays know how far their neighbours are: only if a paint asks for it. */
    private final boolean footprints;

    long reflected;
    long refracted;

    Offspring(World scene) {
        this.scene = scene;
        this.parts = scene.parts();
        this.footprints = scene.asksForFootprints();
    }

    /** A ray on the side of a hit from which that was seen. */
    void back(Level level, Level next, double x, double y, double z) {
        next.beyond = false;
        start(level, next, x, y, z, level.leaving != level.ray.face < 0);
        next.path = Sampler.mirrored(level.path);
        Lighting.backFrom(level, next.ray);
        if (footprints) {
            next.footprint.mirrored(level.footprint, level.ray, level.hit, parts.part(level.ray.part, level.copied));
        }
        next.media.set(level.media);
        reflected++;
    }

    /** A ray beyond the surface of a hit. */
    void on(Level level, Level next, Finish finish, double x, double y, double z) {
        next.beyond = true;
        start(level, next, x, y, z, level.leaving == level.ray.face < 0);
        next.path = Sampler.refracted(level.path);
        double beyond = scene.enterBeyond(level, finish, next.media);
        if (footprints) {
            next.footprint.refracted(level.footprint, level.ray, level.hit, parts.part(level.ray.part, level.copied), level.media.refractiveIndex() / beyond);
        }
        refracted++;
    }

    private static void start(Level level, Level next, double x, double y, double z, boolean outside) {
        Hit hit = level.hit;
        if (level.isBent) {
            double fold = Bent.fold(hit, x, y, z, next.beyond);
            next.ray.start(hit.px, hit.py, hit.pz, x + fold * hit.nx, y + fold * hit.ny, z + fold * hit.nz, hit.size, Double.POSITIVE_INFINITY, level.ray.part, outside);
        } else {
            next.ray.start(hit.px, hit.py, hit.pz, x, y, z, hit.size, Double.POSITIVE_INFINITY, level.ray.part, outside);
        }
        next.isLit = false;
    }
}
