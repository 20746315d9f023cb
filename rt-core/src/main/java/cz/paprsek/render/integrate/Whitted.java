package cz.paprsek.render.integrate;

import cz.paprsek.ray.Hit;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;

/**
 * Ray tracing as Whitted has it: light that comes straight from lights, and what is mirrored and shines through.
 *
 * <pre>B = ambient·C + Σ lights V·I·( kD·C·max(0, N·L) + kS·max(0, R·L)ⁿ ) + kR·trace(R) + kT·trace(T)</pre>
 */
public class Whitted extends BlockTracer {
    /** For each level but the first: how the ray came about, if that takes more than two shares. */
    private final Scatter[] scatters;

    public Whitted(World scene, int maxDepth, Sampling sampling) {
        this(scene, maxDepth, sampling, new Witness());
    }

    /** @param witness is told every term of each colour */
    public Whitted(World scene, int maxDepth, Sampling sampling, Witness witness) {
        super(scene, maxDepth, sampling, false, new Spans(), witness);
        this.scatters = new Scatter[maxDepth];
        for (int i = 0; i < maxDepth; i++) {
            scatters[i] = new Scatter(scene, sampler, witness);
        }
    }

    @Override
    final void scatter(Level level, int depth, Finish finish) {
        if (finish.isLit() && !level.isIlluminated) {
            lighting.illuminate(depth, level, finish);
        }
        if (depth + 1 < levels.length && (finish.reflection > 0 || finish.transparency > 0)) {
            if (finish.isPlain) {
                spawn(level, levels[depth + 1], depth + 1, finish);
            } else {
                strew(level, levels[depth + 1], depth + 1, finish);
            }
        }
    }

    @Override
    final double unlit(Level level, int lamp) {
        return 0;
    }

    /**
     * Adds what is mirrored and what shines through. With e = n₁/n₂ and t = 1 + e²(c² − 1), the refracted direction is e·u + (e·c − √t)·N;
     * if t is negative all light is reflected, with the weight of both.
     *
     * @source Whitted, An Improved Illumination Model for Shaded Display, CACM 23(6), 1980
     */
    private void spawn(Level level, Level next, int depth, Finish finish) {
        Ray ray = level.ray;
        Hit hit = level.hit;
        double c = level.cosine;
        double reflection = finish.reflection;
        double e = 1;
        double root = c;
        boolean refracts = finish.transparency > 0;
        if (refracts) {
            double from = level.media.refractiveIndex();
            double to = scene.enterBeyond(level, finish, next.media);
            e = from / to;
            double t = 1 + e * e * (c * c - 1);
            witness.bent(from, to, c, t);
            refracts = t >= 0;
            if (refracts) {
                root = Math.sqrt(t);
            } else {
                reflection += finish.transparency;
            }
        }
        if (reflection > 0) {
            offspring.back(level, next, level.mirrorX, level.mirrorY, level.mirrorZ);
            witness.following(false, reflection, reflection, reflection);
            trace(depth);
            level.add(reflection, next);
        }
        if (refracts) {
            double k = e * c - root;
            offspring.on(level, next, finish, e * ray.dx + k * hit.sx, e * ray.dy + k * hit.sy, e * ray.dz + k * hit.sz);
            witness.following(true, finish.transparency, finish.transparency, finish.transparency);
            trace(depth);
            level.add(finish.transparency, next);
        }
    }

    /** The same where shares depend on the angle. */
    private void strew(Level level, Level next, int depth, Finish finish) {
        Scatter to = scatters[depth];
        to.decide(level, next, finish);
        if (to.mirrored() > 0) {
            offspring.back(level, next, to.x, to.y, to.z);
            next.isLit = finish.looksForLamps;
            witness.following(false, to.red, to.green, to.blue);
            trace(depth);
            level.add(to.red, to.green, to.blue, next);
        }
        if (to.through > 0) {
            offspring.on(level, next, finish, to.throughX, to.throughY, to.throughZ);
            next.isLit = finish.looksForLamps;
            witness.following(true, to.through, to.through, to.through);
            trace(depth);
            level.add(to.through, next);
        }
    }
}
