package cz.paprsek.fx.model.edit;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Label;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class CamerasTest {
    private static final Camera FRONT = Camera.lookingAt(new Vec3(0, 0, 5), Vec3.ZERO).named("front");
    private static final Camera TOP = Camera.looking(new Vec3(0, 5, 0), new Vec3(0, -1, 0)).named("top");
    private static final Camera SIDE = Camera.lookingAt(new Vec3(5, 0, 0), Vec3.ZERO).named("side");
    private static final EditorState THREE = EditorState.of(Scene.EMPTY.withCameras(List.of(FRONT, TOP, SIDE))).withLocked(Set.of(ScenePath.camera(1)));

    @Test
    void lookingThroughAnotherCameraChangesNothingButTheView() {
        EditorModel model = new EditorModel(THREE.scene());
        model.look(2);
        assertThat(model.state().camera()).isEqualTo(SIDE);
        assertThat(model.state().seen().cameras()).containsExactly(SIDE, FRONT, TOP);
        assertThat(model.scene()).isSameAs(THREE.scene());
        assertThat(model.undoableProperty().get()).isEmpty();
        assertThat(model.unsavedProperty().get()).isFalse();
    }

    @Test
    void undoAndOtherEditsGoOnLookingThroughTheSameCamera() {
        EditorModel model = new EditorModel(THREE.scene());
        model.edit(Label.of(Label.Edit.ADD), scene -> scene.plus(Light.at(1, 2, 3)));
        model.look(1);
        model.undo();
        assertThat(model.state().camera()).isEqualTo(TOP);
        model.redo();
        assertThat(model.state().camera()).isEqualTo(TOP);
        model.open(Scene.EMPTY);
        assertThat(model.state().eye()).as("another document, another view").isZero();
    }

    @Test
    void aCameraIsMadeTheFirstAndLocksAndTheViewGoWithTheirs() {
        EditorModel model = new EditorModel(THREE.scene());
        model.editState(Label.of(Label.Edit.LOCK), state -> state.withLocked(Set.of(ScenePath.camera(1))));
        model.look(2);
        model.editState(Label.of(Label.Edit.REORDER), state -> Cameras.first(state, 2));
        assertThat(model.scene().cameras()).containsExactly(SIDE, FRONT, TOP);
        assertThat(model.state().locked()).containsExactly(ScenePath.camera(2));
        assertThat(model.state().camera()).isEqualTo(SIDE);
        model.undo();
        assertThat(model.scene()).isEqualTo(THREE.scene());
        assertThat(model.state().camera()).isEqualTo(SIDE);
    }

    @Test
    void aNewCameraSeesTheSameAndTheOldOneGetsANameIfItHasNone() {
        EditorState state = Cameras.add(EditorState.of(Scene.EMPTY.withCamera(FRONT.named(""))), "camera");
        assertThat(state.scene().cameras()).containsExactly(FRONT.named("camera"), FRONT.named("camera 2"));
        assertThat(state.camera().name()).isEqualTo("camera 2");
        assertThat(state.selection()).containsExactly(ScenePath.camera(1));
    }

    @Test
    void camerasAreCopiedNamedAndDeletedLikeEverythingElse() {
        EditorState state = Structure.duplicate(THREE.through(1), Set.of(ScenePath.camera(0)), Vec3.X);
        assertThat(state.scene().cameras()).extracting(Camera::name).containsExactly("front", "top", "side", "front 2");
        assertThat(state.selection()).containsExactly(ScenePath.camera(3));
        EditorState renamed = Structure.rename(state, ScenePath.camera(3), "near");
        EditorState left = Structure.delete(renamed, Set.of(ScenePath.camera(0), ScenePath.camera(2)));
        assertThat(left.scene().cameras()).extracting(Camera::name).containsExactly("top", "near");
        assertThat(left.camera()).as("still looked through").isEqualTo(TOP);
        assertThat(left.selection()).containsExactly(ScenePath.camera(1));
        assertThat(Structure.delete(left, Set.of(ScenePath.camera(0), ScenePath.camera(1))).scene().cameras()).as("the one looked through stays").containsExactly(TOP);
    }

    @Test
    void whatIsClickedBecomesSharp() {
        Camera focused = Cameras.focused(FRONT, new Vec3(1, 1, 2));
        assertThat(focused.lens()).isEqualTo(new Lens.Perspective(45, 0.06, 3));
        assertThat(Cameras.focused(focused, new Vec3(0, 0, -1)).lens()).isEqualTo(new Lens.Perspective(45, 0.06, 6));
        assertThat(Cameras.focused(focused, new Vec3(0, 0, 9))).as("behind the eye").isEqualTo(focused);
    }
}
