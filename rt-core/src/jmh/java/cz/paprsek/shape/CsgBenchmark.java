package cz.paprsek.shape;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
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

/** A ray and one solid of many operands: balls strewn in a cube, joined, or taken out of it. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class CsgBenchmark {
    @Param({"2", "8", "30", "100", "300", "1000"})
    private int operands;

    private final Spans spans = new Spans();
    private final Rays rays = new Rays(spans);
    private Volume union;
    private Volume difference;

    @Setup
    public void place() {
        Random random = new Random(2);
        double radius = Math.cbrt(0.3 / operands);
        Operand[] balls = IntStream.range(0, operands).mapToObj(i -> Operand.of(new Sphere(radius))
                .at(2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1)).toArray(Operand[]::new);
        union = Csg.union(balls).place(Affine.IDENTITY, new TestParts());
        balls[0] = Operand.of(new Block(new Vec3(-1, -1, -1), new Vec3(1, 1, 1)));
        difference = Csg.difference(balls).place(Affine.IDENTITY, new TestParts());
    }

    @Benchmark
    public int union() {
        spans.release(0);
        union.spans(rays.next(), spans);
        return spans.size();
    }

    @Benchmark
    public int difference() {
        spans.release(0);
        difference.spans(rays.next(), spans);
        return spans.size();
    }
}
