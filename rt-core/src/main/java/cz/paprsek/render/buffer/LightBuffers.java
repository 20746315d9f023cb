package cz.paprsek.render.buffer;

import cz.paprsek.shape.placed.Balls;
import cz.paprsek.shape.placed.Surface;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;

/**
 * The light buffers of a set of bodies: each is made when it is first asked for, which should be after so many shadow rays that it is worth it. What is found with them is what trees find. For any number
 * of threads.
 */
public final class LightBuffers {
    /** So many are kept, the latest. A scene with more lights that come from one place has none. */
    public static final int MOST = 8;
    /** Among fewer bodies trees are as fast; of more a buffer takes long to make, and much memory. */
    private static final int LEAST_BODIES = 16;
    private static final int MOST_BODIES = 1 << 17;
    /** So many shadow rays are sent without, for each body and at least: to make one takes as long as some such. */
    private static final int LEAST_RAYS = 1 << 15;
    /** More than a body takes in a buffer and to make it, in bytes, and so much at least; of the memory that is free a quarter may be taken. */
    private static final long EACH = 256;
    private static final long LEAST_BYTES = 1 << 24;
    private static final int SHARE = 4;

    private final LightBufferBuilder builder;
    private final int bodies;
    private final ReentrantLock lock = new ReentrantLock();
    /** Those that have been made, or are not worth it, the oldest first. Replaced, never changed. */
    private volatile Map<LightPlace, Optional<LightBuffer>> made = Map.of();

    /** Of bodies that all have an end. */
    public LightBuffers(Surface[] surfaces, Balls balls, boolean[] opaque) {
        builder = new LightBufferBuilder(surfaces, balls, opaque);
        bodies = surfaces.length;
    }

    /** After how many shadow rays to one light its buffer is worth being asked for; never if it is not. */
    public int raysBefore() {
        return bodies < LEAST_BODIES || bodies > MOST_BODIES ? Integer.MAX_VALUE : Math.max(LEAST_RAYS, bodies);
    }

    /** That of a light if it has been made. */
    public Optional<LightBuffer> known(LightPlace light) {
        return made.getOrDefault(light, Optional.empty());
    }

    /**
     * That of a light, which is made unless it is there.
     *
     * @return empty if it is better without, if another thread makes one at this moment, if memory is short, or if it is told to stop
     */
    public Optional<LightBuffer> of(LightPlace light, BooleanSupplier stop) {
        if (!lock.tryLock()) {
            return Optional.empty();
        }
        try {
            Optional<LightBuffer> known = made.get(light);
            return known == null ? make(light, stop) : known;
        } finally {
            lock.unlock();
        }
    }

    private Optional<LightBuffer> make(LightPlace light, BooleanSupplier stop) {
        if (isMemoryShort()) {
            return Optional.empty();
        }
        Optional<LightBuffer> buffer = builder.build(light, stop);
        if (buffer.isEmpty() && stop.getAsBoolean()) {
            return buffer;
        }
        Map<LightPlace, Optional<LightBuffer>> all = new LinkedHashMap<>(made);
        if (all.size() == MOST) {
            all.remove(all.keySet().iterator().next());
        }
        all.put(light, buffer);
        made = all;
        return buffer;
    }

    private boolean isMemoryShort() {
        Runtime runtime = Runtime.getRuntime();
        long free = runtime.maxMemory() - (runtime.totalMemory() - runtime.freeMemory());
        return (LEAST_BYTES + EACH * bodies) * SHARE > free;
    }
}
