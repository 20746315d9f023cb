package cz.paprsek.render.integrate;

import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.light.Emitters;
import cz.paprsek.render.sample.Asked;
import cz.paprsek.render.sample.PassSums;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.sample.Turn;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import cz.paprsek.shape.placed.Spans;

/**
 * Light that comes any number of ways: each ray from the eye becomes a path that goes on from each hit in one direction, chosen at random as often as
 * the surface sends light there. At each hit every light is looked for; of those that a path may meet as well, both ways bring their share.
 *
 * @source Kajiya, The Rendering Equation, SIGGRAPH 1986; Veach and Guibas, Optimally Combining Sampling Techniques, SIGGRAPH 1995
 */
public class Paths extends BlockTracer {
    /** From this hit on a path that brings little ends by chance, and counts the more if it does not. */
    private static final int ROULETTE = 8;

    /** The number of the last ray, of which only what it sees shine counts. */
    private final int last;
    private final Passes sampling;
    private final PassSums sums;
    private final float[] kept;
    private final Scatter onward;
    private final Turn turn = new Turn();
    /** By level, what was last asked for a direction. */
    private final Asked[] asked;
    private final Arrival way = new Arrival();
    /** Whether the path goes on from the hit that was last lit: its next ray has been started. */
    private boolean goesOn;

    /** @param maxDepth how often light is scattered at most */
    public Paths(World scene, int maxDepth, Passes sampling) {
        this(scene, maxDepth, sampling, new Witness());
    }

    /**
     * A tracer that tells all.
     *
     * @param maxDepth how often light is scattered at most
     * @param witness is told every term of each colour
     */
    public Paths(World scene, int maxDepth, Passes sampling, Witness witness) {
        super(scene, maxDepth + 1, sampling, true, new Spans(), witness);
        last = maxDepth;
        asked = Asked.none(maxDepth + 1);
        this.sampling = sampling;
        sums = sampling.newSums();
        kept = new float[sampling.kept()];
        onward = new Scatter(scene, sampler, witness);
    }

    /** All passes; of a film in passes, the next one. */
    @Override
    public final void block(Eye eye, int x, int y, int width, int height, Film film) {
        if (!film.isInPasses()) {
            super.block(eye, x, y, width, height, film);
            return;
        }
        for (int i = 0; i < width * height && !cancelled; i++) {
            pass(eye, x + i % width, y + i / width, film);
        }
    }

    /** Gives a pixel the paths of the next pass, if it is to get any. */
    protected void pass(Eye eye, int x, int y, Film film) {
        film.kept(x, y, kept);
        sums.load(kept, 0);
        int more = sampling.further(sums);
        if (more == 0) {
            return;
        }
        add(more, eye, x, y, sums);
        if (cancelled) {
            return;
        }
        if (sums.areWhole()) {
            sums.save(kept, 0);
            film.keep(x, y, kept);
        }
        sums.mean();
        film.set(x, y, sums.red, sums.green, sums.blue);
        if (sampling.further(sums) > 0) {
            film.wantMore(1);
        }
    }

    @Override
    final void emit(Level level, Finish finish) {
        int face = level.ray.face;
        int number = level.isLit ? lighting.emitters.of(scene.index(scene.parts().object(level.ray.part)), face < 0 ? ~face : face) : Emitters.NOT_SOUGHT;
        double share = number == Emitters.NOT_SOUGHT ? 1 : unlit(level, number);
        level.glow = share;
        level.add(share * finish.red, share * finish.green, share * finish.blue);
        witness.emitted(share * finish.red, share * finish.green, share * finish.blue);
    }

    @Override
    final void seeSky(Level level) {
        if (level.isLit && lighting.sky.isPresent()) {
            Hit hit = level.hit;
            lighting.sky.get().look(level.ray.dx, level.ray.dy, level.ray.dz, hit);
            double share = unsought(level, lighting.sky.get().density(level.ray.dx, level.ray.dy, level.ray.dz));
            level.light(share * hit.red, share * hit.green, share * hit.blue);
        } else {
            super.seeSky(level);
        }
    }

    @Override
    final double unlit(Level level, int lamp) {
        return unsought(level, lighting.density(lamp, level.ray));
    }

    /** @param other how probable it is that who looks for the light chooses the ray's direction */
    private static double unsought(Level level, double other) {
        // Of what it is never looked for at, such as its dark side, all comes this way.
        return other > 0 ? level.density / (level.density + other) : 1;
    }

    /** Follows the path to its end, and brings its light back. */
    @Override
    void shade(Level first, int depth) {
        Level level = first;
        int end = depth;
        while (arrive(level)) {
            goesOn = false;
            scatter(level, end, level.finish);
            if (!goesOn) {
                leave(level);
                break;
            }
            end++;
            level = levels[end];
            if (!find(level)) {
                break;
            }
        }
        for (; end > depth; end--) {
            Level before = end - 1 == depth ? first : levels[end - 1];
            before.add(level.shareRed, level.shareGreen, level.shareBlue, level);
            leave(before);
            level = before;
        }
    }

    @Override
    final void scatter(Level level, int depth, Finish finish) {
        if (depth == last) {
            level.light(level.glow * finish.red, level.glow * finish.green, level.glow * finish.blue);
            return;
        }
        Choice choice = lighting.choice;
        boolean scatters = choice.at(level, finish);
        // The direction depends on none of the lights: chosen before they are looked for, it is ready when the way to them is found.
        boolean isChosen = scatters && choice.diffuse == 1;
        if (isChosen) {
            diffuse(level, depth);
        }
        if (finish.isLit()) {
            lighting.illuminate(depth, level, finish);
        }
        if (scatters) {
            goOn(level, depth, finish, choice, isChosen);
        }
    }

