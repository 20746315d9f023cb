package cz.paprsek.shape.placed;

import cz.paprsek.math.Bounds;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * What some convex bodies have in common without others, or others alone: met without {@linkplain Spans combining} all that the line crosses, for the first
 * boundary is asked for only. With a = max of the enters of what is common and b = the least of its leaves, it is a, unless others hold that: then where
 * the ray leaves them, if that is before b; from inside it is b, or where it enters one of the others. Where boundaries lie in one place, or nearly, no
 * answer is given, and all have to be combined.
 */
public final class Carved {
    /** More bodies than this are not looked through one by one. */
    private static final int MOST = 8;
    /** What is less far apart, relative to the numbers it comes from, may lie in one place after some operations. */
    private static final double APART = 16 * Ray.TOUCH;
    private static final int NONE = -1;
    private static final int UNSURE = -2;

    /** The body is in all of these; if there are none, it is the others together. */
    private final Convex[] common;
    private final Convex[] others;
    /** The boxes of the others; null for one that is met sooner than its box. */
    private final @Nullable Bounds[] boxes;

    private Carved(List<Convex> common, List<Convex> others) {
        this.common = common.toArray(Convex[]::new);
        // What is asked quickly says quickly that nothing is met.
        Arrays.sort(this.common, (a, b) -> Double.compare(a.cost(), b.cost()));
        this.others = others.toArray(Convex[]::new);
        this.boxes = new Bounds[others.size()];
        for (int i = 0; i < boxes.length; i++) {
            boxes[i] = others.get(i).cost() <= 1 ? null : others.get(i).bounds().padded();
        }
    }

    /** Writes middle and squared radius of the smallest ball known around it; the radius is infinite if there is none. */
    void putAround(double[] into, int at) {
        into[at + 3] = Double.POSITIVE_INFINITY;
        double[] ball = new double[4];
        for (Convex body : common) {
            body.putAround(ball, 0);
            if (ball[3] < into[at + 3]) {
                System.arraycopy(ball, 0, into, at, 4);
            }
        }
    }

    static Carved of(Convex alone) {
        return new Carved(List.of(alone), List.of());
    }

    private static Optional<Carved> of(List<Convex> common, List<Convex> others) {
        return common.size() > MOST || others.size() > MOST ? Optional.empty() : Optional.of(new Carved(common, others));
    }

    /** All of some bodies; empty if that is no such body. */
    public static Optional<Carved> union(List<Optional<Carved>> operands) {
        List<Convex> others = new ArrayList<>();
        return operands.stream().allMatch(operand -> operand.isPresent() && operand.get().addTo(others)) ? of(List.of(), others) : Optional.empty();
    }

    /** What some bodies have in common. */
    public static Optional<Carved> intersection(List<Optional<Carved>> operands) {
        List<Convex> common = new ArrayList<>();
        List<Convex> others = new ArrayList<>();
        for (Optional<Carved> operand : operands) {
            if (operand.isEmpty() || operand.get().common.length == 0) {
                return Optional.empty();
            }
            common.addAll(Arrays.asList(operand.get().common));
            others.addAll(Arrays.asList(operand.get().others));
        }
        return of(common, others);
    }

    /** The first of some bodies without all others. */
    public static Optional<Carved> difference(List<Optional<Carved>> operands) {
        Optional<Carved> first = operands.get(0);
        if (first.isEmpty() || first.get().common.length == 0) {
            return Optional.empty();
        }
        List<Convex> others = new ArrayList<>(Arrays.asList(first.get().others));
        return operands.stream().skip(1).allMatch(operand -> operand.isPresent() && operand.get().addTo(others))
                ? of(Arrays.asList(first.get().common), others) : Optional.empty();
    }

    /** Adds what it is the union of; false if it is none. */
    private boolean addTo(List<Convex> all) {
        if (common.length == 0) {
            return all.addAll(Arrays.asList(others));
        }
        return common.length == 1 && others.length == 0 && all.add(common[0]);
    }

