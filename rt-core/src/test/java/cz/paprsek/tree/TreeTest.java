package cz.paprsek.tree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.BitSet;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Items are boxes, and a line meets one where it enters: what a tree finds is compared with what asking every box finds. */
class TreeTest {
    /** Through tens of thousands of boxes, each of which is asked. */
    private static final int LINES = Integer.getInteger("tree.lines", 40);

    /** Numbers of boxes, how large the whole is, how far from zero its middle, and how far from there, in its own size, lines begin. */
    @ParameterizedTest
    @CsvSource({
        "1, 1, 0, 1", "2, 1, 0, 1", "7, 1, 0, 1", "8, 1, 0, 3", "9, 1, 0, 1", "100, 1, 0, 1", "3000, 1, 0, 1", "3000, 1, 0, 100", "3000, 1, 1e6, 1",
        "500, 1e45, 0, 1", "500, 1e-45, 0, 1", "500, 1e-45, 0, 1e6", "500, 1e-3, 1e3, 1e7", "500, 1e-40, 0, 1e40", "500, 1, 0, 1e35", "500, 1e-45, 0, 1e89",
        "60000, 1, 0, 1", "60000, 1e45, 0, 1", "60000, 1e-3, 1e3, 1e7", "60000, 1e-45, 0, 1e89"
    })
    void aTreeFindsWhatAskingEveryBoxFinds(int count, double size, double middle, double distance) {
        compare(count, size, middle, distance, false);
    }

    /** One that is searched as a whole only, and may be packed: the same as above, where there is one grid for all, and lines begin farther away than that tells anything. */
    @ParameterizedTest
    @CsvSource({
        "1, 1, 0, 1", "9, 1, 0, 1", "100, 1, 0, 1", "3000, 1, 0, 1", "3000, 1, 0, 1e3", "3000, 1, 1e6, 1", "500, 1e45, 0, 1", "500, 1e-45, 0, 1", "500, 1e-45, 0, 1e6",
        "500, 1e-3, 1e3, 1e7", "500, 1e-40, 0, 1e40", "500, 1, 0, 1e35", "500, 1e-45, 0, 1e89", "60000, 1, 0, 1", "60000, 1e45, 0, 1e4"
    })
    void aTreeOfTheWholeFindsWhatAskingEveryBoxFinds(int count, double size, double middle, double distance) {
        compare(count, size, middle, distance, true);
    }

    private static void compare(int count, double size, double middle, double distance, boolean isWhole) {
        Random random = new Random(count);
        Boxes boxes = new Boxes(random, count, size, middle);
        Tree tree = boxes.build(isWhole);
        if (count >= 3000) {
            assertThat(isPacked(tree)).isEqualTo(isWhole && Kernel.inUse().startsWith("vectors"));
        }
        Finder finder = new Finder(boxes);
        Entries entries = new Entries(24);
        Bundle bundle = new Bundle();
        int found = 0;
        int lines = count > 10_000 ? LINES : isWhole ? 500 : 2000;
        for (int i = 0; i < lines; i++) {
            Line line = Line.through(random, boxes, size, middle, distance, i % 4);
            BitSet expected = new BitSet();
            double nearest = line.end;
            for (int k = 0; k < count; k++) {
                double t = line.enter(boxes.box, 6 * k);
                if (t < line.end) {
                    expected.set(k);
                    nearest = Math.min(nearest, t);
                }
            }
            bundle.start(line.x, line.y, line.z);
            bundle.add(line.dx * 0.999, line.dy, line.dz);
            bundle.add(line.dx, line.dy * 0.999, line.dz * 0.999);
            bundle.add(line.dx, line.dy, line.dz);
            tree.enter(bundle, entries);
            for (Entries among : new Entries[] {tree.whole(), entries}) {
                assertThat(finder.all(tree, line, among)).as("all that line %d meets", i).isEqualTo(expected);
                assertThat(finder.nearest(tree, line, among)).as("the first that line %d meets", i).isEqualTo(nearest);
                assertThat(finder.isAny(tree, line, among)).isEqualTo(!expected.isEmpty());
            }
            found += expected.cardinality();
        }
        assertThat(found).isGreaterThan(100);
    }

