package cz.paprsek.render.integrate;

import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.glow.Glows;
import cz.paprsek.render.glow.SkyLamp;
import cz.paprsek.render.glow.SkyLight;
import cz.paprsek.render.light.Emitters;
import cz.paprsek.render.light.Lamp;
import cz.paprsek.render.light.ManyLamps;
import cz.paprsek.render.light.PointLamp;
import cz.paprsek.render.sample.Asked;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.surface.Bodies;
import cz.paprsek.render.surface.Contacts;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.Media;
import cz.paprsek.render.surface.PartTable;
import cz.paprsek.render.surface.World;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.tree.Entries;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.IntPredicate;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Adds what the lights bring to a hit, and looks what stands in their way: scratch of one worker. A light with a size is looked for at several
 * points, and brings the mean.
 */
final class Lighting {
    /** How many shadow rays of lights with a size are sent between two questions whether to stop: one ray may need those of many lights. */
    private static final int BATCH = 4096;
    /** For so many points of lights it is kept where they are: a power of two. */
    private static final int MOST_ASKED = 256;
    /** For a light that is looked for at one point. */
    private static final double MIDDLE = 0.5;

    private final Witness witness;
    /** Whether a path that goes on may meet a light that it was looked for: then both are weighed, and a light with a size is looked for at one point only. */
    private final boolean isPath;
    /** Whether lights behind a surface are passed over. */
    private final boolean isBrief;
    private final BooleanSupplier stop;
    private final Sampler sampler;
    private final Bodies bodies;
    private final PartTable parts;
    /** All that is looked for: the scene's lights, and for paths bodies that shine, and last a picture that is the sky. */
    final Lamp[] lamps;
    final Emitters emitters;
    /** Of many bodies that shine, the lamp that is one of them at a time. */
    private final Optional<ManyLamps> chosen;
    private final int lights;
    final Optional<SkyLight> sky;
    private final boolean isRandom;
    private final Glows glows;
    private final Bodies.Finder finder;
    private final Contacts contacts;
    private final Veils veils;
    private final Spans spans;
    private final Ray shadow;
    /** What arrives of the light that is looked for. */
    final Arrival arrival = new Arrival();
    /** What last stood between a point and each light, by level of recursion and light: likely to stand there again. */
    private final @Nullable Surface[] lastOccluder;
    /** What a path last asked the sampler, likewise: of many lights, by the last digits of that. */
    private final Asked[] asked;
    /** Where shadow rays on level 0 look for what stands in their way. */
    final ShadowStarts starts;
    private final Entries anywhere;
    /** Whether substances weaken light on its way, and by how much along the last shadow ray. */
    private final boolean dims;
    private final Dimming dimming;
    private final IntPredicate isMet = this::isMet;
    private Media around = new Media();
    /** Whether the shadow ray starts beyond the surface it comes from. */
    private boolean isBeyond;
    /** What a rough surface strews; of lights that rays can see, its rays see it. */
    private final Lobe lobe;
    /** Of a path, how it goes on. */
    final Choice choice;
    private final boolean[] isSeen;
    /** What lights the hits of a block at once; empty if more is asked of light than that. */
    final Optional<BlockLighting> ofBlocks;
    private boolean isStrewing;
    /** What the light that was last looked for brings along its shadow ray. */
    private double red;
    private double green;
    private double blue;

    private int sent;

    /** Shadow rays sent so far. */
    long rays;

