package cz.paprsek.fx.model.edit;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.item.Item;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Scene;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class CamerasTest {
    private static final Camera FRONT = Camera.lookingAt(new Vec3(0, 0, 5), Vec3.ZERO).named("front");
    private static final Camera TOP = Camera.looking(new Vec3(0, 5, 0), new Vec3(0, -1, 0)).named("top");
    private static final Camera SIDE = Camera.lookingAt(new Vec3(5, 0, 0), Vec3.ZERO).named("side");
    private static final EditorState THREE = EditorState.of(Scene.EMPTY.withCameras(List.of(FRONT, TOP, SIDE))).withLocked(Set.of(Item.camera(1)));

    @Test
    void aCameraThatIsLookedThroughComesFirstAndLocksGoWithTheirs() {
        EditorState state = Cameras.through(THREE, 2);
        assertThat(state.scene().cameras()).containsExactly(SIDE, FRONT, TOP);
        assertThat(state.locked()).containsExactly(Item.camera(2));
        assertThat(state.selection()).containsExactly(Item.CAMERA);
    }

    @Test
    void goingOnLeadsThroughAllAndBack() {
        EditorState state = Cameras.next(Cameras.next(Cameras.next(THREE)));
        assertThat(state.scene()).isEqualTo(THREE.scene());
    }

    @Test
    void aNewCameraSeesTheSameAndTheOldOneGetsANameIfItHasNone() {
        EditorState state = Cameras.add(EditorState.of(Scene.EMPTY.withCamera(FRONT.named(""))), "camera");
        assertThat(state.scene().cameras()).containsExactly(FRONT.named("camera 2"), FRONT.named("camera"));
        assertThat(Cameras.remove(state).scene().cameras()).containsExactly(FRONT.named("camera"));
        assertThat(Cameras.remove(Cameras.remove(state)).scene().cameras()).as("the last stays").hasSize(1);
    }

    @Test
    void whatIsClickedBecomesSharp() {
        Scene focused = Cameras.focused(Scene.EMPTY.withCamera(FRONT), new Vec3(1, 1, 2));
        assertThat(focused.camera().lens()).isEqualTo(new Lens.Perspective(45, 0.06, 3));
        assertThat(Cameras.focused(focused, new Vec3(0, 0, -1)).camera().lens()).isEqualTo(new Lens.Perspective(45, 0.06, 6));
        assertThat(Cameras.focused(focused, new Vec3(0, 0, 9))).as("behind the eye").isEqualTo(focused);
    }
}
