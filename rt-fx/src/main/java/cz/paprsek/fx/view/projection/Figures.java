package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.fx.view.look.Strokes;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collection;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/** The figures of a scene's objects in one projection, each made once and kept as long as its object is in the scene. */
final class Figures {
    /** More things are not looked through for what lies within their boxes. */
    private static final int FEW = 50;

    private final Axes axes;
    private Scene scene = Scene.EMPTY;
    /** Of whose objects figures are known: an earlier one while a hand moves things and nobody has asked for the figure of one. */
    private Scene followed = Scene.EMPTY;
    /** Those of its objects that have been asked for; null for others. */
    private @Nullable Figure[] known = {};
    /** Those of them that are drawn as they are while a hand moves them. */
    private final BitSet moving = new BitSet();
    private boolean isMoved;
    private Scene counted = Scene.EMPTY;
    private boolean areMany;

    Figures(Axes axes) {
        this.axes = axes;
    }

    /** @param changing whether a change is under way: what it makes anew is drawn roughly, and finely when it has ended */
    void show(Scene fresh, boolean changing) {
        if (!changing) {
            moving.stream().forEach(i -> known[i] = null);
            moving.clear();
        }
        isMoved = changing;
        scene = fresh;
        if (!changing) {
            follow();
        }
    }

    @SuppressWarnings("ReferenceEquality")
    private void follow() {
        Scene old = followed;
        if (old == scene) {
            return;
        }
        followed = scene;
        if (old.objects().size() == scene.objects().size()) {
            // What still stands somewhere else is drawn anew when it is asked for.
            Arrays.stream(old.objectsOtherThanIn(scene)).forEach(i -> follow(i, old.objects().get(i), scene.objects().get(i)));
        } else {
            keep(old.objects(), scene.objects());
        }
    }

    /** What a hand only moves keeps its lines. */
    private void follow(int index, SceneObject old, SceneObject now) {
        Figure figure = known[index];
        known[index] = null;
        moving.clear(index);
        if (figure != null && isMoved && isMoved(old, now)) {
            Vec3 by = now.placement().position().minus(old.placement().position());
            known[index] = figure.moved(axes.u(by), axes.v(by));
            moving.set(index);
        }
    }

    private void keep(List<SceneObject> old, List<SceneObject> now) {
        IdentityHashMap<SceneObject, Integer> places = new IdentityHashMap<>();
        for (int i = 0; i < old.size(); i++) {
            places.put(old.get(i), i);
        }
        @Nullable Figure[] before = known;
        BitSet moved = (BitSet) moving.clone();
        known = new Figure[now.size()];
        moving.clear();
        for (int i = 0; i < now.size(); i++) {
            int place = places.getOrDefault(now.get(i), -1);
            known[i] = place < 0 ? null : before[place];
            moving.set(i, place >= 0 && moved.get(place));
        }
    }

    /** Whether all is as in another scene, but for some items. */
    boolean isLike(Scene other, Set<ScenePath> apart) {
        return scene.objects().size() == other.objects().size() && scene.lights().size() == other.lights().size()
                && Arrays.stream(scene.objectsOtherThanIn(other)).mapToObj(ScenePath::body).allMatch(apart::contains)
                && IntStream.range(0, scene.lights().size()).filter(i -> !scene.lights().get(i).equals(other.lights().get(i)))
                        .mapToObj(ScenePath::light).allMatch(apart::contains);
    }

    Scene scene() {
        return scene;
    }

    /** How many objects there are. */
    int count() {
        return scene.objects().size();
    }

    /** Whether so many bodies are drawn, operands instead of operations, that speed counts more than smoothness. */
    @SuppressWarnings("ReferenceEquality")
    boolean areMany() {
        if (counted != scene) {
            counted = scene;
            areMany = count() > Strokes.MANY || scene.objects().stream().mapToInt(object -> Places.count(Body.of(object))).sum() > Strokes.MANY;
        }
        return areMany;
    }

    /** Of an object, counted from 0. */
    Figure of(int object) {
        follow();
        Figure figure = known[object];
        if (figure == null) {
            moving.set(object, isMoved);
            figure = drawn(scene.objects().get(object), isMoved);
            known[object] = figure;
        }
        return figure;
    }

    private Figure drawn(SceneObject object, boolean isInHand) {
        return Figure.of(Body.of(object), axes, areMany() ? Figure.Fineness.COARSE : isInHand ? Figure.Fineness.MOVING : Figure.Fineness.FINE);
    }

    /** Of an object at another time, which is not kept. */
    Figure passing(SceneObject object) {
        return Figure.of(Body.of(object), axes, Figure.Fineness.MOVING);
    }

    Figure of(BodyAt at) {
        return of(at.numbers().get(0)).at(at.numbers().subList(1, at.numbers().size()));
    }

