package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.math.Bounds;
import cz.paprsek.scene.ScenePath;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * What something that is moved can be brought in line with: sides and middles of the boxes of all else, in the world.
 *
 * @param others those boxes
 */
public record Alignment(List<Bounds> others) {
    public Alignment {
        others = List.copyOf(others);
    }

    /**
     * A line that something has come to.
     *
     * @param by how far it is moved along the axis
     * @param place where on the axis the line is
     * @param other the box that is in line with it
     */
    public record Line(Axis axis, double by, double place, Bounds other) {}

    /** All that can be seen, but for what is moved. */
    public static Alignment with(EditorState state, Collection<? extends ScenePath> moving) {
        Set<Integer> objects = Places.bodies(moving).stream().map(at -> at.object().index()).collect(Collectors.toSet());
        return new Alignment(IntStream.range(0, state.scene().objects().size()).filter(i -> !objects.contains(i) && !state.isHidden(ScenePath.body(i)))
                .mapToObj(i -> Arranging.box(state.scene(), ScenePath.body(i))).flatMap(Optional::stream).toList());
    }

    /** The box around bodies; empty if none of them has an end. */
    public static Bounds around(EditorState state, Collection<? extends ScenePath> items) {
        return Places.bodies(items).stream().map(at -> Arranging.box(state.scene(), at)).flatMap(Optional::stream).reduce(Bounds.EMPTY, Bounds::union);
    }

    /**
     * The nearest line for a box that is moved along an axis.
     *
     * @param reach how far from a line it may be, scene units
     */
    public Optional<Line> along(Axis axis, Bounds box, double by, double reach) {
        if (box.isEmpty()) {
            return Optional.empty();
        }
        Optional<Line> best = Optional.empty();
        double nearest = reach;
        double[] own = places(axis, box);
        for (Bounds other : others) {
            for (double place : places(axis, other)) {
                for (double mine : own) {
                    double away = Math.abs(place - mine - by);
                    if (away <= nearest) {
                        nearest = away;
                        best = Optional.of(new Line(axis, place - mine, place, other));
                    }
                }
            }
        }
        return best;
    }

    private static double[] places(Axis axis, Bounds box) {
        return new double[] {axis.least(box), axis.of(box.middle()), axis.most(box)};
    }
}
