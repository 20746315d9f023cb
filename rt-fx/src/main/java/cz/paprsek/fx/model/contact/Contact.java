package cz.paprsek.fx.model.contact;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.edit.Alignment;
import cz.paprsek.fx.model.edit.Alignment.Line;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.placed.Surface;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * How far bodies can be moved along an axis until their surface touches that of another body, slanted and round ones too. Keeps what it has found;
 * among many it does not look at all of them in one step.
 */
public final class Contact {
    /** Among more objects a hand would not be followed. */
    private static final int MOST = 2000;
    /** Numbers of files need not have more places than can be seen. */
    private static final double FINEST = 1e6;

    private final Bounds box;
    private final List<Surface> own;
    private final List<Surface> others;
    private final Map<Axis, Gaps> known = new EnumMap<>(Axis.class);
    private final Work work = new Work();

    /** Those that lie in the way, of what has been moved before. */
    private record Gaps(Vec3 before, Bounds box, List<Gap> inTheWay) {}

    /** What may be touched, and how far that is by the boxes. */
    private record Try(Gap gap, boolean isAbove, double estimate) {}

    private Contact(Bounds box, List<Surface> own, List<Surface> others) {
        this.box = box;
        this.own = List.copyOf(own);
        this.others = List.copyOf(others);
    }

    /** Between what is moved and all else that can be seen. */
    public static Contact with(EditorState state, Collection<? extends ScenePath> moving) {
        List<BodyAt> bodies = Places.outermost(moving);
        Set<Integer> objects = bodies.stream().map(at -> at.object().index()).collect(Collectors.toSet());
        List<Surface> others = state.scene().objects().size() > MOST ? List.of() : IntStream.range(0, state.scene().objects().size())
                .filter(i -> !objects.contains(i) && !state.isHidden(ScenePath.body(i))).mapToObj(i -> ScenePath.body(i).placed(state.scene())).toList();
        List<Surface> own = bodies.stream().map(at -> at.placed(state.scene())).toList();
        // Beside what has an end, what has none is not asked: it would be looked at all over the others, and too coarsely.
        List<Surface> ending = own.stream().filter(surface -> surface.bounds().isFinite()).toList();
        return ending.isEmpty() || ending.size() == own.size() ? new Contact(Alignment.around(state, moving), own, others)
                : new Contact(ending.stream().map(Surface::bounds).reduce(Bounds::union).orElse(Bounds.EMPTY), ending, others);
    }

    /**
     * The nearest contact for what is moved along an axis.
     *
     * @param by how far it is moved
     * @param reach how far from a contact it may be, scene units
     */
    public Optional<Line> along(Axis axis, double by, double reach) {
        work.begin();
        return nearest(axis, Vec3.ZERO, by, reach);
    }

    /**
     * The nearest contact for what is moved in a plane, along one of its axes.
     *
     * @param hand how far it would be moved
     * @param chosen how far it is moved along the other axis, which stays so
     * @param reachFirst how far from a contact along the first axis it may be, scene units
     * @param reachSecond as far along the second
     */
    public Optional<Line> inPlane(Axis first, Axis second, Vec3 hand, Vec3 chosen, double reachFirst, double reachSecond) {
        work.begin();
        Optional<Line> one = nearest(first, chosen, first.of(hand), reachFirst);
        Optional<Line> other = nearest(second, chosen, second.of(hand), one.map(line -> Math.min(reachSecond, Math.abs(line.by() - first.of(hand)))).orElse(reachSecond));
        return other.or(() -> one);
    }

    /** @param before how far it has been moved aside; along the axis that does not count */
    private Optional<Line> nearest(Axis axis, Vec3 before, double by, double reach) {
        if (reach <= 0) {
            return Optional.empty();
        }
        Vec3 aside = before.minus(axis.times(axis.of(before)));
        Gaps gaps = known.get(axis);
        if (gaps == null || !gaps.before.equals(aside)) {
            gaps = across(axis, aside);
            known.put(axis, gaps);
        }
        List<Try> tries = new ArrayList<>();
        for (Gap gap : gaps.inTheWay) {
            for (boolean isAbove : new boolean[] {false, true}) {
                double estimate = gap.estimate(isAbove, by, reach);
                if (estimate < Double.POSITIVE_INFINITY) {
                    tries.add(new Try(gap, isAbove, estimate));
                }
            }
        }
        tries.sort(Comparator.comparingDouble(Try::estimate));
        Optional<Line> best = Optional.empty();
        double nearest = reach;
        for (Try one : tries) {
            Optional<Gap.Touch> touch = one.gap.touch(one.isAbove, by, nearest);
            if (touch.isPresent() && Math.abs(touch.get().by() - by) < nearest) {
                nearest = Math.abs(touch.get().by() - by);
                Bounds other = one.gap.other().isFinite() ? one.gap.other() : Bounds.of(gaps.box.middle(), gaps.box.middle());
                best = Optional.of(new Line(axis, Math.rint(touch.get().by() * FINEST) / FINEST, touch.get().place(), other));
            }
        }
        return best;
    }

    /** How often surfaces have been asked where a line meets them. */
    long asked() {
        return work.asked();
    }

    private Gaps across(Axis axis, Vec3 before) {
        if (others.isEmpty()) {
            return new Gaps(before, box, List.of());
        }
        List<Gap> found = new ArrayList<>();
        Moved moved = Moved.along(axis, own, before);
        Bounds there = box.isEmpty() || before.equals(Vec3.ZERO) ? box : Bounds.around(box.middle().plus(before), box.middle().minus(new Vec3(box.minX(), box.minY(), box.minZ())));
        for (Surface other : box.isEmpty() ? List.<Surface>of() : others) {
            Gap gap = new Gap(moved, there, other, work, false);
            if (gap.isInTheWay()) {
                found.add(gap);
            }
        }
        return new Gaps(before, there, found);
    }
}
