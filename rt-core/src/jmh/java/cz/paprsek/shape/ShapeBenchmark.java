package cz.paprsek.shape;

import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
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

/** A ray and one shape, turned and stretched; more than half of the rays meet it. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class ShapeBenchmark {
    @Param({"Sphere", "Block", "Ellipsoid", "Plane", "Cylinder", "Cone", "Torus", "Rectangle", "Disc", "Csg"})
    private String shape;

    private final Rays rays = new Rays(new Spans());
    private Surface surface;

    @Setup
    public void place() {
        Shape example = Examples.ALL.entrySet().stream().filter(entry -> entry.getKey().getSimpleName().equals(shape)).findAny().orElseThrow().getValue();
        Placement placement = Placement.NONE.withRotation(new Vec3(20, 50, -70)).withScale(new Vec3(1, 1.3, 0.8));
        surface = example.place(placement.toParent(), new TestParts());
    }

    @Benchmark
    public double nearest() {
        Ray ray = rays.next();
        surface.nearest(ray);
        return ray.max;
    }

    @Benchmark
    public boolean occludes() {
        return surface.occludes(rays.next());
    }
}
