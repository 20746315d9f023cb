package cz.paprsek.shape;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Csg.Operation;
import cz.paprsek.shape.placed.IntStack;
import cz.paprsek.shape.placed.Operands;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class OperandsTest {
    @ParameterizedTest
    @CsvSource({"UNION, 9", "UNION, 16", "UNION, 67", "DIFFERENCE, 9", "DIFFERENCE, 33", "DIFFERENCE, 100", "INTERSECTION, 12"})
    void manyOperandsGiveWhatOneAfterTheOtherGives(Operation operation, int count) {
        Random random = new Random(count);
        List<Operand> operands = operands(operation, count, random);
        Volume atOnce = place(new Csg(operation, operands));
        Operand folded = operands.get(0);
        for (Operand next : operands.subList(1, count)) {
            folded = Operand.of(new Csg(operation, List.of(folded, next)));
        }
        Volume oneByOne = place(folded.solid());
        Spans spans = new Spans();
        int hits = 0;
        for (int i = 0; i < 20_000; i++) {
            Ray a = ray(random.doubles(6, -3, 3).toArray(), spans);
            Ray b = new Ray(spans);
            b.start(a.ox, a.oy, a.oz, a.dx, a.dy, a.dz);
            assertThat(atOnce.occludes(a)).isEqualTo(oneByOne.occludes(b));
            atOnce.nearest(a);
            oneByOne.nearest(b);
            assertThat(List.of(a.max, a.part, a.face)).isEqualTo(List.of(b.max, b.part, b.face));
            assertThat(a.met.size()).as("scratch given back").isZero();
            hits += a.part >= 0 ? 1 : 0;
        }
        assertThat(hits).isGreaterThan(100);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 9, 64, 65, 200})
    void everyBoxThatIsMetIsNamedOnceInOrder(int count) {
        Random random = new Random(count);
        Bounds[] boxes = IntStream.range(0, count).mapToObj(i -> i % 7 == 3 ? Bounds.ALL
                : Bounds.around(new Vec3(random.nextDouble() * 4 - 2, random.nextDouble() * 4 - 2, random.nextDouble() * 4 - 2),
                        Vec3.ONE.times(0.3 * random.nextDouble()))).toArray(Bounds[]::new);
        Operands operands = new Operands(boxes, new double[count], () -> false);
        IntStack met = new IntStack();
        for (int i = 0; i < 2000; i++) {
            Ray ray = ray(random.doubles(6, -3, 3).toArray(), new Spans());
            met.push(-7);
            int mark = met.size();
            operands.meet(ray, met);
            assertThat(IntStream.range(mark, met.size()).map(met::get).toArray())
                    .containsExactly(IntStream.range(0, count).filter(k -> !boxes[k].isFinite() || ray.meets(boxes[k])).toArray());
            met.release(0);
        }
    }

    /** A ray keeps its scratch; whose boxes it looks at may change, and what lies behind its origin may count. */
    @Test
    void oneRayAsksManyAndLooksBehindItself() {
        Random random = new Random(11);
        Bounds[][] boxes = new Bounds[2][40];
        Operands[] operands = new Operands[2];
        for (int k = 0; k < 2; k++) {
            for (int i = 0; i < 40; i++) {
                boxes[k][i] = Bounds.around(new Vec3(random.nextDouble() * 4 - 2, random.nextDouble() * 4 - 2, random.nextDouble() * 4 - 2),
                        Vec3.ONE.times(0.3 * random.nextDouble()));
            }
            operands[k] = new Operands(boxes[k], new double[40], () -> false);
        }
        IntStack[] found = {new IntStack(), new IntStack()};
        Ray ray = new Ray(new Spans());
        int behind = 0;
        for (int i = 0; i < 4000; i++) {
            double[] from = random.doubles(6, -1, 1).toArray();
            ray.start(from[0], from[1], from[2], from[3], from[4], from[5]);
            ray.min = i % 3 == 0 ? -10 : 0;
            int k = random.nextInt(2);
            IntStack met = found[random.nextInt(2)];
            operands[k].meet(ray, met);
            int[] all = IntStream.range(0, 40).filter(b -> ray.meets(boxes[k][b])).toArray();
            assertThat(IntStream.range(0, met.size()).map(met::get).toArray()).containsExactly(all);
            met.release(0);
            ray.min = 0;
            behind += IntStream.of(all).anyMatch(b -> !ray.meets(boxes[k][b])) ? 1 : 0;
        }
        assertThat(behind).isGreaterThan(100);
    }

    /** Some touch or coincide; one has no end. */
    private static List<Operand> operands(Operation operation, int count, Random random) {
        List<Operand> operands = new ArrayList<>();
        double size = operation == Operation.INTERSECTION ? 3 : 0.5;
        operands.add(Operand.of(new Block(new Vec3(-2, -2, -2), new Vec3(2, 2, 2))).scaled(0.9, 0.9, 0.9));
        operands.add(Operand.of(new Plane()).at(0, operation == Operation.INTERSECTION ? 1 : -1.5, 0));
        for (int i = 2; i < count; i++) {
            operands.add(Operand.of(i % 2 == 0 ? new Sphere(size) : new Block(Vec3.ONE.times(-size), Vec3.ONE.times(size)))
                    .at((random.nextInt(9) - 4) / 2.0, (random.nextInt(9) - 4) / 2.0, (random.nextInt(9) - 4) / 2.0));
        }
        return operands;
    }

    private static Ray ray(double[] n, Spans spans) {
        double length = Math.sqrt(n[3] * n[3] + n[4] * n[4] + n[5] * n[5]);
        Ray ray = new Ray(spans);
        ray.start(n[0], n[1], n[2], n[3] / length, n[4] / length, n[5] / length);
        return ray;
    }

    private static Volume place(Solid solid) {
        int[] next = {0};
        return solid.place(Affine.IDENTITY, new Parts() {
            @Override
            public <P extends Part> P add(IntFunction<P> maker) {
                return maker.apply(next[0]++);
            }

            @Override
            public Parts within(MaterialSource material, Affine toWorld) {
                return this;
            }
        });
    }
}