    /** As {@link Surface#nearest}; false, and nothing has changed, if that cannot be told. */
    public boolean nearest(Ray ray) {
        int first = first(ray, ray.min);
        if (first >= 0) {
            Spans ends = ray.spans;
            ray.accept(ends.t(first), ends.part(first), ends.face(first));
        }
        return first != UNSURE;
    }

    /** As {@link Surface#occludes}; what {@code all} says, if that cannot be told. */
    public boolean occludes(Ray ray, Volume all) {
        int first = first(ray, ray.contact);
        return first == UNSURE ? all.occludesByAll(ray) : first >= 0;
    }

    /** Which of what lies behind the spans' end is the first boundary beyond {@code from} and before max. */
    private int first(Ray ray, double from) {
        Spans ends = ray.spans;
        int mark = ends.size();
        int first = first(ray, from, ends, mark);
        ends.release(mark);
        return first;
    }

    private int first(Ray ray, double from, Spans ends, int mark) {
        // Always before: the numbers of a ray from the origin are all 0.
        double begin = from - (apart(ray, from) + Double.MIN_NORMAL);
        double end = ray.reach + apart(ray, ray.reach);
        double enter = Double.NEGATIVE_INFINITY;
        double leave = Double.POSITIVE_INFINITY;
        int entry = NONE;
        int exit = NONE;
        for (Convex body : common) {
            // Asked here and in no method that others call, too: so the JVM knows what bodies come here, and need not ask a table.
            if (!(body instanceof Ball ball ? ball.meets(ray) : body.part == ray.left ? body.meets(ray) : body.clip(ray))) {
                return NONE;
            }
            int at = ends.size();
            if (ray.enter > enter) {
                enter = ray.enter;
                entry = at;
            }
            if (ray.leave < leave) {
                leave = ray.leave;
                exit = at + 1;
            }
            if (!(enter < leave && enter < end && leave > begin)) {
                return NONE;
            }
            ends.add(ray.enter, body.part, ray.enterFace);
            ends.add(ray.leave, body.part, ray.leaveFace);
        }
        int inner = ends.size();
        addOthers(ray, ends, begin, end);
        // A place where the ray is in all that is common, and how it has come there; not yet if it was there from the beginning.
        double at = Math.max(enter, begin);
        int first = enter > begin ? entry : NONE;
        for (int i = inner; i < ends.size(); i += 2) {
            if (ends.t(i) < at && ends.t(i + 1) > at) {
                at = ends.t(i + 1);
                first = i + 1;
                if (!(at < leave)) {
                    return NONE;
                }
                i = inner - 2;
            }
        }
        if (first == NONE) {
            first = exit;
            at = leave;
            for (int i = inner; i < ends.size(); i += 2) {
                if (ends.t(i) > begin && ends.t(i) < at) {
                    at = ends.t(i);
                    first = i;
                }
            }
        }
        if (first == NONE || at > end) {
            return NONE;
        }
        return at > from && at < ray.max && isAlone(ray, ends, mark, first) ? first : UNSURE;
    }

    private void addOthers(Ray ray, Spans ends, double begin, double end) {
        boolean flips = common.length > 0;
        for (int i = 0; i < others.length; i++) {
            Convex body = others[i];
            Bounds box = boxes[i];
            if ((box == null || ray.meets(box, begin, end))
                    && (body instanceof Ball ball ? ball.meets(ray) : body.part == ray.left ? body.meets(ray) : body.clip(ray))) {
                ends.add(ray.enter, body.part, flips ? ~ray.enterFace : ray.enterFace);
                ends.add(ray.leave, body.part, flips ? ~ray.leaveFace : ray.leaveFace);
            }
        }
    }

    /** Whether no other boundary from {@code mark} on lies in one place with one of them, or nearly. */
    private static boolean isAlone(Ray ray, Spans ends, int mark, int which) {
        double at = ends.t(which);
        double apart = apart(ray, at);
        for (int i = mark; i < ends.size(); i++) {
            if (i != which && !(Math.abs(ends.t(i) - at) > apart)) {
                return false;
            }
        }
        return true;
    }

    private static double apart(Ray ray, double t) {
        return APART * (ray.scale + Math.abs(t));
    }
}
