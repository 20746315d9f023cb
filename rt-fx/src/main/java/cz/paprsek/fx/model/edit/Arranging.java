package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Csg.Operation;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Puts bodies in line and in their roles, as changes for {@link EditorModel#editState}. All go by the boxes of bodies in the world. */
public final class Arranging {
    private Arranging() {}

    /** An axis of the world. */
    public enum Axis {
        X, Y, Z;

        public double of(Vec3 v) {
            return this == X ? v.x() : this == Y ? v.y() : v.z();
        }

        public Vec3 times(double length) {
            return this == X ? new Vec3(length, 0, 0) : this == Y ? new Vec3(0, length, 0) : new Vec3(0, 0, length);
        }

        public double least(Bounds box) {
            return this == X ? box.minX() : this == Y ? box.minY() : box.minZ();
        }

        public double most(Bounds box) {
            return this == X ? box.maxX() : this == Y ? box.maxY() : box.maxZ();
        }
    }

    /** What of boxes is brought in line. */
    public enum Side { LEAST, MIDDLE, MOST }

    /** The box of a body in the world; empty if it has no end. */
    public static Optional<Bounds> box(Scene scene, BodyAt at) {
        return at.find(scene).map(body -> at.placed(scene).bounds()).filter(box -> box.isFinite() && !box.isEmpty());
    }

    /** Moves bodies along an axis, so that a side or the middle of each is where that of the first is. */
    public static EditorState aligned(EditorState state, Collection<? extends ScenePath> items, Axis axis, Side side) {
        List<BodyAt> bodies = withBoxes(state.scene(), items);
        if (bodies.size() < 2) {
            throw new IllegalArgumentException("select at least two bodies that have an end");
        }
        double line = place(box(state.scene(), bodies.get(0)).orElseThrow(), axis, side);
        return moved(state, bodies, at -> axis.times(line - place(box(state.scene(), at).orElseThrow(), axis, side)));
    }

    /** Moves bodies along an axis, so that the middles of all are equally far apart; the outermost stay. */
    public static EditorState distributed(EditorState state, Collection<? extends ScenePath> items, Axis axis) {
        Scene scene = state.scene();
        List<BodyAt> bodies = withBoxes(scene, items);
        if (bodies.size() < 3) {
            throw new IllegalArgumentException("select at least three bodies that have an end");
        }
        Map<BodyAt, Double> middles = new HashMap<>();
        bodies.forEach(at -> middles.put(at, place(box(scene, at).orElseThrow(), axis, Side.MIDDLE)));
        List<BodyAt> sorted = bodies.stream().sorted(Comparator.comparingDouble(at -> middles.getOrDefault(at, 0.0))).toList();
        double first = middles.getOrDefault(sorted.get(0), 0.0);
        double step = (middles.getOrDefault(sorted.get(sorted.size() - 1), 0.0) - first) / (sorted.size() - 1);
        return moved(state, bodies, at -> axis.times(first + step * sorted.indexOf(at) - middles.getOrDefault(at, 0.0)));
    }

    /** Makes an operand the first of its operation; of an operation, the second. */
    public static EditorState base(EditorState state, Collection<? extends ScenePath> items) {
        BodyAt operand = Places.bodies(items).stream().findFirst().map(at -> at.in(state.scene()).shape() instanceof Csg csg && csg.operands().size() > 1 ? at.child(1) : at)
                .filter(at -> at.depth() > 0 && at.index() > 0).orElseThrow(() -> new IllegalArgumentException("select an operand that is not the first, or an operation of several"));
        return Structure.move(state, List.of(operand), Optional.of(operand.parent()), 0);
    }

    /** Hides all other operands of an operation in the editor; shows all again if none of them is to be seen. The scene stays as it is. */
    public static EditorState solo(EditorState state, Collection<? extends ScenePath> items) {
        List<BodyAt> chosen = Places.bodies(items).stream().filter(at -> at.depth() > 0).toList();
        List<BodyAt> others = chosen.stream().map(BodyAt::parent).distinct().flatMap(parent -> children(state.scene(), parent)).filter(at -> !chosen.contains(at)).toList();
        if (others.isEmpty()) {
            throw new IllegalArgumentException("select an operand of several");
        }
        boolean isAlone = state.hidden().containsAll(others) && chosen.stream().noneMatch(state.hidden()::contains);
        return Structure.hide(Structure.hide(state, chosen, false), others, !isAlone);
    }

    /** Hides all lights but some in the editor; shows all again if no other is to be seen. The scene stays as it is. */
    public static EditorState lightsAlone(EditorState state, Collection<? extends ScenePath> items) {
        List<LightAt> chosen = Places.lights(items);
        Set<ScenePath> others = IntStream.range(0, state.scene().lights().size()).mapToObj(ScenePath::light).filter(at -> !chosen.contains(at)).collect(Collectors.toSet());
        if (chosen.isEmpty() || others.isEmpty()) {
            return state;
        }
        Set<ScenePath> hidden = new LinkedHashSet<>(state.hidden());
        hidden.removeAll(chosen);
        if (hidden.containsAll(others) && hidden.size() == state.hidden().size()) {
            hidden.removeAll(others);
        } else {
            hidden.addAll(others);
        }
        return state.withHidden(hidden);
    }

    private static Stream<BodyAt> children(Scene scene, BodyAt parent) {
        return IntStream.range(0, parent.in(scene).operands().size()).mapToObj(parent::child);
    }

    /** What an operand does in its operation; empty for objects of the scene. */
    public static Optional<Role> role(Scene scene, BodyAt at) {
        return at.depth() == 0 || !(at.parent().in(scene).shape() instanceof Csg csg) ? Optional.empty()
                : Optional.of(csg.operation() == Operation.INTERSECTION ? Role.COMMON : csg.operation() == Operation.DIFFERENCE && at.index() > 0 ? Role.CUTTER : Role.BASE);
    }

    /** What is there, what is taken from it, and what is left where all are. */
    public enum Role { BASE, CUTTER, COMMON }

    /** Those that have an end, without what lies within others of them. */
    public static List<BodyAt> withBoxes(Scene scene, Collection<? extends ScenePath> items) {
        return Places.outermost(items).stream().filter(at -> box(scene, at).isPresent()).toList();
    }

    private static double place(Bounds box, Axis axis, Side side) {
        return switch (side) {
            case LEAST -> axis.least(box);
            case MIDDLE -> axis.of(box.middle());
            case MOST -> axis.most(box);
        };
    }

    /** Whereto a body is moved. */
    public interface Way {
        /** How far; asked once for each body, in their order. */
        Vec3 of(BodyAt at);
    }

    /** Moves bodies, each its own way; what is locked stays as it is, to the last digit. */
    public static EditorState moved(EditorState state, List<BodyAt> all, Way way) {
        List<BodyAt> bodies = all.stream().filter(at -> !state.isLocked(at)).toList();
        Map<BodyAt, Vec3> ways = new HashMap<>();
        bodies.forEach(at -> ways.put(at, way.of(at)));
        Scene scene = state.scene();
        for (BodyAt at : bodies) {
            Vec3 by = ways.getOrDefault(at, Vec3.ZERO);
            scene = Moves.translated(scene, List.of(at), new Vec3(readable(by.x()), readable(by.y()), readable(by.z())));
        }
        Scene arranged = scene.with(bodies, (at, body) -> body.placed(body.placement().withPosition(readable(body.placement().position()))));
        return state.withScene(arranged);
    }

    private static Vec3 readable(Vec3 v) {
        return new Vec3(readable(v.x()), readable(v.y()), readable(v.z()));
    }

    /** Without what sums of decimals leave behind. */
    private static double readable(double value) {
        return Math.rint(value * 1e9) / 1e9 + 0.0;
    }
}
