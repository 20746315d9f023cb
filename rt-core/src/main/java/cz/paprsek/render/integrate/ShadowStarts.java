package cz.paprsek.render.integrate;

import cz.paprsek.ray.Hit;
import cz.paprsek.render.light.Lamp;
import cz.paprsek.render.surface.Bodies;
import cz.paprsek.render.surface.Level;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.tree.Bundle;
import cz.paprsek.tree.Entries;
import java.util.stream.Stream;

/** Where the shadow rays of a block of rays look for what stands in their way, found out once for all of them: scratch of one worker. */
final class ShadowStarts {
    /** Into how many subtrees the search of a block's shadow rays is split at most: as measured. */
    private static final int MOST_ENTRIES = 8;

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

    ShadowStarts(Bodies bodies, Lamp[] lamps) {
        this.bodies = bodies;
        this.lamps = lamps;
        this.towardsLamp = Stream.generate(() -> new Entries(MOST_ENTRIES)).limit(lamps.length).toArray(Entries[]::new);
        this.between = new Entries[lamps.length];
        this.anywhere = bodies.whole();
    }

    /** Where to look for what stands between the hits and a light. */
    Entries of(int light) {
        return between[light];
    }

    /** Finds out what can stand between each light and the hits of a block: to be called before these are lit, on level 0. */
    void prepare(Level[] block, int count) {
        gather(block, count);
        if (smallest == Double.POSITIVE_INFINITY) {
            prepareNothing();
            return;
        }
        for (int light = 0; light < lamps.length; light++) {
            if (lamps[light].bundle(hits, bundle)) {
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