    /** In the space of a mesh that is placed very large or small, directions are as short or long, and t as large or small. */
    @ParameterizedTest
    @CsvSource({
        "1, 1e-45", "1, 1e-40", "1, 1e-37", "1, 1e-30", "1, 1e-7", "1, 1e-6", "1, 1e7", "1, 1e30", "1, 1e37", "1, 1e40", "1, 1e45", "1, 1e-160", "1, 1e160",
        "1e45, 1e-45", "1e45, 1e45", "1e-45, 1e-45", "1e-45, 1e45"
    })
    void howLongADirectionIsMakesNoDifference(double size, double length) {
        scale(size, length, false);
        scale(size, length, true);
    }

    private static void scale(double size, double length, boolean isWhole) {
        Random random = new Random(3);
        Boxes boxes = new Boxes(random, 3000, size, 0);
        Tree tree = boxes.build(isWhole);
        Finder finder = new Finder(boxes);
        int found = 0;
        for (int i = 0; i < 200; i++) {
            Line plain = Line.through(random, boxes, size, 0, i % 3 == 0 ? 1e6 : 1, i % 4);
            Line line = new Line(plain.x, plain.y, plain.z, plain.dx * length, plain.dy * length, plain.dz * length, plain.end / length);
            BitSet expected = new BitSet();
            double nearest = line.end;
            for (int k = 0; k < 3000; k++) {
                double t = line.enter(boxes.box, 6 * k);
                if (t < line.end) {
                    expected.set(k);
                    nearest = Math.min(nearest, t);
                }
            }
            assertThat(finder.all(tree, line, tree.whole())).as("all that line %d meets", i).isEqualTo(expected);
            assertThat(finder.nearest(tree, line, tree.whole())).as("the first that line %d meets", i).isEqualTo(nearest);
            found += expected.cardinality();
        }
        assertThat(found).isGreaterThan(100);
        if (Math.abs(Math.log10(length)) < 100) {
            assertThat(finder.visits()).as("not everything is asked").isLessThan(200_000);
        }
    }

    private static boolean isPacked(Tree tree) {
        return tree.getClass().getSimpleName().equals("PackedTree");
    }

    /** What is as small as a step or two of a grid over all would be met by whoever comes near it. */
    @Test
    void whatIsSmallOnAWideFloorIsNotPacked() {
        Random random = new Random(5);
        Boxes boxes = new Boxes(random, 3000, 1e-4, 0);
        System.arraycopy(new double[] {-10, -10, -1e-4, 10, 10, -1e-4}, 0, boxes.box, 0, 6);
        Tree tree = boxes.build(true);
        assertThat(isPacked(tree)).isFalse();
        Finder finder = new Finder(boxes);
        for (int i = 0; i < 300; i++) {
            Line line = Line.through(random, boxes, 1e-4, 0, 2, 0);
            double nearest = line.end;
            for (int k = 0; k < 3000; k++) {
                nearest = Math.min(nearest, line.enter(boxes.box, 6 * k));
            }
            assertThat(finder.nearest(tree, line, tree.whole())).isEqualTo(nearest);
        }
        assertThat(finder.met).isLessThan(30_000);
    }

    /** However thin the whole is along an axis, and from however far it is looked at. */
    @ParameterizedTest
    @CsvSource({"0, 0.5", "0, 1000", "1e-6, 0.5", "1e-4, 1000", "1, 1000"})
    void whatIsFlatIsFoundByFewBoxes(double thickness, double distance) {
        Random random = new Random(6);
        int side = 60;
        Boxes boxes = new Boxes(random, side * side, 1, 0);
        for (int i = 0; i < side * side; i++) {
            int x = i % side;
            int y = i / side;
            double z = thickness * side * random.nextDouble();
            System.arraycopy(new double[] {x, y, z, x + 1, y + 1, z}, 0, boxes.box, 6 * i, 6);
        }
        Tree tree = boxes.build(true);
        Finder finder = new Finder(boxes);
        for (int i = 0; i < 100; i++) {
            Line line = Line.through(random, boxes, side, 0, distance, 0);
            double nearest = line.end;
            for (int k = 0; k < side * side; k++) {
                nearest = Math.min(nearest, line.enter(boxes.box, 6 * k));
            }
            assertThat(finder.nearest(tree, line, tree.whole())).isEqualTo(nearest);
        }
        assertThat(finder.met).isLessThan(5 * side * side);
    }

