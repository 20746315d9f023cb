package cz.paprsek.teach;

import static cz.paprsek.teach.mistake.Mistake.DIFFERENCE_SWAPPED;
import static cz.paprsek.teach.mistake.Mistake.ONE_INTERVAL;
import static cz.paprsek.teach.mistake.Mistake.SUBTRACTED_NOT_TURNED;

import cz.paprsek.shape.Csg.Operation;
import cz.paprsek.teach.Body.Thing;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.ArrayList;
import java.util.List;

/** Solids put together, by the stretches of a line that are inside of each. */
record Together(Operation operation, List<Thing> solids, Mistakes made) implements Thing {
    @Override
    public List<Crossing> crossings(Ray ray) {
        List<Crossing> all = solids.get(0).crossings(ray);
        for (Thing solid : solids.subList(1, solids.size())) {
            all = combined(all, solid.crossings(ray), ray.size());
        }
        return all;
    }

    /**
     * A boundary stands wherever the answer to "inside?" changes. Where both solids change in one place, the left one's is kept. What mistakes make of a ray may be
     * no numbers: such crossings are passed, too.
     */
    private List<Crossing> combined(List<Crossing> left, List<Crossing> right, double size) {
        List<Crossing> found = new ArrayList<>();
        boolean inLeft = false;
        boolean inRight = false;
        boolean inside = false;
        int a = 0;
        int b = 0;
        while (a < left.size() || b < right.size()) {
            double first = b == right.size() || (a < left.size() && left.get(a).t() <= right.get(b).t()) ? left.get(a).t() : right.get(b).t();
            double here = Double.isInfinite(first) ? first : first + Ray.TOUCH * (size + Math.abs(first));
            int fromA = a;
            while (a < left.size() && !(left.get(a).t() > here)) {
                a++;
            }
            int fromB = b;
            while (b < right.size() && !(right.get(b).t() > here)) {
                b++;
            }
            boolean leftChanges = (a - fromA) % 2 != 0;
            inLeft ^= leftChanges;
            inRight ^= (b - fromB) % 2 != 0;
            if (inside(inLeft, inRight) != inside) {
                inside = !inside;
                found.add(leftChanges ? left.get(fromA) : facing(right.get(fromB)));
            }
        }
        return made.has(ONE_INTERVAL) && found.size() > 2 ? List.of(found.get(0), found.get(1)) : found;
    }

    private boolean inside(boolean inLeft, boolean inRight) {
        return made.has(DIFFERENCE_SWAPPED) ? operation.inside(inRight, inLeft) : operation.inside(inLeft, inRight);
    }

    /** The surface of what is taken away looks into the hole. */
    private Crossing facing(Crossing crossing) {
        return operation == Operation.DIFFERENCE && !made.has(SUBTRACTED_NOT_TURNED) ? crossing.turned() : crossing;
    }
}
