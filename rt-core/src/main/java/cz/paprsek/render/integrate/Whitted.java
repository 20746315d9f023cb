package cz.paprsek.render.integrate;

import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.light.Glows;
import cz.paprsek.render.sample.PixelSums;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Backdrop;
import cz.paprsek.render.surface.Bodies;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.PartTable;
import cz.paprsek.render.surface.World;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.tree.Bundle;
import cz.paprsek.tree.Entries;
import java.util.function.BooleanSupplier;

/**
 * Follows rays and shades what they hit: one worker's scratch and the formulas of the picture. Nothing is allocated once it is made.
 *
 * <pre>B = ambient·C + Σ lights V·I·( kD·C·max(0, N·L) + kS·max(0, R·L)ⁿ ) + kR·trace(R) + kT·trace(T)</pre>
 */
public class Whitted extends Witness implements Integrator {
    /** How many rays are traced between two questions whether to stop. */
    private static final int BATCH = 64;
    /** Into how many subtrees a block's search is split at most: as measured. Rays stop at the first that lies behind what they hit. */
    private static final int MOST_ENTRIES = 24;

    private final World scene;
    private BooleanSupplier stop = () -> false;
    private final Spans spans = new Spans();
    private final Bodies bodies;
    private final PartTable parts;
    private final Glows glows;
    private final Lighting lighting;
    private final Intersector intersector;
    private final CameraRays cameraRays;
    private final Level[] levels;
    /** For each level but the first: how the ray came about, if that takes more than two shares. */
    private final Scatter[] scatters;
    private final Sampling sampling;
    /** What is random: started for a sample of a pixel before its ray is, and anew before the block's hits are shaded, if there is a light that asks. */
    private final Sampler sampler;
    private final boolean dims;
    private final Dimming dimming;
    private final Backdrop backdrop;
    /** Whether rays know how far their neighbours are: only if a paint asks for it. */
    private final boolean footprints;
    private final double[] ambient;
    private final Arrival seen = new Arrival();
    private final Bundle bundle = new Bundle();
    private final Entries entries = new Entries(MOST_ENTRIES);
    private final PixelSums sums;
    private Level[] block = {};
    private Level[] further = {};

    public long primary;
    public long reflected;
    public long refracted;
    public boolean cancelled;

    public Whitted(World scene, int maxDepth, Sampling sampling) {
        this.scene = scene;
        this.bodies = scene.bodies();
        this.parts = scene.parts();
        this.glows = scene.glows();
        this.intersector = new Intersector(scene, spans);
        this.sampling = sampling;
        this.sampler = sampling.newSampler();
        this.cameraRays = new CameraRays(scene, sampling, sampler);
        this.sums = sampling.newSums();
        this.lighting = new Lighting(scene, maxDepth, intersector, spans, sampler, this, this::isToStop);
        this.dims = scene.absorbs();
        this.dimming = new Dimming(scene);
        this.levels = new Level[maxDepth];
        this.scatters = new Scatter[maxDepth];
        for (int i = 0; i < maxDepth; i++) {
            levels[i] = new Level(spans);
            scatters[i] = new Scatter(scene, sampler, this);
        }
        levels[0].path = Sampler.EYE;
        backdrop = scene.sky();
        footprints = scene.parts().havePictures();
        ambient = linear(scene.ambient());
    }

    private static double[] linear(cz.paprsek.material.Rgb color) {
        return new double[] {color.linearRed(), color.linearGreen(), color.linearBlue()};
    }

    @Override
    public final void begin(BooleanSupplier whenToStop) {
        stop = whenToStop;
        primary = 0;
        reflected = 0;
        refracted = 0;
        intersector.hits = 0;
        lighting.rays = 0;
        cancelled = false;
    }

    /** Renders a block of pixels. */
    @Override
    public void block(Eye eye, int x, int y, int width, int height, Film film) {
        Level[] rays = trace(eye, x, y, width, height);
        for (int i = 0; i < width * height && !cancelled; i++) {
            if (sampling.isPlain()) {
                film.set(x + i % width, y + i / width, rays[i].red, rays[i].green, rays[i].blue);
            } else {
                develop(rays, i, eye, x + i % width, y + i / width, film);
            }
        }
    }

