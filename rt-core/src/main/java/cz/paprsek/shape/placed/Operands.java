package cz.paprsek.shape.placed;

import cz.paprsek.math.Bounds;
import cz.paprsek.tree.ItemBoxes;
import cz.paprsek.tree.Search;
import cz.paprsek.tree.Tree;
import cz.paprsek.tree.TreeBuilder;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/** Which of many operands a ray meets, without asking all. Those without end stand apart and are always met. */
public final class Operands {
    private final Bounds[] boxes;
    /** Numbers of operands in the order of the tree's leaves. */
    private final int[] finite;
    private final int[] endless;
    private final Tree tree;

    /**
     * @param boxes those of the operands
     * @param cost about how long it takes to meet one, in units of what a sphere takes
     * @throws java.util.concurrent.CancellationException if it was to stop
     */
    public Operands(Bounds[] boxes, double[] cost, BooleanSupplier stop) {
        this.boxes = boxes;
        endless = IntStream.range(0, boxes.length).filter(i -> !boxes[i].isFinite()).toArray();
        finite = IntStream.range(0, boxes.length).filter(i -> boxes[i].isFinite() && !boxes[i].isEmpty()).toArray();
        double[] box = new double[6 * boxes.length];
        float[] costs = new float[boxes.length];
        for (int i : finite) {
            TreeBuilder.put(box, i, boxes[i]);
            costs[i] = (float) cost[i];
        }
        tree = new TreeBuilder(ItemBoxes.of(box), finite, costs, stop).build();
    }

    /** Pushes the numbers of the operands whose boxes the ray meets, in rising order. */
    public void meet(Ray ray, IntStack out) {
        int mark = out.size();
        for (int i : endless) {
            out.push(i);
        }
        Finder finder = ray.finder;
        if (finder == null) {
            finder = new Finder(this, out);
            ray.finder = finder;
        }
        finder.look(this, out);
        tree.any(finder, ray, tree.whole());
        out.sort(mark);
    }

    /** Notes the operands that are met: scratch of a ray. */
    static final class Finder extends Search<Ray> {
        private Operands among;
        private IntStack found;

        private Finder(Operands among, IntStack found) {
            this.among = among;
            this.found = found;
        }

        private void look(Operands operands, IntStack out) {
            if (among != operands || found != out) {
                among = operands;
                found = out;
            }
        }

        @Override
        protected void aim(Ray ray) {
            ray.needReciprocals();
            // Trees measure from where a line starts, and know nothing of what lies behind.
            double back = ray.min < 0 ? ray.min : 0;
            along(ray.ox + back * ray.dx, ray.oy + back * ray.dy, ray.oz + back * ray.dz, ray.rx, ray.ry, ray.rz,
                    ray.min - back, ray.max - back);
        }

        /** All that are met are wanted, so no leaf ends the search. */
        @Override
        protected boolean stopsAt(Ray ray, int first, int end) {
            for (int i = first; i < end; i++) {
                int number = among.finite[i];
                if (ray.meets(among.boxes[number])) {
                    found.push(number);
                }
            }
            return false;
        }

        @Override
        protected double meet(Ray ray, int first, int end) {
            stopsAt(ray, first, end);
            return ray.max;
        }
    }
}
