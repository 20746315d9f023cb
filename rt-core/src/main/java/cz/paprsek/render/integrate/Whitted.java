package cz.paprsek.render.integrate;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.light.Arrival;
import cz.paprsek.render.light.Lamp;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Bodies;
import cz.paprsek.render.surface.Contacts;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.Media;
import cz.paprsek.render.surface.PartTable;
import cz.paprsek.render.surface.Surroundings;
import cz.paprsek.render.surface.World;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.tree.Bundle;
import cz.paprsek.tree.Entries;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Follows rays and shades what they hit: one worker's scratch and the formulas of the picture. Nothing is allocated once it is made.
 *
 * <pre>B = ambient·C + Σ lights V·I·( kD·C·max(0, N·L) + kS·max(0, R·L)ⁿ ) + kR·trace(R) + kT·trace(T)</pre>
 */
public class Whitted extends Witness implements Integrator {
    /** How many rays are traced between two questions whether to stop. */
    private static final int BATCH = 64;
    /** Into how many subtrees a block's search is split at most: as measured. Rays from the eye stop at the first that lies behind what they hit. */
    private static final int MOST_FROM_EYE = 24;
    private static final int MOST_FROM_LAMP = 8;

    private final World scene;
    private final BooleanSupplier stop;
    private final Spans spans = new Spans();
    private final Ray shadow = new Ray(spans);
    private final Bodies bodies;
    private final PartTable parts;
    private final Lamp[] lamps;
    private final Bodies.Finder finder;
    private final Level[] levels;
    private final Sampling sampling;
    /** What is random: started for a sample of a pixel before its ray is, and anew before the block's hits are shaded, if there is a light that asks. */
    private final Sampler sampler;
    private final boolean isRandom;
    private final double[] background;
    private final double[] ambient;
    /** What last stood between a point and each light, by level of recursion and light: likely to stand there again. */
    private final @Nullable Surface[] lastOccluder;
    private final Contacts contacts;
    private final Surroundings surroundings;
    private final Arrival arrival = new Arrival();
    private final Bundle bundle = new Bundle();
    private final Entries entries = new Entries(MOST_FROM_EYE);
    private final Entries[] towardsLamp;
    /** Where shadow rays of the block look for what stands in their way, by light. */
    private final Entries[] between;
    private final Entries[] anywhere;
    private Level[] block = {};
    private double[] shares = new double[16];

    public long primary;
    public long reflected;
    public long refracted;
    public long shadows;
    public long hits;
    public boolean cancelled;

    public Whitted(World scene, int maxDepth, Sampling sampling, BooleanSupplier stop) {
        this.scene = scene;
        this.stop = stop;
        this.bodies = scene.bodies();
        this.parts = scene.parts();
        this.lamps = scene.lamps();
        this.finder = bodies.newFinder();
        this.contacts = new Contacts(scene, finder, spans);
        this.surroundings = new Surroundings(scene);
        this.lastOccluder = new Surface[maxDepth * lamps.length];
        this.towardsLamp = Stream.generate(() -> new Entries(MOST_FROM_LAMP)).limit(lamps.length).toArray(Entries[]::new);
        this.between = new Entries[lamps.length];
        this.anywhere = Stream.generate(bodies::whole).limit(lamps.length).toArray(Entries[]::new);
        this.sampling = sampling;
        this.sampler = sampling.newSampler();
        this.isRandom = Stream.of(lamps).anyMatch(lamp -> lamp.samples() > 1);
        this.levels = new Level[maxDepth];
        for (int i = 0; i < maxDepth; i++) {
            levels[i] = new Level(spans);
        }
        levels[0].path = Sampler.EYE;
        background = linear(scene.background());
        ambient = linear(scene.ambient());
    }

    private static double[] linear(cz.paprsek.material.Rgb color) {
        return new double[] {color.linearRed(), color.linearGreen(), color.linearBlue()};
    }

    /** Renders a block of pixels, each the average of its rays. */
    @Override
    public void block(Eye eye, int x, int y, int width, int height, Film film) {
        Level[] rays = trace(eye, x, y, width, height);
        int perPixel = sampling.rays();
        double share = 1.0 / perPixel;
        for (int i = 0; i < width * height; i++) {
            double red = 0;
            double green = 0;
            double blue = 0;
            for (int j = i * perPixel; j < (i + 1) * perPixel; j++) {
                red += rays[j].red;
                green += rays[j].green;
                blue += rays[j].blue;
            }
            film.set(x + i % width, y + i / width, red * share, green * share, blue * share);
        }
    }