    private void develop(Level[] rays, int pixel, Eye eye, int x, int y, Film film) {
        sums.clear();
        add(rays, pixel * sampling.rays(), sampling.rays());
        complete(eye, x, y);
        sums.mean();
        film.set(x, y, sums.red, sums.green, sums.blue);
    }

    /** Traces all rays of a pixel, and says what they come to. */
    public final PixelSums pixel(Eye eye, int x, int y) {
        sums.clear();
        add(trace(eye, x, y, 1, 1), 0, sampling.rays());
        complete(eye, x, y);
        sums.mean();
        return sums;
    }

    /** Traces all rays of a pixel one by one, as if there were no others; how many, is told. */
    protected final int eachAlone(Eye eye, int x, int y) {
        sums.clear();
        for (int more = sampling.rays(); more > 0 && !cancelled; more = sampling.further(sums)) {
            for (int i = 0; i < more; i++) {
                traceAlone(eye, x, y, sums.count());
                add(levels, 0, 1);
                tracedAlone();
            }
        }
        return sums.count();
    }

    /** One of a pixel's rays has been traced by itself; the light it brought is in {@link #alone}. */
    protected void tracedAlone() {}

    private void complete(Eye eye, int x, int y) {
        for (int more = sampling.further(sums); more > 0 && !cancelled; more = sampling.further(sums)) {
            further = levels(further, more);
            trace(eye, x, y, 1, 1, sums.count(), more, further);
            add(further, 0, more);
        }
    }

    private void add(Level[] rays, int from, int count) {
        for (int i = from; i < from + count; i++) {
            sums.add(rays[i].red, rays[i].green, rays[i].blue, rays[i].isNegative);
        }
    }

    @Override
    public final boolean isCancelled() {
        return cancelled;
    }

    @Override
    public final Work work() {
        return new Work(primary, reflected, refracted, lighting.rays, intersector.hits);
    }

    /**
     * Traces the rays that every pixel of a block gets; the light they bring is in the levels returned, pixel by pixel. What they can meet, and
     * what can stand between their hits and each light, is found once for all; the light is the same as for each ray alone.
     */
    public final Level[] trace(Eye eye, int x, int y, int width, int height) {
        block = levels(block, width * height * sampling.rays());
        trace(eye, x, y, width, height, 0, sampling.rays(), block);
        return block;
    }

    private void trace(Eye eye, int x, int y, int width, int height, int sample, int perPixel, Level[] first) {
        int rays = width * height * perPixel;
        int reach = sampling.reach();
        Entries among = bodies.whole();
        if (eye.bundle(bundle, x - reach, y - reach, width + 2 * reach, height + 2 * reach)) {
            bodies.enter(bundle, entries);
            among = entries;
        }
        cameraRays.from(eye);
        int i = 0;
        for (int row = y; row < y + height; row++) {
            for (int column = x; column < x + width; column++) {
                for (int k = 0; k < perPixel; k++) {
                    if (cameraRays.start(first[i], eye, column, row, sample + k)) {
                        intersector.find(first[i], among);
                    }
                    i++;
                }
            }
        }
        primary += rays;
        lighting.prepare(first, rays);
        boolean isRandom = lighting.isRandom();
        for (i = 0; i < rays; i++) {
            if (isRandom) {
                int pixel = i / perPixel;
                sampler.start(x + pixel % width, y + pixel / width, sample + i % perPixel);
            }
            shade(first[i], 0);
        }
    }

    /** The same, or more if there are too few. */
    private Level[] levels(Level[] made, int size) {
        if (made.length >= size) {
            return made;
        }
        Level[] levels = new Level[size];
        for (int i = 0; i < size; i++) {
            levels[i] = new Level(spans);
            levels[i].path = Sampler.EYE;
        }
        return levels;
    }

    /** The level of a ray that is traced by itself: to be started by {@link #startAlone}, then traced by {@link #traceAlone()}. */
    public final Level alone() {
        return levels[0];
    }

