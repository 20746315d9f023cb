package cz.paprsek.fx.model.edit;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.text.Numbers;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.StringTokenizer;

/** Keys of bodies that are taken into another space: that of another operation, or of the scene. */
final class CarriedKeys {
    private static final Set<String> PLACED = Set.of("position", "rotation", "scale");

    private CarriedKeys() {}

    /**
     * With the positions at the keys of a body in another space, so that it goes the same way in the world.
     *
     * @param map from the space that it is in to the other
     * @throws IllegalArgumentException if it turns or is stretched by keys, which would say something else there
     */
    static Scene into(Scene scene, BodyAt at, Affine map) {
        if (map.equals(Affine.IDENTITY)) {
            return scene;
        }
        List<Animation> all = new ArrayList<>(scene.animations());
        for (int i = 0; i < all.size(); i++) {
            Animation one = all.get(i);
            if (isPlaced(scene, at, one)) {
                all.set(i, carried(one, map));
            }
        }
        return all.equals(scene.animations()) ? scene : scene.withAnimations(all);
    }

    /** @throws IllegalArgumentException if an operation moves, whose operands would not any more without it */
    static void checkAtRest(Scene scene, BodyAt operation) {
        for (Animation one : scene.animations()) {
            if (isPlaced(scene, operation, one)) {
                throw new IllegalArgumentException("what is to be dissolved is animated, which would be lost; delete its keys first");
            }
        }
    }

    private static boolean isPlaced(Scene scene, BodyAt at, Animation one) {
        return !one.isOfParameter() && PLACED.contains(one.attribute()) && ScenePath.parse(scene, one.target()).equals(at);
    }

    private static Animation carried(Animation one, Affine map) {
        boolean isStraight = Moves.linear(map).equals(Affine.IDENTITY);
        if (!one.attribute().equals("position") || !one.path().isBlank()) {
            boolean stays = isStraight && !one.attribute().equals("position");
            if (!stays) {
                throw new IllegalArgumentException("this would make something else of what moves by keys, because an operation around it is placed otherwise; delete its keys first");
            }
            return one;
        }
        return one.withKeys(one.keys().stream().map(key -> new Animation.Key(key.t(), Numbers.text(Moves.rounded(map.point(place(key.value())))), key.ease())).toList());
    }

    private static Vec3 place(String value) {
        StringTokenizer words = new StringTokenizer(value);
        return new Vec3(Double.parseDouble(words.nextToken()), Double.parseDouble(words.nextToken()), Double.parseDouble(words.nextToken()));
    }
}
