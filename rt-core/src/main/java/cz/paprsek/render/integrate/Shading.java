package cz.paprsek.render.integrate;

import cz.paprsek.material.Rgb;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.light.Glows;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.surface.Backdrop;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.PartTable;
import cz.paprsek.render.surface.World;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.tree.Entries;
import java.util.function.BooleanSupplier;

/**
 * Follows rays and shades what they hit: one worker's scratch and the formulas of the picture. Nothing is allocated once it is made.
 *
 * <pre>B = ambient·C + Σ lights V·I·( kD·C·max(0, N·L) + kS·max(0, R·L)ⁿ ) + kR·trace(R) + kT·trace(T)</pre>
 */
abstract class Shading extends Witness implements Integrator {
    /** How many rays are traced between two questions whether to stop. */
    private static final int BATCH = 64;

    private final World scene;
    private BooleanSupplier stop = () -> false;
    private final PartTable parts;
    private final Glows glows;
    private final Backdrop backdrop;
    private final Entries whole;
    final Intersector intersector;
    final Lighting lighting;
    /** What is random: started for a sample of a pixel before its ray is, and anew before the block's hits are shaded, if there is a light that asks. */
    final Sampler sampler;
    private final Offspring offspring;
    final Level[] levels;
    /** For each level but the first: how the ray came about, if that takes more than two shares. */
    private final Scatter[] scatters;
    private final boolean dims;
    private final Dimming dimming;
    /** Whether rays know how far their neighbours are: only if a paint asks for it. */
    private final boolean footprints;
    private final double ambientRed;
    private final double ambientGreen;
    private final double ambientBlue;
    private final Arrival seen = new Arrival();

    long primary;
    boolean cancelled;

    Shading(World scene, int maxDepth, Sampler sampler, Spans spans) {
        this.scene = scene;
        this.sampler = sampler;
        this.parts = scene.parts();
        this.glows = scene.glows();
        this.backdrop = scene.sky();
        this.whole = scene.bodies().whole();
        this.intersector = new Intersector(scene, spans);
        this.lighting = new Lighting(scene, maxDepth, intersector, spans, sampler, this, this::isToStop);
        this.offspring = new Offspring(scene);
        this.dims = scene.absorbs();
        this.dimming = new Dimming(scene);
        this.levels = new Level[maxDepth];
        this.scatters = new Scatter[maxDepth];
        for (int i = 0; i < maxDepth; i++) {
            levels[i] = new Level(spans);
            scatters[i] = new Scatter(scene, sampler, this);
        }
        levels[0].path = Sampler.EYE;
        footprints = parts.havePictures();
        Rgb ambient = scene.ambient();
        ambientRed = ambient.linearRed();
        ambientGreen = ambient.linearGreen();
        ambientBlue = ambient.linearBlue();
    }

    @Override
    public final void begin(BooleanSupplier whenToStop) {
        stop = whenToStop;
        primary = 0;
        offspring.reflected = 0;
        offspring.refracted = 0;
        intersector.hits = 0;
        lighting.rays = 0;
        cancelled = false;
    }

    private boolean isToStop() {
        cancelled = cancelled || stop.getAsBoolean();
        return cancelled;
    }

    @Override
    public final boolean isCancelled() {
        return cancelled;
    }

    @Override
    public final Work work() {
        return new Work(primary, offspring.reflected, offspring.refracted, lighting.rays, intersector.hits);
    }

    @Override
    public final long rays() {
        return primary + offspring.reflected + offspring.refracted + lighting.rays;
    }

    /** Finds the place of the level's hit in a picture that covers the surface. */
    protected final void map(Level level) {
        intersector.map(level);
    }

    /** Traces the ray of a level that has been started. */
    final void trace(int depth) {
        Level level = levels[depth];
        if (cancelled || ((primary + offspring.reflected + offspring.refracted) % BATCH == 0 && isToStop())) {
            level.light(0, 0, 0);
            return;
        }
        if (!level.ray.isBlind()) {
            intersector.find(level, whole);
        }
        shade(level, depth);
    }

    /** Finds the light that a ray brings of which is known what it hits. */
    final void shade(Level level, int depth) {
        int part = level.ray.part;
        if (part < 0) {
            miss(level);
            return;
        }
        if (glows.has(part)) {
            glow(level);
            return;
        }
        Finish finish = parts.finish(part);
        color(level, finish);
        face(level);
        level.light(ambientRed * level.colorRed, ambientGreen * level.colorGreen, ambientBlue * level.colorBlue);
        met(level);
        if (finish.glows) {
            level.add(finish.red, finish.green, finish.blue);
            emitted(finish.red, finish.green, finish.blue);
        }
        if (finish.isLit()) {
            lighting.illuminate(depth, level, finish);
        }
        if (depth + 1 < levels.length && (finish.reflection > 0 || finish.transparency > 0)) {
            if (finish.isPlain) {
                spawn(level, levels[depth + 1], depth + 1, finish);
            } else {
                scatter(level, levels[depth + 1], depth + 1, finish);
            }
        }
        if (dims) {
            dim(level);
        }
        ended(level);
    }

