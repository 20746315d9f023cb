package cz.paprsek.render.integrate;

import cz.paprsek.ray.Hit;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import cz.paprsek.shape.placed.Ray;

/** Scratch of one level: where a surface sends light if that is more than a mirror's two shares, and how much of it. */
final class Scatter extends Shares {
    private final World scene;
    private final Witness witness;
    private final Sampler sampler;
    private final Ggx facets = new Ggx();
    /** Where what is mirrored goes, of length 1. */
    double x;
    double y;
    double z;
    /** Where what is let through goes, of length 1. */
    double throughX;
    double throughY;
    double throughZ;

    Scatter(World scene, Sampler sampler, Witness witness) {
        this.scene = scene;
        this.sampler = sampler;
        this.witness = witness;
    }

    /**
     * Decides where light goes from the level's hit.
     *
     * @param next a level whose media may be changed
     */
    void decide(Level level, Level next, Finish finish) {
        Ray ray = level.ray;
        Hit hit = level.hit;
        boolean isPane = scene.isPane(level, finish);
        double from = level.media.refractiveIndex();
        double to = isPane || !scene.isSolid(scene.parts().object(ray.part)) ? finish.refractiveIndex : scene.enterBeyond(level, finish, next.media);
        double mx = hit.sx;
        double my = hit.sy;
        double mz = hit.sz;
        double cosine = level.cosine;
        boolean isRough = finish.alpha > 0;
        if (isRough) {
            sampler.facet(level.path);
            sampler.next();
            facets.choose(mx, my, mz, -ray.dx, -ray.dy, -ray.dz, finish.alpha, sampler.u, sampler.v);
            mx = facets.x;
            my = facets.y;
            mz = facets.z;
            cosine = Math.min(1, Math.max(0, -(ray.dx * mx + ray.dy * my + ray.dz * mz)));
        }
        double e = from / to;
        double radicand = 1 + e * e * (cosine * cosine - 1);
        if (finish.transparency > 0 && !isPane) {
            witness.bent(from, to, cosine, radicand);
        }
        double root = radicand < 0 ? 0 : Math.sqrt(radicand);
        weigh(level, finish, isPane, from, to, cosine, radicand);
        witness.split(from, to, cosine, root, fresnelRed, fresnelGreen, fresnelBlue);
        double twice = 2 * cosine;
        x = ray.dx + twice * mx;
        y = ray.dy + twice * my;
        z = ray.dz + twice * mz;
        double k = e * cosine - root;
        throughX = isPane ? ray.dx : e * ray.dx + k * mx;
        throughY = isPane ? ray.dy : e * ray.dy + k * my;
        throughZ = isPane ? ray.dz : e * ray.dz + k * mz;
        if (isRough) {
            choose(level, finish, isPane, mx, my, mz);
        }
    }

    /** Of a rough surface one ray is followed for both. What a pane lets through it scatters as much as what it mirrors. */
    private void choose(Level level, Finish finish, boolean isPane, double mx, double my, double mz) {
        Hit hit = level.hit;
        double chance = chance();
        sampler.lobe(level.path);
        sampler.next();
        boolean isMirrored = sampler.u < chance;
        double facing = x * hit.sx + y * hit.sy + z * hit.sz;
        if (isPane && !isMirrored) {
            throughX = x - 2 * facing * hit.sx;
            throughY = y - 2 * facing * hit.sy;
            throughZ = z - 2 * facing * hit.sz;
        }
        double cosine = isMirrored || isPane ? facing : -(throughX * hit.sx + throughY * hit.sy + throughZ * hit.sz);
        // The surface itself, of which facets know nothing, may be turned otherwise.
        double side = isMirrored ? x * hit.nx + y * hit.ny + z * hit.nz : -(throughX * hit.nx + throughY * hit.ny + throughZ * hit.nz);
        double weight = cosine > 0 && side > 0 ? Ggx.seen(Math.min(1, cosine), finish.alpha) : 0;
        double share = isMirrored ? chance : 1 - chance;
        witness.facet(mx, my, mz, share, weight);
        double back = isMirrored ? weight / share : 0;
        red *= back;
        green *= back;
        blue *= back;
        through *= isMirrored ? 0 : weight / share;
    }
}