    /** Where planes are crossed is told by differences of numbers that are much larger, and rounded. */
    @Test
    void whatALineStartsInIsMetHoweverThin() {
        Random random = new Random(7);
        Boxes boxes = new Boxes(random, 3000, 1, 0);
        for (int b = 0; b < boxes.box.length; b += 6) {
            boxes.box[b + 3] = boxes.box[b];
            boxes.box[b + 4] = boxes.box[b + 1] + 0.01;
            boxes.box[b + 5] = boxes.box[b + 2] + 0.01;
        }
        Tree tree = boxes.build(true);
        Finder finder = new Finder(boxes);
        for (int i = 0; i < 30_000; i++) {
            int b = i % 3000 * 6;
            double[] d = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
            double k = 1 / Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
            Line line = new Line(boxes.box[b], boxes.box[b + 1] + 0.005, boxes.box[b + 2] + 0.005, k * d[0], k * d[1], k * d[2], 1);
            assertThat(finder.nearest(tree, line, tree.whole())).as("line %d", i).isZero();
        }
    }

    @Test
    void fewNodesAreVisited() {
        Random random = new Random(1);
        Boxes boxes = new Boxes(random, 100_000, 1, 0);
        Tree tree = boxes.build();
        Finder finder = new Finder(boxes);
        for (int i = 0; i < 1000; i++) {
            finder.nearest(tree, Line.through(random, boxes, 1, 0, 2, 0), tree.whole());
        }
        assertThat(finder.visits()).isBetween(1000L, 300_000L);
        assertThat(finder.met).isLessThan(100_000);
    }

    @Test
    void nothingIsFoundWhereNothingIs() {
        Boxes boxes = new Boxes(new Random(1), 0, 1, 0);
        Tree tree = boxes.build();
        assertThat(tree.whole().isEmpty()).isTrue();
        assertThat(new Finder(boxes).isAny(tree, new Line(0, 0, 0, 1, 0, 0, 10), tree.whole())).isFalse();
    }

    @Test
    void buildingCanBeStoppedAtAnyQuestion() {
        for (int questions : new int[] {0, 1, 10, 100}) {
            Boxes boxes = new Boxes(new Random(1), 50_000, 1, 0);
            AtomicInteger asked = new AtomicInteger();
            TreeBuilder builder = new TreeBuilder(ItemBoxes.of(boxes.box), boxes.order, boxes.cost, () -> asked.getAndIncrement() >= questions);
            assertThatThrownBy(builder::build).isInstanceOf(CancellationException.class);
            assertThat(asked.get()).isBetween(questions + 1, questions + 200);
        }
    }

    @Test
    void allThatBuildsAsksWhetherToStop() {
        Boxes boxes = new Boxes(new Random(1), 200_000, 1, 0);
        Set<Class<?>> asking = ConcurrentHashMap.newKeySet();
        StackWalker walker = StackWalker.getInstance(StackWalker.Option.RETAIN_CLASS_REFERENCE);
        TreeBuilder builder = new TreeBuilder(ItemBoxes.of(boxes.box), boxes.order, boxes.cost, () -> {
            walker.forEach(frame -> asking.add(frame.getDeclaringClass()));
            return false;
        });
        builder.build();
        assertThat(asking).contains(Bins.class, Reinsertion.class, Collapse.class, WideNodes.class);
        if (isPacked(builder.buildWhole())) {
            assertThat(asking).contains(PackedNodes.class);
        }
    }

    /** Boxes around random points, small ones mostly, a few flat or of no size at all, and some twice in one place. */
    private static final class Boxes {
        private final double[] box;
        private final int[] order;
        private final float[] cost;

        Boxes(Random random, int count, double size, double middle) {
            box = new double[6 * count];
            order = IntStream.range(0, count).toArray();
            cost = new float[count];
            for (int i = 0; i < count; i++) {
                cost[i] = 1 + i % 5;
                for (int k = 0; k < 3; k++) {
                    double at = middle + size * (random.nextDouble() - 0.5);
                    double half = i % 11 == k ? 0 : size * 0.2 * Math.pow(random.nextDouble(), 4);
                    box[6 * i + k] = at - half;
                    box[6 * i + 3 + k] = at + half;
                }
                if (i % 13 == 12) {
                    System.arraycopy(box, 6 * i - 6, box, 6 * i, 6);
                }
            }
        }

        Tree build() {
            return build(false);
        }

