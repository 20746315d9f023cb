package cz.paprsek.render.integrate;

import cz.paprsek.material.Rgb;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.glow.Glows;
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

/** Follows rays and tells what light they bring, all but what surfaces scatter: one worker's scratch. Nothing is allocated once it is made. */
abstract class Shading implements Integrator {
    /** How many rays are traced between two questions whether to stop: a power of two. */
    private static final int BATCH = 64;

    final World scene;
    /** Is told every term. */
    final Witness witness;
    private BooleanSupplier stop = () -> false;
    private final PartTable parts;
    final Glows glows;
    private final Backdrop backdrop;
    private final Entries whole;
    final Intersector intersector;
    final Lighting lighting;
    /** What is random: started for a sample of a pixel before its ray is, and anew before the block's hits are shaded, if there is a light that asks. */
    final Sampler sampler;
    final Offspring offspring;
    final Level[] levels;
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

    Shading(World scene, int maxDepth, Sampler sampler, boolean isPath, Spans spans, Witness witness) {
        this.scene = scene;
        this.witness = witness;
        this.sampler = sampler;
        this.parts = scene.parts();
        this.glows = scene.glows();
        this.backdrop = scene.sky();
        this.whole = scene.bodies().whole();
        this.intersector = new Intersector(scene, spans);
        this.lighting = new Lighting(scene, maxDepth, isPath, intersector, spans, sampler, witness, this::isToStop);
        this.offspring = new Offspring(scene);
        this.dims = scene.absorbs();
        this.dimming = new Dimming(scene);
        this.levels = new Level[maxDepth];
        for (int i = 0; i < maxDepth; i++) {
            levels[i] = new Level(spans);
        }
        levels[0].path = Sampler.EYE;
        footprints = scene.asksForFootprints();
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

    /** Traces the ray of a level that has been started. */
    final void trace(int depth) {
        if (find(levels[depth])) {
            shade(levels[depth], depth);
        }
    }

    /** Finds what the ray of a level hits that has been started; false if all is to stop, and there is no light. */
    final boolean find(Level level) {
        if (cancelled || (((primary + offspring.reflected + offspring.refracted) & (BATCH - 1)) == 0 && isToStop())) {
            level.light(0, 0, 0);
            return false;
        }
        if (!level.ray.isBlind()) {
            intersector.find(level, whole);
        }
        return true;
    }

    /** Finds the light that a ray brings of which is known what it hits. */
    void shade(Level level, int depth) {
        if (arrive(level)) {
            scatter(level, depth, level.finish);
            leave(level);
        }
    }

    /** Finds the light that the ray's end gives off; whether that is a surface, which may send on other light: then it is known what that is like. */
    final boolean arrive(Level level) {
        int part = level.ray.part;
        if (part < 0) {
            miss(level);
            return false;
        }
        if (glows.has(part)) {
            glow(level);
            return false;
        }
        Finish finish = color(level, parts.finish(part));
        level.finish = finish;
        face(level);
        level.light(ambientRed * level.colorRed, ambientGreen * level.colorGreen, ambientBlue * level.colorBlue);
        witness.met(level);
        if (finish.glows) {
            emit(level, finish);
        }
        return true;
    }

    /** Adds the light that the surface gives off, as far as that was not looked for. */
    void emit(Level level, Finish finish) {
        level.add(finish.red, finish.green, finish.blue);
        witness.emitted(finish.red, finish.green, finish.blue);
    }

    /** Brings the light of a surface back along the ray. */
    final void leave(Level level) {
        if (dims) {
            dim(level);
        }
        witness.ended(level);
    }

    /** Of a light that was also looked for where the level's ray starts, the share that it brings nevertheless. */
    abstract double unlit(Level level, int lamp);

    /** Adds to the level's light what its surface sends on of the light that falls on it. */
    abstract void scatter(Level level, int depth, Finish finish);

    /** Finds the colour, and what else the surface is at the hit. */
    private Finish color(Level level, Finish finish) {
        if (footprints) {
            level.part = parts.part(level.ray.part, level.copied);
            level.footprint.meet(level.ray, level.hit);
        }
        if (!finish.isEven) {
            return finish.at(level);
        }
        if (finish.paint.isMapped()) {
            scene.map(level);
        }
        finish.paint.color(level);
        return finish;
    }

    /** Turns the normals to the viewer, and finds the mirrored direction. */
    private static void face(Level level) {
        Ray ray = level.ray;
        Hit hit = level.hit;
        double away = ray.dx * hit.nx + ray.dy * hit.ny + ray.dz * hit.nz;
        level.leaving = away > 0;
        if (level.leaving) {
            hit.turn();
        }
        level.isBent = hit.sx != hit.nx || hit.sy != hit.ny || hit.sz != hit.nz;
        double c = Math.abs(away);
        if (level.isBent) {
            Bent.towardsViewer(ray, hit);
            c = Math.abs(ray.dx * hit.sx + ray.dy * hit.sy + ray.dz * hit.sz);
        }
        level.cosine = c;
        level.mirrorX = ray.dx + 2 * c * hit.sx;
        level.mirrorY = ray.dy + 2 * c * hit.sy;
        level.mirrorZ = ray.dz + 2 * c * hit.sz;
        if (level.isBent) {
            Bent.mirror(level);
        }
    }

    /** Takes from the level's light what the substance takes that its ray comes through. */
    private void dim(Level level) {
        int object = level.media.innermost();
        double way = level.ray.part < 0 ? Double.POSITIVE_INFINITY : level.ray.max;
        dimming.clear();
        if (!level.ray.isBlind() && dimming.go(object, way)) {
            dimming.finish();
            level.light(dimming.red * level.red, dimming.green * level.green, dimming.blue * level.blue);
            witness.absorbed(object, way, dimming.red, dimming.green, dimming.blue);
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
        see(level, glows.lamp(ray.part));
    }

    private void miss(Level level) {
        boolean isBlind = level.ray.isBlind();
        int sun = isBlind ? Glows.NONE : glows.sky(level.ray.dx, level.ray.dy, level.ray.dz, seen);
        if (sun != Glows.NONE && !(level.isLit && unlit(level, sun) == 0)) {
            see(level, sun);
            return;
        }
        if (isBlind) {
            level.light(0, 0, 0);
        } else {
            seeSky(level);
        }
        if (dims) {
            dim(level);
        }
        witness.missed(level);
    }

    /** The ray sees what is behind everything, as far as that was not looked for. */
    void seeSky(Level level) {
        backdrop.look(level);
        level.light(level.hit.red, level.hit.green, level.hit.blue);
    }

    private void see(Level level, int lamp) {
        double share = level.isLit ? unlit(level, lamp) : 1;
        level.light(share * seen.red, share * seen.green, share * seen.blue);
        if (dims) {
            dim(level);
        }
        witness.seen(level, lamp);
    }
}