    @Override
    public final boolean isCancelled() {
        return cancelled;
    }

    @Override
    public final Work work() {
        return new Work(primary, reflected, refracted, shadows, hits);
    }

    /**
     * Traces the rays through a block of pixels, a grid of samples × samples in each; the light they bring is in the levels returned, pixel
     * by pixel. What they can meet, and what can stand between their hits and each light, is found once for all; the light is the same
     * as for each ray alone.
     */
    public final Level[] trace(Eye eye, int x, int y, int width, int height) {
        int perPixel = sampling.rays();
        int rays = width * height * perPixel;
        Level[] first = levels(rays);
        Entries among = bodies.whole();
        if (eye.bundle(bundle, x, y, width, height)) {
            bodies.enter(bundle, entries);
            among = entries;
        }
        surroundings.from(eye.origins());
        int i = 0;
        for (int row = y; row < y + height; row++) {
            for (int column = x; column < x + width; column++) {
                for (int k = 0; k < perPixel; k++) {
                    if (start(first[i], eye, column, row, k)) {
                        find(first[i], among);
                    }
                    i++;
                }
            }
        }
        primary += rays;
        for (int light = 0; light < lamps.length; light++) {
            if (gather(lamps[light], first, rays)) {
                bodies.enter(bundle, towardsLamp[light]);
                between[light] = towardsLamp[light];
            } else {
                between[light] = bodies.whole();
            }
        }
        for (i = 0; i < rays; i++) {
            if (isRandom) {
                int pixel = i / perPixel;
                sampler.start(x + pixel % width, y + pixel / width, i % perPixel);
            }
            shade(first[i], 0, between);
        }
        return first;
    }

    /** Starts a sample's ray from the eye, in what is around there; false if it is blind. */
    private boolean start(Level level, Eye eye, int column, int row, int sample) {
        double x = column + sampling.across(sample);
        double y = row + sampling.down(sample);
        boolean sees;
        if (eye.hasAperture()) {
            sampler.start(column, row, sample);
            sampler.lens();
            sampler.next();
            sees = eye.start(level.ray, x, y, sampler.u, sampler.v);
        } else {
            sees = eye.start(level.ray, x, y);
        }
        if (sees) {
            surroundings.enter(level.ray, level.media);
        }
        return sees;
    }

    /**
     * Bundles the lines from a lamp to all hits, as far as shadow rays look: not the last bit before a hit, which keeps the surfaces that
     * were hit out of the bundle. False if these lines cannot be bundled.
     */
    private boolean gather(Lamp lamp, Level[] first, int rays) {
        if (!lamp.start(bundle)) {
            return false;
        }
        double smallest = Double.POSITIVE_INFINITY;
        double farthest = 0;
        for (int i = 0; i < rays; i++) {
            Hit hit = first[i].hit;
            if (first[i].ray.part >= 0) {
                double reach = lamp.add(hit, bundle);
                smallest = hit.size < smallest ? hit.size : smallest;
                farthest = reach > farthest ? reach : farthest;
            }
        }
        // A shadow ray begins at TOUCH · size; a tenth less leaves room for rounding.
        bundle.end(1 - 0.9 * Ray.TOUCH * smallest / farthest);
        return true;
    }

    private Level[] levels(int size) {
        if (block.length < size) {
            block = new Level[size];
            for (int i = 0; i < size; i++) {
                block[i] = new Level(spans);
                block[i].path = Sampler.EYE;
            }
        }
        return block;
    }

    /** The level of a ray that is traced by itself: to be started by {@link #startAlone}, then traced by {@link #traceAlone()}. */
    public final Level alone() {
        return levels[0];
    }

    /** Starts the ray of {@link #alone} through a point of the picture, where it is in what is around there. */
    public final void startAlone(Eye eye, double x, double y) {
        if (eye.start(levels[0].ray, x, y)) {
            surroundings.from(eye.origins());
            surroundings.enter(levels[0].ray, levels[0].media);
        }
    }

