package cz.paprsek.cli.bench;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.image.Image;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.Tile;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Watches how much processor time the workers of one render use: unlike the time on a clock, that hardly depends on what else the machine
 * is doing. A worker's threads begin with the render, so what each has used when it finishes a tile is what the render has cost so far.
 */
final class CpuTime implements RenderMonitor {
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final Map<Thread, Long> nanos = new ConcurrentHashMap<>();
    private final Stop stop;

    CpuTime(Stop stop) {
        this.stop = stop;
    }

    @Override
    public boolean cancelled() {
        return stop.requested();
    }

    @Override
    public void finished(Tile tile, Image image, int done, int total) {
        nanos.put(Thread.currentThread(), threads.getCurrentThreadCpuTime());
    }

    /** All workers' time together. */
    double seconds() {
        return nanos.values().stream().mapToLong(Long::longValue).sum() / 1e9;
    }
}
