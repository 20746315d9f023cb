package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Shape;

/** Puts new things where the user looks, as changes for {@link EditorModel#editState}. */
public final class Adding {
    private Adding() {}

    /** Adds an object whose middle is where the user looks; one without bounds becomes the ground under what there is. */
    public static EditorState shape(EditorState state, Shape shape, String name, Sight sight) {
        Bounds box = shape.bounds();
        Vec3 place = box.isFinite()
                ? sight.point().minus(new Vec3((box.minX() + box.maxX()) / 2, (box.minY() + box.maxY()) / 2, (box.minZ() + box.maxZ()) / 2))
                : new Vec3(0, ground(state), 0);
        return Structure.add(state, SceneObject.of(shape).named(name).at(place.x(), place.y(), place.z()));
    }

    /** Adds a light above, beside and before what the user looks at. */
    public static EditorState light(EditorState state, String name, Sight sight) {
        Camera camera = state.scene().camera();
        Vec3 away = camera.right().times(-1).plus(Vec3.Y.times(2)).minus(camera.forward()).times(sight.size());
        Vec3 place = Sight.at(sight.point().plus(away), 4 * sight.size()).point();
        return Structure.add(state, Light.at(place.x(), place.y(), place.z()).named(name));
    }

    private static double ground(EditorState state) {
        Bounds box = Sight.bounds(state.scene());
        return box.isEmpty() ? 0 : box.minY() + 0.0;
    }
}