    /** Starts the ray of {@link #alone} through a point of the picture, where it is in what is around there. */
    public final void startAlone(Eye eye, double x, double y) {
        cameraRays.from(eye);
        cameraRays.start(levels[0], eye, x, y);
    }

    /** Starts the ray of {@link #alone} anywhere, in a direction of length 1. */
    public final void startAlone(Vec3 origin, Vec3 direction) {
        cameraRays.start(levels[0], origin, direction);
    }

    /** Finds what the ray of {@link #alone} hits. */
    public final void findAlone() {
        intersector.find(levels[0], bodies.whole());
    }

    /** Traces a sample's ray from the eye by itself; the light it brings is in {@link #alone}. */
    public final void traceAlone(Eye eye, int column, int row, int sample) {
        cameraRays.from(eye);
        cameraRays.start(levels[0], eye, column, row, sample);
        sampler.start(column, row, sample);
        traceAlone();
    }

    /** Traces the ray of {@link #alone}, as if it were that of the first sample of the first pixel. */
    public final void traceAlone() {
        primary++;
        lighting.prepareNothing();
        trace(0);
    }

    private void trace(int depth) {
        Level level = levels[depth];
        if (cancelled || ((primary + reflected + refracted) % BATCH == 0 && isToStop())) {
            level.light(0, 0, 0);
            return;
        }
        if (!level.ray.isBlind()) {
            intersector.find(level, bodies.whole());
        }
        shade(level, depth);
    }

    private boolean isToStop() {
        cancelled = cancelled || stop.getAsBoolean();
        return cancelled;
    }

    /** Nodes of the tree visited so far, leaves included, those of bundles not. */
    public final long nodeVisits() {
        return intersector.nodeVisits();
    }

    @Override
    public final long rays() {
        return primary + reflected + refracted + lighting.rays;
    }

    /** Finds the place of the level's hit in a picture that covers the surface. */
    protected final void map(Level level) {
        intersector.map(level);
    }

    private void shade(Level level, int depth) {
        Ray ray = level.ray;
        if (ray.part < 0) {
            miss(level);
            return;
        }
        if (glows.has(ray.part)) {
            glow(level);
            return;
        }
        Hit hit = level.hit;
        Finish finish = parts.finish(ray.part);
        if (finish.paint.isMapped()) {
            map(level);
        }
        if (footprints) {
            level.part = parts.part(ray.part);
            level.footprint.meet(ray, hit);
        }
        finish.paint.color(level);
        double cosine = ray.dx * hit.nx + ray.dy * hit.ny + ray.dz * hit.nz;
        boolean leaving = cosine > 0;
        if (leaving) {
            hit.turn();
        }
        double c = Math.abs(cosine);
        double mirrorX = ray.dx + 2 * c * hit.sx;
        double mirrorY = ray.dy + 2 * c * hit.sy;
        double mirrorZ = ray.dz + 2 * c * hit.sz;
        double size = hit.size;

        level.light(ambient[0] * level.colorRed, ambient[1] * level.colorGreen, ambient[2] * level.colorBlue);
        met(level, leaving, c, mirrorX, mirrorY, mirrorZ, size);
        if (finish.glows) {
            emit(level, finish);
        }
        if (finish.isLit()) {
            lighting.illuminate(depth, level, finish, leaving, mirrorX, mirrorY, mirrorZ);
        }
        if (depth + 1 < levels.length && (finish.reflection > 0 || finish.transparency > 0)) {
            if (finish.isPlain) {
                spawn(level, levels[depth + 1], depth + 1, finish, leaving, c, mirrorX, mirrorY, mirrorZ, size);
            } else {
                scatter(level, levels[depth + 1], depth + 1, finish, leaving, c, size);
            }
        }
        if (dims) {
            dim(level);
        }
        ended(level);
    }

    private void emit(Level level, Finish finish) {
        level.add(finish.red, finish.green, finish.blue);
        emitted(finish.red, finish.green, finish.blue);
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
        level.light(seen.red, seen.green, seen.blue);
        if (dims) {
            dim(level);
        }
        seen(level, glows.lamp(ray.part));
    }

