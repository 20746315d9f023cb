package cz.paprsek.fx.model.motion;

import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Animation.Ease;
import cz.paprsek.scene.Animation.Turning;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;

/** Changes of keys: each takes a scene and gives another. All throw {@link IllegalArgumentException} with a sentence for the user if they cannot be. */
public final class Keys {
    /** Times nearer to each other than this are one, seconds. */
    private static final double SAME = 1e-6;

    private Keys() {}

    /**
     * One of a scene's keys.
     *
     * @param animation its animation's index in the scene
     * @param key its index in that
     */
    public record KeyAt(int animation, int key) {
        public boolean isIn(Scene scene) {
            return animation < scene.animations().size() && key < scene.animations().get(animation).keys().size();
        }

        public Animation.Key in(Scene scene) {
            return scene.animations().get(animation).keys().get(key);
        }
    }

    /** Which of a scene's animations are of what is selected, or of something within it; all if nothing is, or none of it is animated. */
    public static List<Integer> tracks(Scene scene, Set<ScenePath> selection) {
        List<Integer> own = all(scene).filter(i -> place(scene, i).filter(at -> selection.stream().anyMatch(item -> isWithin(at, item))).isPresent()).boxed().toList();
        return own.isEmpty() ? all(scene).boxed().toList() : own;
    }

    private static boolean isWithin(ScenePath place, ScenePath item) {
        return item.equals(place) || (item instanceof BodyAt outer && place instanceof BodyAt inner && outer.holds(inner));
    }

    private static IntStream all(Scene scene) {
        return IntStream.range(0, scene.animations().size());
    }

    /** What one of a scene's animations is of; empty of a parameter. */
    public static Optional<ScenePath> place(Scene scene, int animation) {
        Animation one = scene.animations().get(animation);
        return one.isOfParameter() ? Optional.empty() : Optional.of(ScenePath.parse(scene, one.target()));
    }

    /** The index of the animation of an attribute of what is at a place. */
    public static OptionalInt of(Scene scene, ScenePath place, String attribute) {
        return all(scene).filter(i -> scene.animations().get(i).attribute().equals(attribute) && place(scene, i).filter(place::equals).isPresent()).findFirst();
    }

    /** The index of the animation of a parameter. */
    public static OptionalInt of(Scene scene, String parameter) {
        return all(scene).filter(i -> scene.animations().get(i).target().equals(Animation.PARAMETER + parameter)).findFirst();
    }

    /** With a key of an attribute of what is at a place; it takes the place of one at the same time. */
    public static Scene added(Scene scene, ScenePath place, String attribute, double t, String value) {
        OptionalInt known = of(scene, place, attribute);
        return known.isPresent() ? added(scene, known.getAsInt(), t, value)
                : plus(scene, new Animation(place.text(scene), attribute, Turning.ANGLES, List.of(new Animation.Key(t, value, Ease.LINEAR))));
    }

    /** As the other, of a parameter. */
    public static Scene added(Scene scene, String parameter, double t, String value) {
        OptionalInt known = of(scene, parameter);
        return known.isPresent() ? added(scene, known.getAsInt(), t, value)
                : plus(scene, new Animation(Animation.PARAMETER + parameter, "value", Turning.ANGLES, List.of(new Animation.Key(t, value, Ease.LINEAR))));
    }

    private static Scene plus(Scene scene, Animation one) {
        List<Animation> all = new ArrayList<>(scene.animations());
        all.add(one);
        return scene.withAnimations(all);
    }

    /** With a key in one of its animations, which goes on as the one before it does. */
    public static Scene added(Scene scene, int animation, double t, String value) {
        return changed(scene, animation, keys -> {
            Ease ease = keys.stream().filter(key -> key.t() <= t + SAME).reduce((a, b) -> b).or(() -> keys.stream().findFirst()).map(Animation.Key::ease).orElse(Ease.LINEAR);
            return sorted(keys, new Animation.Key(t, value, ease));
        });
    }

    /** The index of the key at a time. */
    public static Optional<KeyAt> at(Scene scene, int animation, double t) {
        List<Animation.Key> keys = scene.animations().get(animation).keys();
        return IntStream.range(0, keys.size()).filter(i -> Math.abs(keys.get(i).t() - t) < SAME).mapToObj(i -> new KeyAt(animation, i)).findFirst();
    }

    /** With a key at another time; it takes the place of one that is there. */
    public static Scene moved(Scene scene, KeyAt at, double t) {
        return changed(scene, at.animation(), keys -> {
            Animation.Key old = keys.get(at.key());
            List<Animation.Key> others = new ArrayList<>(keys);
            others.remove(at.key());
            return sorted(others, new Animation.Key(t, old.value(), old.ease()));
        });
    }

    /** Without a key; with its last one an animation goes. */
    public static Scene removed(Scene scene, KeyAt at) {
        return changed(scene, at.animation(), keys -> {
            List<Animation.Key> others = new ArrayList<>(keys);
            others.remove(at.key());
            return others;
        });
    }

    /** With another way to go on from a key. */
    public static Scene eased(Scene scene, KeyAt at, Ease ease) {
        return changed(scene, at, key -> new Animation.Key(key.t(), key.value(), ease));
    }

    /** With another value at a key. */
    public static Scene valued(Scene scene, KeyAt at, String value) {
        return changed(scene, at, key -> new Animation.Key(key.t(), value, key.ease()));
    }

    private static Scene changed(Scene scene, KeyAt at, UnaryOperator<Animation.Key> change) {
        return changed(scene, at.animation(), keys -> {
            List<Animation.Key> all = new ArrayList<>(keys);
            all.set(at.key(), change.apply(all.get(at.key())));
            return all;
        });
    }

    private static Scene changed(Scene scene, int animation, UnaryOperator<List<Animation.Key>> change) {
        List<Animation> all = new ArrayList<>(scene.animations());
        Animation old = all.get(animation);
        List<Animation.Key> keys = change.apply(old.keys());
        if (keys.isEmpty()) {
            all.remove(animation);
        } else {
            all.set(animation, old.withKeys(keys));
        }
        return scene.withAnimations(all);
    }

    private static List<Animation.Key> sorted(List<Animation.Key> keys, Animation.Key fresh) {
        List<Animation.Key> all = new ArrayList<>(keys);
        all.removeIf(key -> Math.abs(key.t() - fresh.t()) < SAME);
        all.add(fresh);
        all.sort(Comparator.comparingDouble(Animation.Key::t));
        return all;
    }
}