    /** Whether bodies are so many, neither with operands nor without end, that they are drawn once and then shown elsewhere. */
    boolean areMany(List<BodyAt> bodies) {
        return bodies.size() > FEW && bodies.stream().allMatch(at -> at.depth() == 0 && of(at).operands().isEmpty() && !of(at).box().isEmpty());
    }

    /** By how much objects have been moved since another scene, if all of them by as much, to a small error, and nothing else is otherwise. */
    Optional<Vec3> movedSince(Scene before, List<BodyAt> bodies, double error) {
        Optional<Vec3> first = Optional.empty();
        for (BodyAt at : bodies) {
            int i = at.index();
            if (i >= Math.min(scene.objects().size(), before.objects().size()) || !isMoved(before.objects().get(i), scene.objects().get(i))) {
                return Optional.empty();
            }
            Vec3 by = scene.objects().get(i).placement().position().minus(before.objects().get(i).placement().position());
            if (first.filter(other -> Math.abs(axes.u(by.minus(other))) >= error || Math.abs(axes.v(by.minus(other))) >= error).isPresent()) {
                return Optional.empty();
            }
            first = first.or(() -> Optional.of(by));
        }
        return first;
    }

    /** Whether it is but somewhere else. */
    @SuppressWarnings("ReferenceEquality")
    private static boolean isMoved(SceneObject old, SceneObject now) {
        return old.shape() == now.shape() && old.hidden() == now.hidden()
                && now.placement().rotation().equals(old.placement().rotation()) && now.placement().scale().equals(old.placement().scale());
    }

    /** Whether all that is drawn of items when they are selected lies within their boxes, but for what they are grabbed by; of many it may, and is not looked for. */
    boolean areWithinBoxes(Set<ScenePath> items) {
        return items.size() <= FEW && items.stream().allMatch(this::isWithinBox);
    }

    private boolean isWithinBox(ScenePath item) {
        if (item instanceof BodyAt body && body.depth() == 0) {
            Figure figure = of(body);
            return figure.operands().isEmpty() && !figure.box().isEmpty();
        }
        return item instanceof CameraAt;
    }

    /**
     * The box around what a few items cover here or have covered in another scene; empty if that is not known to be within their boxes, or if something else is
     * otherwise there. Places of the other scene need not be in this one.
     */
    @SuppressWarnings("ReferenceEquality")
    Optional<Box> changed(Scene before, Set<ScenePath> some, Set<ScenePath> more) {
        Set<ScenePath> items = new HashSet<>(some.size() <= FEW ? some : Set.of());
        items.addAll(more.size() <= FEW ? more : Set.of());
        if (!items.containsAll(some) || !items.containsAll(more) || !isLike(before, items) || !areWithinBoxes(items)) {
            return Optional.empty();
        }
        Box box = Box.EMPTY;
        for (BodyAt at : Places.bodies(items)) {
            SceneObject old = before.objects().get(at.index());
            Figure was = old == scene.objects().get(at.index()) ? of(at) : drawn(old, false);
            if (!was.operands().isEmpty() || was.box().isEmpty()) {
                return Optional.empty();
            }
            box = box.union(of(at).box()).union(was.box());
        }
        return Optional.of(box);
    }

    /** The box around an item; a point for cameras and lights without a size. */
    Box box(ScenePath item) {
        if (item instanceof LightAt light) {
            LightSketch sketch = LightSketch.of(scene.lights().get(light.index()), axes);
            Box box = Box.EMPTY.with(axes.u(sketch.place()), axes.v(sketch.place()));
            for (List<Vec3> line : sketch.extent()) {
                for (Vec3 point : line) {
                    box = box.with(axes.u(point), axes.v(point));
                }
            }
            return box;
        }
        if (item instanceof BodyAt body) {
            return of(body).box();
        }
        Vec3 eye = scene.cameras().get(item instanceof CameraAt camera ? camera.index() : 0).position();
        return Box.EMPTY.with(axes.u(eye), axes.v(eye));
    }

    Box box(Collection<? extends ScenePath> items) {
        return items.stream().filter(item -> item.isIn(scene)).map(this::box).reduce(Box.EMPTY, Box::union);
    }

    /** The box around all that is not hidden, and around the place where the next thing would be put. */
    Box boxOfAll(EditorState state) {
        Sight sight = Sight.of(state);
        double u = axes.u(sight.point());
        double v = axes.v(sight.point());
        Box box = box(ScenePath.camera(state.eye())).with(u - sight.size(), v - sight.size()).with(u + sight.size(), v + sight.size());
        for (int i = 0; i < scene.cameras().size(); i++) {
            box = state.isHidden(ScenePath.camera(i)) ? box : box.union(box(ScenePath.camera(i)));
        }
        for (int i = 0; i < scene.objects().size(); i++) {
            box = state.isHidden(ScenePath.body(i)) ? box : box.union(of(i).box());
        }
        for (int i = 0; i < scene.lights().size(); i++) {
            box = state.isHidden(ScenePath.light(i)) ? box : box.union(box(ScenePath.light(i)));
        }
        return box;
    }
}
