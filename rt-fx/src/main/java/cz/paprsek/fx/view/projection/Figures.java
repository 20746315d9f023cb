package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/** The figures of a scene's objects in one projection, each made once and kept as long as its object is in the scene. */
final class Figures {
    /** From how many objects on circles are drawn coarsely. */
    private static final int MANY = 2000;
    /** More things are not looked through for what lies within their boxes. */
    private static final int FEW = 50;

    private final Axes axes;
    private final IdentityHashMap<SceneObject, Figure> known = new IdentityHashMap<>();
    /** Those of them that are drawn as they are while a hand moves them. */
    private final Set<SceneObject> moving = Collections.newSetFromMap(new IdentityHashMap<>());
    private Scene scene = Scene.EMPTY;
    private boolean isMoved;

    Figures(Axes axes) {
        this.axes = axes;
    }

    /** @param changing whether a change is under way: what it makes anew is drawn roughly, and finely when it has ended */
    void show(Scene fresh, boolean changing) {
        if (!changing) {
            moving.forEach(known::remove);
            moving.clear();
        }
        isMoved = changing;
        if (fresh.objects().size() == scene.objects().size()) {
            // What still stands somewhere else is drawn anew when it is asked for.
            Arrays.stream(scene.objectsOtherThanIn(fresh)).forEach(i -> follow(scene.objects().get(i), fresh.objects().get(i)));
        } else {
            known.keySet().retainAll(identities(fresh.objects()));
        }
        scene = fresh;
    }

    /** What a hand only moves keeps its lines. */
    private void follow(SceneObject old, SceneObject now) {
        Figure figure = known.remove(old);
        if (figure != null && isMoved && old.shape() == now.shape() && now.placement().equals(old.placement().withPosition(now.placement().position())) && old.hidden() == now.hidden()) {
            Vec3 by = now.placement().position().minus(old.placement().position());
            known.put(now, figure.moved(axes.u(by), axes.v(by)));
            moving.remove(old);
            moving.add(now);
        }
    }

    /** Whether all is as in another scene, but for some items. */
    boolean isLike(Scene other, Set<ScenePath> apart) {
        return scene.objects().size() == other.objects().size() && scene.lights().size() == other.lights().size()
                && Arrays.stream(scene.objectsOtherThanIn(other)).mapToObj(ScenePath::body).allMatch(apart::contains)
                && IntStream.range(0, scene.lights().size()).filter(i -> !scene.lights().get(i).equals(other.lights().get(i)))
                        .mapToObj(ScenePath::light).allMatch(apart::contains);
    }

    private static Set<SceneObject> identities(List<SceneObject> objects) {
        Set<SceneObject> all = Collections.newSetFromMap(new IdentityHashMap<>());
        all.addAll(objects);
        return all;
    }

    Scene scene() {
        return scene;
    }

    List<SceneObject> objects() {
        return scene.objects();
    }

    Figure of(SceneObject object) {
        return known.computeIfAbsent(object, this::drawn);
    }

    private Figure drawn(SceneObject object) {
        if (isMoved) {
            moving.add(object);
        }
        return Figure.of(Body.of(object), axes, scene.objects().size() > MANY ? Figure.Fineness.COARSE : isMoved ? Figure.Fineness.MOVING : Figure.Fineness.FINE);
    }

    /** Of an object at another time, which is not kept. */
    Figure passing(SceneObject object) {
        return Figure.of(Body.of(object), axes, Figure.Fineness.MOVING);
    }

    Figure of(BodyAt at) {
        return of(scene.objects().get(at.numbers().get(0))).at(at.numbers().subList(1, at.numbers().size()));
    }

    /** Of many bodies, their figures, to be shown elsewhere as they are; none if they are few, or one has operands or no end. */
    List<Figure> ofMany(Set<ScenePath> items) {
        List<Figure> all = items.size() <= FEW ? List.of() : items.stream().filter(BodyAt.class::isInstance).map(item -> of((BodyAt) item)).toList();
        return all.stream().allMatch(figure -> figure.operands().isEmpty() && !figure.box().isEmpty()) && Places.bodies(items).stream().allMatch(at -> at.depth() == 0) ? all : List.of();
    }

    /** Whether figures are the others, all moved as the first is, to a small error. */
    @SuppressWarnings("ReferenceEquality")
    static boolean areMoved(List<Figure> before, List<Figure> now, double error) {
        return !now.isEmpty() && before.size() == now.size() && IntStream.range(0, now.size()).allMatch(i -> now.get(i).lines() == before.get(i).lines()
                && Math.abs(now.get(i).byU() - before.get(i).byU() - now.get(0).byU() + before.get(0).byU()) < error
                && Math.abs(now.get(i).byV() - before.get(i).byV() - now.get(0).byV() + before.get(0).byV()) < error);
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
            box = state.isHidden(ScenePath.body(i)) ? box : box.union(of(scene.objects().get(i)).box());
        }
        for (int i = 0; i < scene.lights().size(); i++) {
            box = state.isHidden(ScenePath.light(i)) ? box : box.union(box(ScenePath.light(i)));
        }
        return box;
    }
}
