package cz.paprsek.fx.model.typing;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import java.util.List;
import java.util.Optional;

/** Where a state that was of one scene is of another that was written. */
final class Followed {
    private Followed() {}

    static EditorState to(EditorState state, Scene scene) {
        Places bodies = new Places(state.scene().objects(), scene.objects());
        Places lights = new Places(state.scene().lights(), scene.lights());
        Places cameras = new Places(state.scene().cameras(), scene.cameras());
        return state.moved(scene, place -> place instanceof BodyAt body
                ? bodies.of(body.numbers().get(0)).map(first -> {
                    Integer[] numbers = body.numbers().toArray(Integer[]::new);
                    numbers[0] = first;
                    return ScenePath.body(numbers);
                })
                : place instanceof LightAt light ? lights.of(light.index()).map(ScenePath::light)
                : place instanceof CameraAt camera ? cameras.of(camera.index()).map(ScenePath::camera)
                : Optional.of(place));
    }

    /** Where what has stayed before and behind a change in a list is now; what has changed in a list as long as before has stayed, too. */
    private record Places(int before, int firstBehind, int growth) {
        Places(List<?> old, List<?> now) {
            this(same(old, now), old, now);
        }

        private Places(int before, List<?> old, List<?> now) {
            this(before, old.size() - behind(old, now, before), now.size() - old.size());
        }

        private static int same(List<?> old, List<?> now) {
            int count = 0;
            while (count < Math.min(old.size(), now.size()) && old.get(count).equals(now.get(count))) {
                count++;
            }
            return count;
        }

        private static int behind(List<?> old, List<?> now, int before) {
            int count = 0;
            while (count < Math.min(old.size(), now.size()) - before && old.get(old.size() - 1 - count).equals(now.get(now.size() - 1 - count))) {
                count++;
            }
            return count;
        }

        Optional<Integer> of(int index) {
            return index < before || growth == 0 ? Optional.of(index) : index >= firstBehind ? Optional.of(index + growth) : Optional.empty();
        }
    }
}
