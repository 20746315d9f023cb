package cz.paprsek.fx.model.property;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * What of a scene a property is, if it can be animated.
 *
 * @param place what has it
 * @param attribute its name in files
 */
public record Keyed(ScenePath place, String attribute) {
    /** By how much numbers are changed to see what changes with them: so that there is always one that no range refuses. */
    private static final List<Double> NUDGES = List.of(1e-3, -1e-3, 1.0, -1.0);

    /** Empty if it is of several things, or there are no keys for it. */
    public static Optional<Keyed> of(Property property, Scene scene) {
        Optional<Spot> spot = property.target().spot(scene);
        Optional<ScenePath> place = spot.flatMap(Spot::place).filter(at -> at.isIn(scene));
        return place.map(at -> new Keyed(at, Spot.file(property.name()))).filter(keyed -> keyed.isOf(property, scene));
    }

    /** Whether it is this attribute that changes with the property, and not that of a pattern with the same name. */
    private boolean isOf(Property property, Scene scene) {
        Map<String, String> before = Animation.values(scene, place);
        if (!before.containsKey(attribute)) {
            return false;
        }
        for (double nudge : NUDGES) {
            try {
                Scene after = property.change(scene, value -> nudged(value, nudge));
                return !Objects.equals(before.get(attribute), Animation.values(after, place).get(attribute));
            } catch (IllegalArgumentException outOfRange) {
                // Another way, then.
            }
        }
        return false;
    }

    private static Object nudged(Object value, double by) {
        return value instanceof Double number ? (Object) (number + by)
                : value instanceof Integer whole ? (Object) (whole + (int) Math.signum(by))
                : value instanceof Vec3 vector ? new Vec3(vector.x() + by, vector.y() + by / 2, vector.z() + by / 4)
                : value instanceof Rgb color ? new Rgb(color.red() + by, color.green() + by, color.blue() + by) : value;
    }

    /** Its value as keys have it. */
    public Optional<String> value(Scene scene) {
        return Optional.ofNullable(Animation.values(scene, place).get(attribute));
    }
}
