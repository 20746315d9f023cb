package cz.paprsek.fx.model.edit;

import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/** Changes of what there is in a scene, and of what it is called: animations, which go by names, follow what they are of. */
public final class Animated {
    private Animated() {}

    /**
     * Changes a scene; an animation of what is not there any more is dropped.
     *
     * @param place where in the changed scene something is that was at a place before
     * @throws IllegalArgumentException if the change makes a scene that cannot be
     */
    public static Scene through(Scene scene, UnaryOperator<Scene> change, Function<ScenePath, Optional<ScenePath>> place) {
        if (scene.animations().isEmpty()) {
            return change.apply(scene);
        }
        // Meanwhile nothing is animated: between the steps of a change there may be nothing of that name.
        Scene changed = change.apply(scene.withAnimations(List.of()));
        return changed.withAnimations(scene.animations().stream().flatMap(one -> (one.isOfParameter() ? Optional.of(one)
                : place.apply(ScenePath.parse(scene, one.target())).filter(now -> now.isIn(changed)).map(now -> of(changed, now, one))).stream()).toList());
    }

    /** With the target as it is written, as long as that leads there. */
    private static Animation of(Scene scene, ScenePath place, Animation one) {
        return leadsTo(scene, place, one.target()) ? one : new Animation(place.text(scene), one.attribute(), one.turn(), one.keys());
    }

    private static boolean leadsTo(Scene scene, ScenePath place, String target) {
        try {
            return ScenePath.parse(scene, target).equals(place);
        } catch (IllegalArgumentException nowhere) {
            return false;
        }
    }
}
