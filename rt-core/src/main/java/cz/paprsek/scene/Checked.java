package cz.paprsek.scene;

import cz.paprsek.list.Pieces;
import cz.paprsek.material.Material;
import java.util.AbstractList;
import java.util.AbstractMap;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.RandomAccess;
import java.util.Set;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** Parts of a scene that {@link SceneRules} has looked at, and need not look at again. */
final class Checked {
    private Checked() {}

    /** The list as it is kept. What another scene has been made of is not checked again. */
    static <T> Pieces<T> of(List<T> list, Object with, Consumer<List<T>> check) {
        Pieces<T> all = Pieces.of(list);
        if (!all.isCheckedWith(with)) {
            check.accept(all);
        }
        return all.checkedWith(with);
    }

    /** As {@link #of(List, Object, Consumer)}, of animations in a scene in which nothing moves. */
    static List<Animation> of(List<Animation> animations, Scene still) {
        if (animations instanceof Animations known && known.areOf(still)) {
            return known;
        }
        Animations copy = new Animations(animations, still);
        SceneRules.checkAnimations(still, copy, SceneRules.REFUSE);
        return copy;
    }

    /** The named materials of a scene, in the order of the file; checked by {@link SceneRules} when it was made. Immutable. */
    static final class Materials extends AbstractMap<String, Material> {
        private final Map<String, Material> all;

        Materials(Map<String, Material> materials) {
            all = Collections.unmodifiableMap(new LinkedHashMap<>(materials));
            SceneRules.checkMaterials(all, SceneRules.REFUSE);
        }

        @Override
        public boolean containsKey(Object name) {
            return all.containsKey(name);
        }

        @Override
        public @Nullable Material get(Object name) {
            return all.get(name);
        }

        @Override
        public Set<String> keySet() {
            return all.keySet();
        }

        @Override
        public Set<Entry<String, Material>> entrySet() {
            return all.entrySet();
        }
    }

    /** Animations that have been checked together with what they are of, and need not be again while that is the very same. */
    static final class Animations extends AbstractList<Animation> implements RandomAccess {
        private final List<Animation> all;
        private final List<Camera> cameras;
        private final List<Light> lights;
        private final Map<String, Material> materials;
        private final List<SceneObject> objects;

        Animations(List<Animation> all, Scene of) {
            this.all = List.copyOf(all);
            cameras = of.cameras();
            lights = of.lights();
            materials = of.materials();
            objects = of.objects();
        }

        @SuppressWarnings("ReferenceEquality")
        boolean areOf(Scene scene) {
            return cameras == scene.cameras() && lights == scene.lights() && materials == scene.materials() && objects == scene.objects();
        }

        @Override
        public Animation get(int index) {
            return all.get(index);
        }

        @Override
        public int size() {
            return all.size();
        }
    }
}