    private void miss(Level level) {
        boolean isBlind = level.ray.isBlind();
        int sun = isBlind || level.isLit ? Glows.NONE : glows.sky(level.ray.dx, level.ray.dy, level.ray.dz, seen);
        if (sun == Glows.NONE) {
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
        } else {
            level.light(seen.red, seen.green, seen.blue);
            if (dims) {
                dim(level);
            }
            seen(level, sun);
        }
    }

    /**
     * Adds what is mirrored and what shines through. With e = n₁/n₂ and t = 1 + e²(c² − 1), the refracted direction is e·u + (e·c − √t)·N;
     * if t is negative all light is reflected, with the weight of both.
     *
     * @param c cosine of the angle between the ray and the normal, 0–1
     * @source Whitted, An Improved Illumination Model for Shaded Display, CACM 23(6), 1980
     */
    private void spawn(Level level, Level next, int depth, Finish finish, boolean leaving, double c,
            double mirrorX, double mirrorY, double mirrorZ, double size) {
        Ray ray = level.ray;
        Hit hit = level.hit;
        double reflection = finish.reflection;
        double e = 1;
        double root = c;
        boolean refracts = finish.transparency > 0;
        if (refracts) {
            double from = level.media.refractiveIndex();
            double to = scene.enterBeyond(level, finish, leaving, next.media);
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
            sendBack(level, next, leaving, mirrorX, mirrorY, mirrorZ, size);
            following(false, reflection, reflection, reflection);
            trace(depth);
            level.add(reflection, next);
        }
        if (refracts) {
            double k = e * c - root;
            sendOn(level, next, finish, leaving, e * ray.dx + k * hit.sx, e * ray.dy + k * hit.sy, e * ray.dz + k * hit.sz, size);
            following(true, finish.transparency, finish.transparency, finish.transparency);
            trace(depth);
            level.add(finish.transparency, next);
        }
    }

    /** The same where shares depend on the angle. */
    private void scatter(Level level, Level next, int depth, Finish finish, boolean leaving, double c, double size) {
        Scatter to = scatters[depth];
        to.decide(level, next, finish, leaving, c);
        if (to.mirrored() > 0) {
            sendBack(level, next, leaving, to.x, to.y, to.z, size);
            next.isLit = finish.looksForLamps;
            following(false, to.red, to.green, to.blue);
            trace(depth);
            level.add(to.red, to.green, to.blue, next);
        }
        if (to.through > 0) {
            sendOn(level, next, finish, leaving, to.throughX, to.throughY, to.throughZ, size);
            next.isLit = finish.looksForLamps;
            following(true, to.through, to.through, to.through);
            trace(depth);
            level.add(to.through, next);
        }
    }

    /** Starts a ray on the side of a hit from which that was seen. */
    private void sendBack(Level level, Level next, boolean leaving, double x, double y, double z, double size) {
        Ray ray = level.ray;
        Hit hit = level.hit;
        next.ray.start(hit.px, hit.py, hit.pz, x, y, z, size, Double.POSITIVE_INFINITY, ray.part, leaving != ray.face < 0);
        next.beyond = false;
        next.isLit = false;
        next.path = Sampler.mirrored(level.path);
        Lighting.backFrom(level, next.ray);
        if (footprints) {
            next.footprint.mirrored(level.footprint, ray, hit, parts.part(ray.part));
        }
        next.media.set(level.media);
        reflected++;
    }

    /** Starts a ray beyond the surface of a hit. */
    private void sendOn(Level level, Level next, Finish finish, boolean leaving, double x, double y, double z, double size) {
        Ray ray = level.ray;
        Hit hit = level.hit;
        next.ray.start(hit.px, hit.py, hit.pz, x, y, z, size, Double.POSITIVE_INFINITY, ray.part, leaving == ray.face < 0);
        next.beyond = true;
        next.isLit = false;
        next.path = Sampler.refracted(level.path);
        double beyond = scene.enterBeyond(level, finish, leaving, next.media);
        if (footprints) {
            next.footprint.refracted(level.footprint, ray, hit, parts.part(ray.part), level.media.refractiveIndex() / beyond);
        }
        refracted++;
    }
}
