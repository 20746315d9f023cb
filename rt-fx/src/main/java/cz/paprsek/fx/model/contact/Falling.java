package cz.paprsek.fx.model.contact;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.Arranging;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.fx.model.edit.Arranging.Role;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.placed.Surface;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Puts bodies down until their surfaces touch what is below them, slanted, round and hollow things too. */
public final class Falling {
    /** Bodies that stand on each other may reach into each other by rounding, in parts of their size. */
    private static final double SLACK = 1e-6;
    /** Beside each other in parts of their size: what only touches a side is not below. */
    private static final double RIM = 1e-9;
    private static final double FINEST = 1e6;
    /** What has sunk into something comes out of it in steps of half its height at least. */
    private static final int STEPS = 8;
    /** How many times surfaces are asked for all bodies together; the boxes of what is left count. */
    private static final long MOST = 25L * Work.MOST;

    private final List<Support> supports = new ArrayList<>();
    private final Work work = new Work();

    /** What a body may stand on, where it was, and by how much it is higher now. */
    private record Support(Surface surface, Bounds box, double raised) {
        double top() {
            return box.maxY() + raised;
        }
    }

    private record Way(Support support, Gap gap) {}

    private Falling() {}

    /** Moves bodies down, or up, onto the first thing below each, or else onto the floor y = 0. */
    public static EditorState onFloor(EditorState state, Collection<? extends ScenePath> items) {
        Scene scene = state.scene();
        List<BodyAt> bodies = Arranging.withBoxes(scene, items);
        if (bodies.isEmpty()) {
            throw new IllegalArgumentException("select a body that has an end");
        }
        Set<Integer> moving = bodies.stream().filter(at -> !state.isLocked(at)).map(at -> at.object().index()).collect(Collectors.toSet());
        Falling falling = new Falling();
        IntStream.range(0, scene.objects().size()).filter(i -> !moving.contains(i) && !state.isHidden(ScenePath.body(i)) && !scene.objects().get(i).hidden())
                .mapToObj(i -> ScenePath.body(i).placed(scene)).forEach(surface -> falling.supports.add(new Support(surface, surface.bounds(), 0)));
        Map<BodyAt, Double> lowest = new HashMap<>();
        bodies.forEach(at -> lowest.put(at, at.placed(scene).bounds().minY()));
        // From below, so that those of a stack come onto each other.
        List<BodyAt> rising = bodies.stream().sorted(Comparator.comparingDouble(at -> lowest.getOrDefault(at, 0.0))).toList();
        return Arranging.moved(state, rising, at -> {
            Surface body = at.placed(scene);
            double by = falling.by(body);
            if (Arranging.role(scene, at).map(role -> role == Role.BASE).orElse(true)) {
                falling.supports.add(new Support(body, body.bounds(), by));
            }
            return new Vec3(0, by, 0);
        });
    }

    /** How far up a body is moved. */
    private double by(Surface body) {
        Bounds box = body.bounds();
        Moved moved = Moved.along(Axis.Y, List.of(body), Vec3.ZERO);
        // The highest first: below what has been touched nothing else can be.
        List<Way> ways = supports.stream().filter(support -> isBelow(support.box, box)).sorted(Comparator.comparingDouble(Support::top).reversed())
                .map(support -> new Way(support, new Gap(moved, box, support.surface, work, true))).filter(way -> way.gap.isInTheWay()).toList();
        double by = first(ways, box, Optional.empty()).orElse(-box.minY());
        for (int step = 0; step < STEPS && by > 0; step++) {
            double next = first(ways, box, Optional.of(by)).orElse(by);
            if (next * FINEST <= by * FINEST + 1) {
                break;
            }
            by = next;
        }
        return Math.rint(by * FINEST) / FINEST;
    }

    /**
     * The highest place at which a body touches something below it.
     *
     * @param from where it is looked from; empty for where all were
     */
    private OptionalDouble first(List<Way> ways, Bounds box, Optional<Double> from) {
        if (work.asked() < MOST) {
            work.begin();
        }
        OptionalDouble highest = OptionalDouble.empty();
        for (Way way : ways) {
            Support support = way.support;
            if (highest.isPresent() && support.top() - box.minY() <= highest.getAsDouble()) {
                break;
            }
            Optional<Gap.Touch> touch = way.gap.touch(false, from.map(by -> by - support.raised).orElse(0.0), Double.POSITIVE_INFINITY);
            OptionalDouble found = touch.isPresent() ? OptionalDouble.of(touch.get().by() + support.raised) : work.isOver() || isOnEdge(box) ? byBoxes(support, box) : OptionalDouble.empty();
            if (found.isPresent() && found.getAsDouble() > highest.orElse(Double.NEGATIVE_INFINITY)) {
                highest = found;
            }
        }
        return highest;
    }

    /** Whether no line from below meets it. */
    private static boolean isOnEdge(Bounds box) {
        return Math.min(box.maxX() - box.minX(), box.maxZ() - box.minZ()) <= RIM * (box.maxY() - box.minY());
    }

    private static OptionalDouble byBoxes(Support support, Bounds box) {
        double slack = SLACK * (1 + box.maxY() - box.minY());
        return support.box.maxY() <= (box.minY() + box.maxY()) / 2 + slack ? OptionalDouble.of(support.top() - box.minY()) : OptionalDouble.empty();
    }

    /** Whether a box, drawn out upwards, would meet another one with more than its rim. */
    private static boolean isBelow(Bounds other, Bounds box) {
        double x = RIM * (box.maxX() - box.minX());
        double z = RIM * (box.maxZ() - box.minZ());
        return other.minX() < box.maxX() - x && other.maxX() > box.minX() + x && other.minZ() < box.maxZ() - z && other.maxZ() > box.minZ() + z && other.minY() < box.maxY();
    }
}
