package cz.paprsek.render.buffer;

import cz.paprsek.shape.placed.Balls;
import cz.paprsek.shape.placed.Surface;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * The light buffers of a set of bodies: each is made when it is first asked for, which should be after so many shadow rays that it is worth it. What is found with them is what trees find. For any number
 * of threads.
 */
public final class LightBuffers {
    /** So many are kept, the latest. */
    private static final int MOST = 16;
    /** Among fewer bodies trees are as fast; more would take long to make. */
    private static final int LEAST_BODIES = 16;
    private static final int MOST_BODIES = 1 << 18;
    /** So many shadow rays are sent without, for each body and at least: to make one takes as long as some such. */
    private static final int LEAST_RAYS = 1 << 15;

    private final LightBufferBuilder builder;
    private final int bodies;
    private final Map<LightPlace, Optional<LightBuffer>> made = new LinkedHashMap<>();

    /** Of bodies that all have an end. */
    public LightBuffers(Surface[] surfaces, Balls balls, boolean[] opaque) {
        builder = new LightBufferBuilder(surfaces, balls, opaque);
        bodies = surfaces.length;
    }

    /** After how many shadow rays to one light its buffer is worth being made; never if it is not. */
    public int raysBefore() {
        return bodies < LEAST_BODIES || bodies > MOST_BODIES ? Integer.MAX_VALUE : Math.max(LEAST_RAYS, bodies);
    }

    /** That of a light if it has been made. */
    public synchronized Optional<LightBuffer> known(LightPlace light) {
        return made.getOrDefault(light, Optional.empty());
    }

    /** That of a light, which is made unless it is there; empty if it is better without, or if it is told to stop. */
    public synchronized Optional<LightBuffer> of(LightPlace light, BooleanSupplier stop) {
        Optional<LightBuffer> known = made.get(light);
        if (known != null) {
            return known;
        }
        Optional<LightBuffer> buffer = builder.build(light, stop);
        if (!stop.getAsBoolean()) {
            made.put(light, buffer);
            for (Iterator<LightPlace> oldest = made.keySet().iterator(); made.size() > MOST;) {
                oldest.next();
                oldest.remove();
            }
        }
        return buffer;
    }
}