    /** Starts the ray of {@link #alone} anywhere, in a direction of length 1. */
    public final void startAlone(Vec3 origin, Vec3 direction) {
        levels[0].ray.start(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
        surroundings.from(Bounds.ALL);
        surroundings.enter(levels[0].ray, levels[0].media);
    }

    /** Finds what the ray of {@link #alone} hits. */
    public final void findAlone() {
        find(levels[0], bodies.whole());
    }

    /** Traces a sample's ray from the eye by itself; the light it brings is in {@link #alone}. */
    public final void traceAlone(Eye eye, int column, int row, int sample) {
        surroundings.from(eye.origins());
        start(levels[0], eye, column, row, sample);
        sampler.start(column, row, sample);
        traceAlone();
    }

    /** Traces the ray of {@link #alone}, as if it were that of the first sample of the first pixel. */
    public final void traceAlone() {
        primary++;
        trace(0);
    }

    private void trace(int depth) {
        Level level = levels[depth];
        if ((primary + reflected + refracted) % BATCH == 0 && stop.getAsBoolean()) {
            cancelled = true;
        }
        if (cancelled) {
            level.light(0, 0, 0);
            return;
        }
        if (!level.ray.isBlind()) {
            find(level, bodies.whole());
        }
        shade(level, depth, anywhere);
    }

    /** Nodes of the tree visited so far, leaves included, those of bundles not. */
    public final long nodeVisits() {
        return finder.visits();
    }

    @Override
    public final long rays() {
        return primary + reflected + refracted + shadows;
    }

    /** Finds what the level's ray hits, and where. */
    private void find(Level level, Entries among) {
        Ray ray = level.ray;
        bodies.nearest(ray, among, finder);
        if (ray.part >= 0 && (ray.max <= ray.contact || level.media.areAround())) {
            contacts.settle(level);
        }
        if (ray.part >= 0) {
            hits++;
            locate(ray, level.hit);
        }
    }

    private void shade(Level level, int depth, Entries[] between) {
        Ray ray = level.ray;
        if (ray.part < 0) {
            boolean isBlind = ray.isBlind();
            level.light(isBlind ? 0 : background[0], isBlind ? 0 : background[1], isBlind ? 0 : background[2]);
            missed(level);
            return;
        }
        Hit hit = level.hit;
        Finish finish = parts.finish(ray.part);
        if (finish.paint.isMapped()) {
            map(level);
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
        if (finish.isLit()) {
            for (int i = 0; i < lamps.length; i++) {
                illuminate(depth, i, between[i], level, finish, leaving, mirrorX, mirrorY, mirrorZ, size);
            }
        }
        if (depth + 1 < levels.length && (finish.reflection > 0 || finish.transparency > 0)) {
            spawn(level, levels[depth + 1], depth + 1, finish, leaving, c, mirrorX, mirrorY, mirrorZ, size);
        }
        ended(level);
    }

    private void locate(Ray ray, Hit hit) {
        hit.px = ray.ox + ray.max * ray.dx;
        hit.py = ray.oy + ray.max * ray.dy;
        hit.pz = ray.oz + ray.max * ray.dz;
        hit.size = ray.max + Math.abs(hit.px) + Math.abs(hit.py) + Math.abs(hit.pz);
        boolean flipped = ray.face < 0;
        parts.part(ray.part).describe(flipped ? ~ray.face : ray.face, hit);
        if (flipped) {
            hit.turn();
        }
    }

    /** Finds the place of the level's hit in a picture that covers the surface. */
    protected final void map(Level level) {
        int face = level.ray.face;
        parts.part(level.ray.part).map(face < 0 ? ~face : face, level.hit);
    }

    /** Adds one light's diffuse and specular part. */
    private void illuminate(int depth, int light, Entries between, Level level, Finish finish, boolean leaving,
            double mirrorX, double mirrorY, double mirrorZ, double size) {
        Hit hit = level.hit;
        Lamp lamp = lamps[light];
        lamp.sample(hit, 0.5, 0.5, arrival);
        double lx = arrival.x;
        double ly = arrival.y;
        double lz = arrival.z;
        double distance = arrival.distance;
        double facing = hit.sx * lx + hit.sy * ly + hit.sz * lz;
        if (!(facing > 0)) {
            sought(light, lx, ly, lz, distance, facing, 0);
            return;
        }
        double visibility = 1;
        shadows++;
        if (!bodies.isClear(between)) {
            Ray ray = level.ray;
            shadow.start(hit.px, hit.py, hit.pz, lx, ly, lz, size, distance - Ray.TOUCH * size, ray.part, leaving != ray.face < 0);
            backFrom(level, shadow);
            visibility = visibility(depth * lamps.length + light, between, level.media);
        }
        sought(light, lx, ly, lz, distance, facing, visibility);
        if (visibility > 0) {
            double diffuse = finish.diffusion * facing;
            double highlight = finish.highlight(mirrorX * lx + mirrorY * ly + mirrorZ * lz);
            double red = visibility * lamp.red() * (diffuse * level.colorRed + highlight);
            double green = visibility * lamp.green() * (diffuse * level.colorGreen + highlight);
            double blue = visibility * lamp.blue() * (diffuse * level.colorBlue + highlight);
            level.add(red, green, blue);
            illuminated(diffuse, highlight, red, green, blue);
        }
    }

    /** Nothing that touches a surface lies on the side it was seen from, unless the ray that came has met it just before, in the same place. */
    private static void backFrom(Level level, Ray ray) {
        if (level.ray.max > level.ray.contact) {
            ray.min = ray.contact;
        }
    }

    /** The share of a light that comes along the shadow ray: the product of the transparencies of all surfaces in between. */
    private double visibility(int memory, Entries between, Media around) {
        Surface last = lastOccluder[memory];
        if (last != null && last.occludes(shadow)) {
            return 0;
        }
        int mark = spans.size();
        Surface occluder = bodies.occluder(shadow, between, finder, spans);
        double product = occluder == null ? product(mark, around) : 0;
        spans.release(mark);
        if (occluder != last) {
            lastOccluder[memory] = occluder;
        }
        return product;
    }

    /** The smallest share first, so that the product does not depend on the order in which the surfaces were found. */
    private double product(int mark, Media around) {
        int most = spans.size() - mark;
        if (most > shares.length) {
            shares = new double[2 * most];
        }
        int count = 0;
        for (int i = mark; i < mark + most; i++) {
            if (spans.t(i) <= shadow.contact && !contacts.counts(shadow, around, true, false, i)) {
                continue;
            }
            double share = parts.finish(spans.part(i)).transparency;
            int at = count++;
            for (; at > 0 && shares[at - 1] > share; at--) {
                shares[at] = shares[at - 1];
            }
            shares[at] = share;
        }
        double product = 1;
        for (int i = 0; i < count; i++) {
            product *= shares[i];
        }
        return product;
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
            double to = indexBeyond(level, next.media, finish, leaving);
            e = from / to;
            double t = 1 + e * e * (c * c - 1);
            bent(from, to, t);
            refracts = t >= 0;
            if (refracts) {
                root = Math.sqrt(t);
            } else {
                reflection += finish.transparency;
            }
        }
        if (reflection > 0) {
            next.ray.start(hit.px, hit.py, hit.pz, mirrorX, mirrorY, mirrorZ, size, Double.POSITIVE_INFINITY, ray.part, leaving != ray.face < 0);
            next.beyond = false;
            next.path = Sampler.mirrored(level.path);
            backFrom(level, next.ray);
            next.media.set(level.media);
            reflected++;
            following(false, reflection);
            trace(depth);
            level.add(reflection, next);
        }
        if (refracts) {
            double k = e * c - root;
            next.ray.start(hit.px, hit.py, hit.pz, e * ray.dx + k * hit.sx, e * ray.dy + k * hit.sy, e * ray.dz + k * hit.sz,
                    size, Double.POSITIVE_INFINITY, ray.part, leaving == ray.face < 0);
            next.beyond = true;
            next.path = Sampler.refracted(level.path);
            indexBeyond(level, next.media, finish, leaving);
            refracted++;
            following(true, finish.transparency);
            trace(depth);
            level.add(finish.transparency, next);
        }
    }

    /** Sets the media beyond the surface that the level's ray has hit, and returns their refractive index. A flat figure has no inside. */
    private double indexBeyond(Level level, Media beyond, Finish finish, boolean leaving) {
        beyond.set(level.media);
        int object = parts.object(level.ray.part);
        if (scene.isSolid(object)) {
            if (leaving) {
                beyond.leave(object);
            } else {
                beyond.enter(object, finish.refractiveIndex);
            }
        }
        return beyond.refractiveIndex();
    }
}
