package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Shape;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;

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

    /** Adds an object as it is turned and scaled, with its middle where the user looks. */
    public static EditorState object(EditorState state, SceneObject object, Sight sight) {
        Bounds box = object.shape().bounds().transformed(object.placement().toParent());
        Vec3 place = object.placement().position().plus(sight.point()).minus(new Vec3((box.minX() + box.maxX()) / 2, (box.minY() + box.maxY()) / 2, (box.minZ() + box.maxZ()) / 2));
        return Structure.add(state, object.at(place.x(), place.y(), place.z()));
    }

    /** One light of each kind. */
    public static final List<Light> LIGHTS = List.of(Light.at(0, 0, 0), SpotLight.from(Vec3.Y, Vec3.ZERO), AreaLight.rectangle(Vec3.ZERO, 1, 1),
            SphereLight.of(Vec3.ZERO, 1), SunLight.along(0, -1, 0));

    /** Adds a light of a kind above, beside and before what the user looks at, which it shines at, as brightly as its intensity says. */
    public static EditorState light(EditorState state, Light kind, String name, Sight sight) {
        Camera camera = state.camera();
        Vec3 away = camera.right().times(-1).plus(Vec3.Y.times(2)).minus(camera.forward()).times(sight.size());
        Vec3 place = Sight.at(sight.point().plus(away), 4 * sight.size()).point();
        return lightAt(state, kind, name, place, sight);
    }

    /**
     * Adds a light of a kind at a place.
     *
     * @param sight what it shines at, as brightly as its intensity says, and how large it is to be
     */
    public static EditorState lightAt(EditorState state, Light kind, String name, Vec3 place, Sight sight) {
        return Structure.add(state, light(kind, place, sight).named(name));
    }

    private static Light light(Light kind, Vec3 place, Sight sight) {
        double distance = BigDecimal.valueOf(sight.point().minus(place).length()).round(new MathContext(3)).doubleValue();
        if (kind instanceof SpotLight) {
            return SpotLight.from(place, sight.point());
        } else if (kind instanceof AreaLight) {
            AreaLight light = AreaLight.rectangle(place, sight.size(), sight.size()).withReferenceDistance(distance).shiningAt(sight.point());
            Vec3 turned = light.rotation();
            return light.withRotation(new Vec3(Math.rint(turned.x()) + 0.0, Math.rint(turned.y()) + 0.0, 0));
        } else if (kind instanceof SphereLight) {
            return SphereLight.of(place, sight.size() / 4).withReferenceDistance(distance);
        } else if (kind instanceof SunLight) {
            Vec3 direction = sight.point().minus(place);
            return SunLight.along(direction.x(), direction.y(), direction.z());
        }
        return Light.at(place.x(), place.y(), place.z());
    }

    private static double ground(EditorState state) {
        Bounds box = Sight.bounds(state.scene());
        return box.isEmpty() ? 0 : box.minY() + 0.0;
    }
}
