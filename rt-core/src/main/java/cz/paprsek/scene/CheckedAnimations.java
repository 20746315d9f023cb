package cz.paprsek.scene;

import cz.paprsek.material.Material;
import java.util.AbstractList;
import java.util.List;
import java.util.Map;
import java.util.RandomAccess;

/** Animations that have been checked together with what they are of, and need not be again while that is the very same. */
final class CheckedAnimations extends AbstractList<Animation> implements RandomAccess {
    private final List<Animation> all;
    private final List<Camera> cameras;
    private final List<Light> lights;
    private final Map<String, Material> materials;
    private final List<SceneObject> objects;

    CheckedAnimations(List<Animation> all, Scene of) {
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
