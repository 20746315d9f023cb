package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.EditorState;
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

/** The figures of a scene's objects in one projection, each made once and kept as long as its object is in the scene. */
final class Figures {
    /** From how many objects on circles are drawn coarsely. */
    private static final int MANY = 2000;

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
            Arrays.stream(scene.objectsOtherThanIn(fresh)).mapToObj(scene.objects()::get).forEach(known::remove);
        } else {
            known.keySet().retainAll(identities(fresh.objects()));
        }
        scene = fresh;
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