    Lighting(World scene, int maxDepth, boolean isPath, Intersector intersector, Spans spans, Sampler sampler, Witness witness, BooleanSupplier stop) {
        this.witness = witness;
        this.isPath = isPath;
        this.isBrief = !witness.hearsAll();
        this.stop = stop;
        this.sampler = sampler;
        this.bodies = scene.bodies();
        this.parts = scene.parts();
        this.emitters = isPath ? scene.emitters() : Emitters.NONE;
        this.sky = isPath ? scene.sky().picture() : Optional.empty();
        this.chosen = emitters.chosen();
        this.lights = scene.lamps().length;
        this.lamps = emitters.after(scene.lamps(), chosen, sky.map(picture -> new SkyLamp(picture, scene.glows())));
        this.isRandom = Stream.of(lamps).anyMatch(lamp -> lamp.samples() > 1) || scene.isRough() || isPath;
        this.glows = scene.glows().forOneWorker();
        this.finder = intersector.finder;
        this.contacts = intersector.contacts;
        this.spans = spans;
        this.veils = new Veils(parts, spans);
        this.shadow = new Ray(spans);
        this.lastOccluder = new Surface[maxDepth * lamps.length];
        this.asked = Asked.none(Integer.highestOneBit(Math.min(MOST_ASKED, 2 * lastOccluder.length + 1)));
        this.starts = new ShadowStarts(bodies, lamps, stop);
        this.anywhere = bodies.whole();
        this.dims = scene.absorbs();
        this.dimming = new Dimming(scene);
        this.lobe = new Lobe(scene);
        this.choice = new Choice(lobe);
        this.isSeen = new boolean[lamps.length];
        for (int i = 0; i < lamps.length; i++) {
            isSeen[i] = i >= scene.lamps().length || glows.show(i);
        }
        this.ofBlocks = isRandom || dims || !glows.areNone() || witness.getClass() != Witness.class ? Optional.empty() : BlockLighting.of(this, lamps);
    }

    /** Whether something is random at a hit, points of a light or what becomes of a ray: then the sampler is to be started before each hit is lit. */
    boolean isRandom() {
        return isRandom;
    }

    /**
     * Adds the diffuse and specular part of all lights to the level's light. Too long for the JVM to put it into what calls it, by whichever is compiled first: both together would be too large for
     * all that they call.
     *
     * @param depth the level's number, from 0
     */
    void illuminate(int depth, Level level, Finish finish) {
        isStrewing = finish.alpha > 0;
        if (isStrewing) {
            lobe.at(level, finish);
        }
        for (int light = 0; light < lamps.length; light++) {
            Lamp lamp = lamps[light];
            if (lamp instanceof PointLamp point) {
                if (isBrief && point.isBehind(level.hit) && !isStrewing) {
                    continue;
                }
                point.sample(level.hit, MIDDLE, MIDDLE, arrival);
                add(look(depth, light, true, level, finish), level);
            } else if (lamp.samples() == 1) {
                boolean shines = lamp.sample(level.hit, MIDDLE, MIDDLE, arrival);
                add(look(depth, light, shines, level, finish), level);
            } else if (isPath) {
                // One point is looked for, without the loop of a mean.
                if (isToStop(1)) {
                    return;
                }
                sampler.light(level.path, light, asked[(depth * lamps.length + light) & (asked.length - 1)]);
                sampler.next();
                boolean shines = lamp.sample(level.hit, sampler.u, sampler.v, arrival);
                if (!look(depth, light, shines, level, finish)) {
                    red = 0;
                    green = 0;
                    blue = 0;
                }
                level.add(red, green, blue);
                witness.averaged(told(light), red, green, blue);
            } else {
                average(depth, light, level, finish);
            }
        }
    }

    /** Looks with the lobe of the hit that was lit last in a direction of which the cosine is known. */
    void lookAlong(Level level, Finish finish, Arrival way, double cosine) {
        lobe.look(level, finish, way, cosine);
    }

    private void add(boolean brings, Level level) {
        if (brings) {
            level.add(red, green, blue);
        }
    }

    /** Asks now and then whether all is to stop, before so many shadow rays. */
    private boolean isToStop(int more) {
        sent += more;
        if (sent < BATCH) {
            return false;
        }
        boolean stops = stop.getAsBoolean();
        sent = stops ? sent : 0;
        return stops;
    }

    /** Adds the mean of what several points of the light bring. */
    private void average(int depth, int light, Level level, Finish finish) {
        int samples = lamps[light].samples();
        double sumRed = 0;
        double sumGreen = 0;
        double sumBlue = 0;
        if (isToStop(samples)) {
            return;
        }
        sampler.lights(level.path, light, samples);
        for (int i = 0; i < samples; i++) {
            sampler.next();
            boolean shines = lamps[light].sample(level.hit, sampler.u, sampler.v, arrival);
            if (look(depth, light, shines, level, finish)) {
                sumRed += red;
                sumGreen += green;
                sumBlue += blue;
            }
        }
        double share = 1.0 / samples;
        level.add(sumRed * share, sumGreen * share, sumBlue * share);
        witness.averaged(told(light), sumRed * share, sumGreen * share, sumBlue * share);
    }

