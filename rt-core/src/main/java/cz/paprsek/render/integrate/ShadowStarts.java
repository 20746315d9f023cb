package cz.paprsek.render.integrate;

import cz.paprsek.ray.Hit;
import cz.paprsek.render.buffer.LightBuffer;
import cz.paprsek.render.buffer.LightBuffers;
import cz.paprsek.render.buffer.LightPlace;
import cz.paprsek.render.light.Lamp;
import cz.paprsek.render.surface.Bodies;
import cz.paprsek.render.surface.Level;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.tree.Bundle;
import cz.paprsek.tree.Entries;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Where shadow rays look for what stands in their way: scratch of one worker. For those of a block of rays it is found out once for all of them where in the tree that is; and once so many have been sent to a light that
 * comes from one place that it is worth it, they ask a {@link LightBuffer}.
 */
final class ShadowStarts {
    /** Into how many subtrees the search of a block's shadow rays is split at most: as measured. */
    private static final int MOST_ENTRIES = 8;

    private static final int NEVER = Integer.MAX_VALUE;

    private final Bodies bodies;
    private final Lamp[] lamps;
    private final Bundle hits = new Bundle();
    /** The least {@link Hit#size} of those hits. */
    private double smallest;
    private final Bundle bundle = new Bundle();
    private final Entries[] towardsLamp;
    /** By light. */
    private final Entries[] between;
    private final Entries anywhere;
    private final BooleanSupplier stop;
    private final Optional<LightBuffers> makers;
    /** Whether all is found by trees. */
    private final boolean isPlain;
    /** By light, if it has one by now. */
    private final @Nullable LightBuffer[] buffers;
    /** By light: how many rays are to be sent before it is asked whether it has one. */
    private final int[] before;

    ShadowStarts(Bodies bodies, Lamp[] lamps, BooleanSupplier stop) {
        this.bodies = bodies;
        this.lamps = lamps;
        this.stop = stop;
        this.makers = bodies.buffers();
        this.isPlain = makers.isEmpty();
        this.buffers = new LightBuffer[lamps.length];
        this.before = new int[lamps.length];
        begin();
        this.towardsLamp = Stream.generate(() -> new Entries(MOST_ENTRIES)).limit(lamps.length).toArray(Entries[]::new);
        this.between = new Entries[lamps.length];
        this.anywhere = bodies.whole();
    }

    /** All lights that come from one place begin with what is known, unless they are too many. */
    private void begin() {
        Arrays.fill(before, NEVER);
        LightBuffers maker = makers.orElse(null);
        if (maker == null || Stream.of(lamps).filter(lamp -> lamp.place().isPresent()).count() > LightBuffers.MOST) {
            return;
        }
        for (int light = 0; light < lamps.length; light++) {
            Optional<LightPlace> place = lamps[light].place();
            if (place.isPresent()) {
                before[light] = maker.raysBefore();
                buffers[light] = maker.known(place.get()).orElse(null);
            }
        }
    }

    /** Where in the tree to look for what stands between a light and a hit of a level. */
    Entries of(int depth, int light) {
        return depth == 0 ? between[light] : anywhere;
    }

    /**
     * Looks for what stands between the min and max of a shadow ray.
     *
     * @param among where in the tree it would be
     * @param through as in {@link Bodies#occluder}
     */
    @Nullable Surface occluder(int light, Ray shadow, Entries among, Bodies.Finder finder, Spans through) {
        if (isPlain) {
            return bodies.occluder(shadow, among, finder, through);
        }
        return byBuffer(light, shadow, among, finder, through);
    }

    private @Nullable Surface byBuffer(int light, Ray shadow, Entries among, Bodies.Finder finder, Spans through) {
        LightBuffer buffer = buffers[light];
        if (buffer == null) {
            if (before[light] != NEVER && --before[light] == 0) {
                ask(light);
            }
        } else if (buffer.knows(shadow)) {
            return bodies.occluder(shadow, buffer, through);
        }
        return bodies.occluder(shadow, among, finder, through);
    }

    /** Asks for the light's buffer; if there is none, after as many rays again. */
    private void ask(int light) {
        LightBuffers maker = makers.orElseThrow();
        Optional<LightPlace> place = lamps[light].place();
        buffers[light] = place.isPresent() ? maker.of(place.get(), stop).orElse(null) : null;
        before[light] = maker.raysBefore();
    }

    /** From now on all rays ask the tree, whatever was found before. */
    void forget() {
        Arrays.fill(buffers, null);
        Arrays.fill(before, NEVER);
    }

    /** Finds out what can stand between each light and the hits of a block: to be called before these are lit, on level 0. */
    void prepare(Level[] block, int count) {
        gather(block, count);
        if (smallest == Double.POSITIVE_INFINITY) {
            prepareNothing();
            return;
        }
        for (int light = 0; light < lamps.length; light++) {
            if (buffers[light] == null && lamps[light].bundle(hits, bundle)) {
                // Not the last bit before a hit, which keeps the surfaces that were hit out: a shadow ray begins at TOUCH · size, and a tenth
                // less leaves room for rounding.
                bundle.end(1 - 0.9 * Ray.TOUCH * smallest / bundle.longest());
                bodies.enter(bundle, towardsLamp[light]);
                between[light] = towardsLamp[light];
            } else {
                between[light] = anywhere;
            }
        }
    }

    /** Before a hit of a ray that is traced by itself is lit, on level 0. */
    void prepareNothing() {
        for (int light = 0; light < lamps.length; light++) {
            between[light] = anywhere;
        }
    }

    /** Bundles the lines from the origin to all hits. */
    private void gather(Level[] first, int count) {
        hits.start(0, 0, 0);
        smallest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            if (first[i].ray.part >= 0) {
                Hit hit = first[i].hit;
                hits.add(hit.px, hit.py, hit.pz);
                smallest = hit.size < smallest ? hit.size : smallest;
            }
        }
    }
}