    private void goOn(Level level, int depth, Finish finish, Choice choice, boolean isChosen) {
        double which = 0;
        double end = 0;
        if (choice.diffuse < 1 || depth + 1 >= ROULETTE) {
            sampler.choice(level.path);
            sampler.next();
            which = sampler.u;
            end = sampler.v;
        }
        if (which < choice.diffuse) {
            double k = finish.diffusion / choice.diffuse;
            if (!isChosen) {
                diffuse(level, depth);
            }
            strew(level, depth, finish, end, k * level.colorRed, k * level.colorGreen, k * level.colorBlue);
        } else if (which < choice.diffuse + choice.highlight) {
            double k = finish.highlights / choice.highlight;
            highlight(level, finish);
            strew(level, depth, finish, end, k, k, k);
        } else {
            turn(level, depth, finish, end, 1 / choice.rest, (which - choice.diffuse - choice.highlight) / choice.rest);
        }
    }

    /** Chooses a direction above the surface, as often as its cosine is large. */
    private void diffuse(Level level, int depth) {
        sampler.strew(level.path, asked[depth]);
        around(level.hit.sx, level.hit.sy, level.hit.sz, sampler.x, sampler.y, sampler.z);
    }

    /** Chooses a direction around the mirrored one, as often as the highlight is bright there. */
    private void highlight(Level level, Finish finish) {
        sampler.direction(level.path);
        sampler.next();
        double cosine = StrictMath.pow(sampler.u, 1 / (finish.material.shininess() + 1));
        double sine = Math.sqrt(1 - cosine * cosine);
        turn.by(sampler.v);
        around(level.mirrorX, level.mirrorY, level.mirrorZ, sine * turn.cosine, sine * turn.sine, cosine);
    }

    /**
     * Goes in a direction about another one, as it is about the z axis.
     *
     * @source Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6(1), 2017
     */
    private void around(double x, double y, double z, double p, double q, double cosine) {
        double sign = z < 0 ? -1 : 1;
        double a = -1 / (sign + z);
        double b = x * y * a;
        way.along(cosine * x + p * (1 + sign * x * x * a) + q * b, cosine * y + p * sign * b + q * (sign + y * y * a), cosine * z - p * sign * x - q * y);
    }

    /** Goes on the way that was chosen, unless it leads into the surface. */
    private void strew(Level level, int depth, Finish finish, double end, double red, double green, double blue) {
        Hit hit = level.hit;
        if (!(way.x * hit.nx + way.y * hit.ny + way.z * hit.nz > 0) || !(way.x * hit.sx + way.y * hit.sy + way.z * hit.sz > 0)) {
            return;
        }
        Level next = levels[depth + 1];
        offspring.back(level, next, way.x, way.y, way.z);
        next.isLit = true;
        next.density = density(level, finish);
        follow(level, depth, false, end, red, green, blue);
    }

    private double density(Level level, Finish finish) {
        if (finish.alpha > 0) {
            Hit hit = level.hit;
            lighting.lookAlong(level, finish, way, way.x * hit.sx + way.y * hit.sy + way.z * hit.sz);
        }
        return lighting.choice.density(level, finish, way);
    }

    /**
     * Goes on mirrored, or beyond the surface.
     *
     * @param k how much more that counts, because it was chosen among others
     * @param which random, 0–1
     */
    private void turn(Level level, int depth, Finish finish, double end, double k, double which) {
        Level next = levels[depth + 1];
        onward.decide(level, next, finish);
        boolean isRough = finish.alpha > 0;
        double chance = onward.chance();
        boolean isMirrored = isRough ? onward.mirrored() > 0 : which < chance;
        double weight = isRough ? k : k / (isMirrored ? chance : 1 - chance);
        if (isMirrored) {
            way.along(onward.x, onward.y, onward.z);
            offspring.back(level, next, way.x, way.y, way.z);
        } else if (onward.through > 0) {
            way.along(onward.throughX, onward.throughY, onward.throughZ);
            offspring.on(level, next, finish, way.x, way.y, way.z);
        } else {
            return;
        }
        if (isRough) {
            next.isLit = true;
            next.density = density(level, finish);
        }
        follow(level, depth, !isMirrored, end, weight * (isMirrored ? onward.red : onward.through), weight * (isMirrored ? onward.green : onward.through),
                weight * (isMirrored ? onward.blue : onward.through));
    }

    /** The greatest of three numbers, which of them can be foretold. */
    private static double most(double red, double green, double blue) {
        double most = green > red ? green : red;
        return blue > most ? blue : most;
    }

    private void follow(Level level, int depth, boolean refracted, double end, double red, double green, double blue) {
        Level next = levels[depth + 1];
        double weight = level.weight * most(red, green, blue);
        double k = 1;
        if (depth + 1 >= ROULETTE) {
            double stays = Math.min(1, weight);
            if (!(end < stays)) {
                return;
            }
            k = 1 / stays;
        }
        next.weight = k * weight;
        next.shareRed = k * red;
        next.shareGreen = k * green;
        next.shareBlue = k * blue;
        witness.following(refracted, next.shareRed, next.shareGreen, next.shareBlue);
        goesOn = true;
    }
}
