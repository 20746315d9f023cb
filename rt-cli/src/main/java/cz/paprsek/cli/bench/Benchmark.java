package cz.paprsek.cli.bench;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.value.Size;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Mesh;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Measures scenes: each is prepared and rendered several times, in turn with the other program if there is one, so that what disturbs the
 * machine disturbs both. The median counts.
 *
 * @param size of the pictures, if not the scenes' own
 * @param rounds how often each scene is rendered and counted
 * @param opponent whom to compare with
 */
record Benchmark(Stop stop, Optional<Size> size, int threads, int rounds, Optional<Rival> opponent) {
    /** A scene is prepared more than once only as long as that takes less than so many seconds. */
    private static final double BUILDING = 10;

    /**
     * What was measured of one scene: medians, seconds.
     *
     * @param objects how many there are; where there are meshes, how many triangles, those of one mesh in many places counted once
     * @param trace the time on the clock that one picture took
     * @param bytes the memory that the scene and all that was prepared of it take
     * @param cpu the processor time of all workers for it
     * @param opponentCpu that of the opponent; not a number if there is none
     * @param least the least ratio of a single round
     * @param most the greatest
     */
    record Result(String name, int objects, RenderResult.Stats rays, long bytes, double build, double trace, double cpu, double opponentCpu,
            double least, double most) {
        double raysPerSecond() {
            return rays.rays() / Math.max(trace, 1e-9);
        }

        /** Of the processor. */
        double nanosPerRay() {
            return cpu * 1e9 / Math.max(rays.rays(), 1);
        }

        double bytesPerObject() {
            return (double) bytes / Math.max(objects, 1);
        }

        /** How many times the opponent's processor time is ours. */
        double ratio() {
            return opponentCpu / Math.max(cpu, 1e-9);
        }
    }

    /** @throws InterruptedIOException if a stop was asked for */
    Result run(String name) throws IOException {
        long before = usedBytes();
        Scene standard = BenchScenes.make(name);
        Scene scene = size.map(s -> standard.withSettings(standard.settings().withSize(s.width(), s.height()))).orElse(standard);
        RenderOptions options = RenderOptions.of(scene).withThreads(threads);
        double[] build = new double[rounds];
        RenderScene first = RenderScene.of(scene);
        long bytes = Math.max(0, usedBytes() - before);
        RenderScene ready = prepare(name, scene, first, build);
        double[] trace = new double[rounds];
        double[] cpu = new double[rounds];
        double[] theirs = new double[rounds];
        RenderResult.Stats rays = RenderResult.Stats.NONE;
        warmUp(name, scene, ready, options);
        for (int i = 0; i < rounds; i++) {
            CpuTime time = new CpuTime(stop);
            rays = Renderer.render(ready, options, time).stats();
            checkStop();
            theirs[i] = opponent.isPresent() ? opponent.get().seconds(name, scene, threads) : Double.NaN;
            checkStop();
            trace[i] = rays.traceSeconds();
            cpu[i] = time.seconds();
        }
        return new Result(name, size(scene), rays, bytes, median(build), median(trace), median(cpu), median(theirs),
                ratios(theirs, cpu).min().orElse(Double.NaN), ratios(theirs, cpu).max().orElse(Double.NaN));
    }

    /** Renders what does not count, until there is little left to compile. */
    private void warmUp(String name, Scene scene, RenderScene ready, RenderOptions options) throws IOException {
        WarmUp warmUp = new WarmUp();
        do {
            Renderer.render(ready, options, new CpuTime(stop));
            checkStop();
            if (opponent.isPresent() && opponent.get().warmsUp()) {
                opponent.get().seconds(name, scene, threads);
                checkStop();
            }
        } while (warmUp.goesOn());
    }

    private static int size(Scene scene) {
        int triangles = meshes(scene).mapToInt(mesh -> mesh.triangles().count()).sum();
        return triangles == 0 ? scene.objects().size() : triangles;
    }

    private static Stream<Mesh> meshes(Scene scene) {
        return scene.objects().stream().map(SceneObject::shape).filter(Mesh.class::isInstance).map(Mesh.class::cast).distinct();
    }

    /** Prepares a scene again and again: with new meshes, for these keep what has been made of them. */
    private RenderScene prepare(String name, Scene scene, RenderScene first, double[] seconds) throws InterruptedIOException {
        boolean isNew = meshes(scene).findAny().isPresent();
        RenderScene ready = first;
        double spent = ready.buildSeconds();
        for (int i = 0; i < rounds; i++) {
            if (spent < BUILDING) {
                ready = RenderScene.of(isNew ? BenchScenes.make(name) : scene);
                spent += ready.buildSeconds();
            }
            seconds[i] = ready.buildSeconds();
            checkStop();
        }
        return ready;
    }

    private static DoubleStream ratios(double[] theirs, double[] ours) {
        return IntStream.range(0, ours.length).mapToDouble(i -> theirs[i] / Math.max(ours[i], 1e-9));
    }

    private void checkStop() throws InterruptedIOException {
        if (stop.requested()) {
            throw new InterruptedIOException("interrupted");
        }
    }

    @SuppressWarnings("SystemGc") // What is in use is known only after what is not has been collected.
    private static long usedBytes() {
        System.gc();
        return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }
}