    private void color(Level level, Finish finish) {
        if (finish.paint.isMapped()) {
            map(level);
        }
        if (footprints) {
            level.part = parts.part(level.ray.part);
            level.footprint.meet(level.ray, level.hit);
        }
        finish.paint.color(level);
    }

    /** Turns the normals to the viewer, and finds the mirrored direction. */
    private static void face(Level level) {
        Ray ray = level.ray;
        Hit hit = level.hit;
        level.leaving = ray.dx * hit.nx + ray.dy * hit.ny + ray.dz * hit.nz > 0;
        if (level.leaving) {
            hit.turn();
        }
        double c = Math.abs(ray.dx * hit.sx + ray.dy * hit.sy + ray.dz * hit.sz);
        level.cosine = c;
        level.mirrorX = ray.dx + 2 * c * hit.sx;
        level.mirrorY = ray.dy + 2 * c * hit.sy;
        level.mirrorZ = ray.dz + 2 * c * hit.sz;
    }

    /** Takes from the level's light what the substance takes that its ray comes through. */
    private void dim(Level level) {
        int object = level.media.innermost();
        double way = level.ray.part < 0 ? Double.POSITIVE_INFINITY : level.ray.max;
        dimming.clear();
        if (!level.ray.isBlind() && dimming.go(object, way)) {
            dimming.finish();
            level.light(dimming.red * level.red, dimming.green * level.green, dimming.blue * level.blue);
            absorbed(object, way, dimming.red, dimming.green, dimming.blue);
        }
    }

    /** The ray sees a light's body, and ends there. */
    private void glow(Level level) {
        Ray ray = level.ray;
        Hit hit = level.hit;
        boolean isBehind = ray.dx * hit.nx + ray.dy * hit.ny + ray.dz * hit.nz > 0;
        if (isBehind) {
            hit.turn();
        }
        glows.shine(ray.part, isBehind, seen);
        if (level.isLit) {
            seen.light(0, 0, 0);
        }
        see(level, glows.lamp(ray.part));
    }

    private void miss(Level level) {
        boolean isBlind = level.ray.isBlind();
        int sun = isBlind || level.isLit ? Glows.NONE : glows.sky(level.ray.dx, level.ray.dy, level.ray.dz, seen);
        if (sun != Glows.NONE) {
            see(level, sun);
            return;
        }
        if (isBlind) {
            level.light(0, 0, 0);
        } else {
            backdrop.look(level);
            level.light(level.hit.red, level.hit.green, level.hit.blue);
        }
        if (dims) {
            dim(level);
        }
        missed(level);
    }

    private void see(Level level, int lamp) {
        level.light(seen.red, seen.green, seen.blue);
        if (dims) {
            dim(level);
        }
        seen(level, lamp);
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
            bent(from, to, c, t);
            refracts = t >= 0;
            if (refracts) {
                root = Math.sqrt(t);
            } else {
                reflection += finish.transparency;
            }
        }
        if (reflection > 0) {
            offspring.back(level, next, level.mirrorX, level.mirrorY, level.mirrorZ);
            following(false, reflection, reflection, reflection);
            trace(depth);
            level.add(reflection, next);
        }
        if (refracts) {
            double k = e * c - root;
            offspring.on(level, next, finish, e * ray.dx + k * hit.sx, e * ray.dy + k * hit.sy, e * ray.dz + k * hit.sz);
            following(true, finish.transparency, finish.transparency, finish.transparency);
            trace(depth);
            level.add(finish.transparency, next);
        }
    }

    /** The same where shares depend on the angle. */
    private void scatter(Level level, Level next, int depth, Finish finish) {
        Scatter to = scatters[depth];
        to.decide(level, next, finish);
        if (to.mirrored() > 0) {
            offspring.back(level, next, to.x, to.y, to.z);
            next.isLit = finish.looksForLamps;
            following(false, to.red, to.green, to.blue);
            trace(depth);
            level.add(to.red, to.green, to.blue, next);
        }
        if (to.through > 0) {
            offspring.on(level, next, finish, to.throughX, to.throughY, to.throughZ);
            next.isLit = finish.looksForLamps;
            following(true, to.through, to.through, to.through);
            trace(depth);
            level.add(to.through, next);
        }
    }
}