    /** The number by which a light is known that was looked for last: of many bodies that shine, that of the one which was chosen. */
    private int told(int light) {
        return light < lights || chosen.isEmpty() ? light : light == lights ? lights + chosen.get().chosen() : emitters.end();
    }

    /** How probable it is that a ray's direction is chosen to look for the light with a number, which it meets. */
    double density(int number, Ray ray) {
        if (chosen.isPresent() && emitters.has(number)) {
            return chosen.get().density(number - lights, ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, ray.max);
        }
        return lamps[number].density(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, ray.max);
    }

    /** Looks along one shadow ray, that of the arrival: whether it brings anything. */
    private boolean look(int depth, int light, boolean sends, Level level, Finish finish) {
        Hit hit = level.hit;
        // What stands where the hit is lights nothing there: the way to it has no direction.
        boolean shines = sends && arrival.distance != 0;
        double facing = hit.sx * arrival.x + hit.sy * arrival.y + hit.sz * arrival.z;
        if (level.isBent) {
            facing = Bent.facing(hit, arrival, facing);
        }
        if (!shines) {
            arrival.light(0, 0, 0);
        }
        if (isStrewing) {
            return lookRoughly(depth, light, shines, level, finish, facing);
        }
        if (!shines || !(facing > 0)) {
            witness.sought(told(light), arrival, facing, 0);
            return false;
        }
        double visibility = reach(depth, light, level, finish, facing);
        if (!(visibility > 0)) {
            return false;
        }
        double diffuse = finish.diffusion * facing;
        double highlight = finish.specular == 0 ? 0 : finish.highlight(alignment(level));
        red = visibility * arrival.red * (diffuse * level.colorRed + highlight);
        green = visibility * arrival.green * (diffuse * level.colorGreen + highlight);
        blue = visibility * arrival.blue * (diffuse * level.colorBlue + highlight);
        witness.illuminated(diffuse, highlight, red, green, blue);
        return true;
    }

    /** The same at a rough surface, which also sends on what comes from beyond it. */
    private boolean lookRoughly(int depth, int light, boolean shines, Level level, Finish finish, double facing) {
        lobe.forget();
        boolean strews = shines && (isPath || !isSeen[light] || finish.looksForLamps) && lobe.look(level, finish, arrival, facing);
        boolean isBefore = facing > 0;
        if (!shines || !(strews || (isBefore && (finish.diffusion > 0 || finish.specular > 0)))) {
            if (isBefore) {
                arrival.light(0, 0, 0);
            }
            witness.sought(told(light), arrival, facing, 0);
            return false;
        }
        double visibility = reach(depth, light, level, finish, facing);
        if (!(visibility > 0)) {
            return false;
        }
        double diffuse = isBefore ? finish.diffusion * facing : 0;
        double highlight = isBefore ? finish.highlight(alignment(level)) : 0;
        red = visibility * arrival.red * (diffuse * level.colorRed + highlight + lobe.valueRed);
        green = visibility * arrival.green * (diffuse * level.colorGreen + highlight + lobe.valueGreen);
        blue = visibility * arrival.blue * (diffuse * level.colorBlue + highlight + lobe.valueBlue);
        if (strews) {
            witness.strewn(lobe.spread, lobe.seen(), lobe.lit, lobe.valueRed, lobe.valueGreen, lobe.valueBlue);
        }
        witness.illuminated(diffuse, highlight, red, green, blue);
        return true;
    }

    /** R·L. */
    private double alignment(Level level) {
        return level.mirrorX * arrival.x + level.mirrorY * arrival.y + level.mirrorZ * arrival.z;
    }

