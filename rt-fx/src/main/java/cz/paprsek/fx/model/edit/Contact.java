package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.edit.Alignment.Line;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * How far bodies can be moved along an axis until they touch others, slanted and round ones too: by what lies on the line through their middle.
 *
 * @param middle of the box around them
 * @param own their surfaces
 * @param others those of all else that can be seen
 */
public record Contact(Vec3 middle, List<Surface> own, List<Surface> others) {
    /** Among more objects a hand would not be followed. */
    private static final int MOST = 2000;

    /** Numbers of files need not have more places than can be seen. */
    private static final double FINEST = 1e6;

    public Contact {
        own = List.copyOf(own);
        others = List.copyOf(others);
    }

    public static Contact with(EditorState state, Collection<? extends ScenePath> moving) {
        List<BodyAt> bodies = Places.outermost(moving);
        Set<Integer> objects = bodies.stream().map(at -> at.object().index()).collect(Collectors.toSet());
        List<Surface> others = state.scene().objects().size() > MOST ? List.of() : IntStream.range(0, state.scene().objects().size())
                .filter(i -> !objects.contains(i) && !state.isHidden(ScenePath.body(i))).mapToObj(i -> ScenePath.body(i).placed(state.scene())).toList();
        Bounds box = Alignment.around(state, moving);
        return new Contact(box.isEmpty() ? Vec3.ZERO : box.middle(), bodies.stream().map(at -> at.placed(state.scene())).toList(), others);
    }

    /**
     * The nearest contact for what is moved along an axis.
     *
     * @param by how far it is moved
     * @param reach how far from a contact it may be, scene units
     */
    public Optional<Line> along(Axis axis, double by, double reach) {
        double[] ends = own.stream().flatMapToDouble(one -> crossings(one, axis)).sorted().toArray();
        if (ends.length == 0) {
            return Optional.empty();
        }
        Optional<Line> best = Optional.empty();
        double nearest = reach;
        for (Surface other : others) {
            for (double place : crossings(other, axis).toArray()) {
                for (double end : new double[] {ends[0], ends[ends.length - 1]}) {
                    double away = Math.abs(place - end - by);
                    if (away < nearest) {
                        nearest = away;
                        best = Optional.of(new Line(axis, Math.rint((place - end) * FINEST) / FINEST, axis.of(middle) + place, other.bounds().isFinite() ? other.bounds() : Bounds.of(middle, middle)));
                    }
                }
            }
        }
        return best;
    }

    /** Where the line meets a surface, seen from the middle; less than 0 behind it. */
    private DoubleStream crossings(Surface surface, Axis axis) {
        return DoubleStream.concat(crossings(surface, axis, 1), crossings(surface, axis, -1).map(t -> -t));
    }

    private DoubleStream crossings(Surface surface, Axis axis, double sign) {
        Spans spans = new Spans();
        Ray ray = new Ray(spans);
        Vec3 way = axis.times(sign);
        ray.start(middle.x(), middle.y(), middle.z(), way.x(), way.y(), way.z());
        surface.crossings(ray, spans);
        return IntStream.range(0, spans.size()).mapToDouble(spans::t).filter(t -> t > 0 && Double.isFinite(t));
    }
}
