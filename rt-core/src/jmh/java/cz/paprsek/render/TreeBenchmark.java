package cz.paprsek.render;

import cz.paprsek.render.surface.Bodies;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.Rays;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.standard.StandardScenes;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** The hierarchy over a cloud of spheres: the search for the nearest hit and for any, all by random rays, and preparing the scene. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@Fork(value = 1, jvmArgs = "-Xmx6g")
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class TreeBenchmark {
    @Param({"1000", "100000", "1000000"})
    private int spheres;

    private final Spans spans = new Spans();
    private final Rays rays = new Rays(spans);
    private Scene scene;
    private Bodies bodies;
    private Bodies.Finder finder;

    @Setup
    public void prepare() {
        scene = StandardScenes.cloud(spheres);
        bodies = build().world().bodies();
        finder = bodies.newFinder();
    }

    @Benchmark
    @OutputTimeUnit(TimeUnit.NANOSECONDS)
    public double nearest() {
        Ray ray = rays.next();
        bodies.nearest(ray, bodies.whole(), finder);
        return ray.max;
    }

    @Benchmark
    @OutputTimeUnit(TimeUnit.NANOSECONDS)
    public boolean any() {
        spans.release(0);
        return bodies.occluder(rays.next(), bodies.whole(), finder, spans) != null;
    }

    @Benchmark
    @OutputTimeUnit(TimeUnit.MILLISECONDS)
    public RenderScene build() {
        return RenderScene.of(scene);
    }
}