    /** Looks what stands in the way of the arrival, which becomes what gets through the substances there; the share of it that surfaces let through. */
    private double reach(int depth, int light, Level level, Finish finish, double facing) {
        veils.crossed = 0;
        double visibility = facing > 0 ? visibility(depth, light, level) : visibilityBeyond(depth, light, level);
        if (isPath && isSeen[light]) {
            visibility = weighed(light, level, finish, visibility);
        }
        boolean isDimmed = dims && visibility > 0;
        if (isDimmed) {
            witness.dimmed(dimming.red, dimming.green, dimming.blue);
        }
        witness.sought(told(light), arrival, facing, visibility);
        if (isDimmed) {
            arrival.light(arrival.red * dimming.red, arrival.green * dimming.green, arrival.blue * dimming.blue);
        }
        return visibility;
    }

    /** What is left for the shadow ray of a light that the path may meet when it goes on: nothing behind glass, where only paths find it. */
    private double weighed(int light, Level level, Finish finish, double visibility) {
        if (veils.crossed > 0 || visibility == 0) {
            return 0;
        }
        Hit hit = level.hit;
        double own = lamps[light].density(hit.px, hit.py, hit.pz, arrival.x, arrival.y, arrival.z, arrival.distance);
        return visibility * own / (own + choice.density(level, finish, arrival));
    }

    /** Of a light behind the surface, whose light comes through the body, or through a pane. */
    private double visibilityBeyond(int depth, int light, Level level) {
        rays++;
        Hit hit = level.hit;
        Ray ray = level.ray;
        shadow.start(hit.px, hit.py, hit.pz, arrival.x, arrival.y, arrival.z, hit.size, arrival.distance - Ray.TOUCH * hit.size, ray.part,
                level.leaving == ray.face < 0);
        isBeyond = true;
        double share = share(depth, light, anywhere, lobe.beyond);
        isBeyond = false;
        return share > 0 && glows.occludes(shadow, light) ? 0 : share;
    }

    /** Whether nothing can stand between a light and the hits of the block. */
    boolean isClear(int light) {
        return bodies.isClear(starts.of(0, light));
    }

    /** Looks what stands in the way of the arrival, on the side a surface was seen from: the share of it that is let through. */
    double visibility(int depth, int light, Level level) {
        rays++;
        Entries among = starts.of(depth, light);
        if (glows.areNone() && bodies.isClear(among) && !dims) {
            return 1;
        }
        Hit hit = level.hit;
        Ray ray = level.ray;
        shadow.start(hit.px, hit.py, hit.pz, arrival.x, arrival.y, arrival.z, hit.size, arrival.distance - Ray.TOUCH * hit.size, ray.part,
                level.leaving != ray.face < 0);
        backFrom(level, shadow);
        double share = share(depth, light, among, level.media);
        return share > 0 && glows.occludes(shadow, light) ? 0 : share;
    }

    /** Nothing that touches a surface lies on the side it was seen from, unless the ray that came has met it just before, in the same place. */
    static void backFrom(Level level, Ray ray) {
        if (level.ray.max > level.ray.contact) {
            ray.min = ray.contact;
        }
    }

    /** The share of a light that comes along the shadow ray: the product of the transparencies of all surfaces in between. */
    private double share(int depth, int light, Entries among, Media media) {
        int memory = depth * lamps.length + light;
        Surface last = lastOccluder[memory];
        if (last != null && last.occludes(shadow)) {
            return 0;
        }
        int mark = spans.size();
        Surface occluder = starts.occluder(light, shadow, among, finder, spans);
        double product = occluder == null ? 1 : 0;
        if (spans.size() > mark || dims) {
            around = media;
            product = occluder == null ? veils.product(shadow, spans, mark, isMet) : 0;
            if (dims && product > 0) {
                dimming.along(spans, mark, isMet, around, arrival.distance, Dimming.UNTOLD);
            }
            spans.release(mark);
        }
        if (occluder != last) {
            lastOccluder[memory] = occluder;
        }
        return product;
    }

    /** Forgets what last stood in the way. */
    void forget() {
        Arrays.fill(lastOccluder, null);
        starts.forget();
    }

    /** Whether the shadow ray meets a boundary that was found, which may lie in one place with its start. */
    private boolean isMet(int boundary) {
        return spans.t(boundary) > shadow.contact || contacts.counts(shadow, around, true, isBeyond, boundary);
    }
}