        Tree build(boolean isWhole) {
            double[] padded = box.clone();
            for (int b = 0; b < box.length; b += 6) {
                double magnitude = 0;
                for (int k = 0; k < 6; k++) {
                    magnitude = Math.max(magnitude, Math.abs(box[b + k]));
                }
                for (int k = 0; k < 3; k++) {
                    padded[b + k] -= 1e-12 * magnitude;
                    padded[b + 3 + k] += 1e-12 * magnitude;
                }
            }
            TreeBuilder builder = new TreeBuilder(ItemBoxes.of(padded), order, cost, () -> false);
            return isWhole ? builder.buildWhole() : builder.build();
        }
    }

    private record Line(double x, double y, double z, double dx, double dy, double dz, double end) {
        /** To a point of one of the boxes, or along an axis if so wished. */
        static Line through(Random random, Boxes boxes, double size, double middle, double distance, int kind) {
            int b = 6 * random.nextInt(boxes.order.length);
            double[] to = new double[3];
            double[] from = new double[3];
            for (int k = 0; k < 3; k++) {
                double share = random.nextDouble();
                to[k] = boxes.box[b + k] * share + boxes.box[b + 3 + k] * (1 - share);
                from[k] = kind > 0 && k != kind - 1 ? to[k] : middle + size * distance * (random.nextDouble() * 2 - 1);
            }
            double[] d = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
            double most = Math.max(Math.abs(d[0]), Math.max(Math.abs(d[1]), Math.abs(d[2])));
            double length = Math.sqrt(d[0] / most * (d[0] / most) + d[1] / most * (d[1] / most) + d[2] / most * (d[2] / most));
            double end = random.nextBoolean() ? Double.POSITIVE_INFINITY : length * most * 2 * random.nextDouble();
            return new Line(from[0], from[1], from[2], d[0] / most / length, d[1] / most / length, d[2] / most / length, end);
        }

        /** Where the line enters a box; infinite if it does not. */
        double enter(double[] boxes, int b) {
            double near = 0;
            double far = Double.POSITIVE_INFINITY;
            double[] o = {x, y, z};
            double[] d = {dx, dy, dz};
            for (int k = 0; k < 3; k++) {
                double low = boxes[b + k] - o[k];
                double high = boxes[b + 3 + k] - o[k];
                if (d[k] == 0) {
                    far = low <= 0 && high >= 0 ? far : -1;
                } else {
                    near = Math.max(near, (d[k] > 0 ? low : high) / d[k]);
                    far = Math.min(far, (d[k] > 0 ? high : low) / d[k]);
                }
            }
            return near <= far ? near : Double.POSITIVE_INFINITY;
        }
    }

    private static final class Finder extends Search<Line> {
        private final Boxes boxes;
        private final BitSet found = new BitSet();
        private boolean any;
        private double reach;
        private int met;

        Finder(Boxes boxes) {
            this.boxes = boxes;
        }

        BitSet all(Tree tree, Line line, Entries entries) {
            any = false;
            found.clear();
            assertThat(tree.any(this, line, entries)).isFalse();
            return (BitSet) found.clone();
        }

        boolean isAny(Tree tree, Line line, Entries entries) {
            any = true;
            return tree.any(this, line, entries);
        }

        double nearest(Tree tree, Line line, Entries entries) {
            reach = line.end;
            tree.nearest(this, line, entries, reach);
            return reach;
        }

        @Override
        protected void aim(Line line) {
            along(line.x, line.y, line.z, reciprocal(line.dx), reciprocal(line.dy), reciprocal(line.dz), 0, line.end);
        }

        private static double reciprocal(double d) {
            double r = 1 / d;
            return Math.abs(r) <= Double.MAX_VALUE ? r : Math.copySign(Double.MAX_VALUE, d);
        }

        @Override
        protected double meet(Line line, int first, int end) {
            for (int i = first; i < end; i++) {
                met++;
                reach = Math.min(reach, line.enter(boxes.box, 6 * boxes.order[i]));
            }
            return reach;
        }

        @Override
        protected boolean stopsAt(Line line, int first, int end) {
            boolean isMet = false;
            for (int i = first; i < end; i++) {
                if (line.enter(boxes.box, 6 * boxes.order[i]) < line.end) {
                    found.set(boxes.order[i]);
                    isMet = true;
                }
            }
            return any && isMet;
        }
    }
}
