package cz.paprsek.fx.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.fx.model.edit.Structure;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;

class EditorModelTest {
    private static final Label ADD_LIGHT = Label.of(Edit.ADD, "light");

    private final Scene start = TestScenes.kitchen();
    private final EditorModel model = new EditorModel(start);

    @Test
    void undoGoesAllTheWayBackAndRedoForthAgain() {
        for (int i = 0; i < 1000; i++) {
            model.edit(ADD_LIGHT, scene -> scene.plus(Light.at(1, 2, 3)));
        }
        Scene end = model.scene();
        for (int i = 0; i < 1000; i++) {
            model.undo();
        }
        assertThat(model.scene()).isSameAs(start);
        assertThat(model.unsavedProperty().get()).isFalse();
        assertThat(model.undoableProperty().get()).isEmpty();
        for (int i = 0; i < 1000; i++) {
            model.redo();
        }
        assertThat(model.scene()).isSameAs(end);
        assertThat(model.redoableProperty().get()).isEmpty();
    }

    /** Ten thousand places are neither copied nor compared for each movement, and go with what they lead to. */
    @Test
    void whatIsSelectedIsTheVerySameWhileItIsDragged() {
        model.select(ScenePath.body(1), ScenePath.body(0), ScenePath.light(0));
        Set<ScenePath> selection = model.selection();
        Gesture drag = model.begin(Label.of(Edit.MOVE));
        drag.preview(scene -> Moves.translated(scene, selection, Vec3.X));
        assertThat(model.selection()).isSameAs(selection).containsExactly(ScenePath.body(1), ScenePath.body(0), ScenePath.light(0));
        drag.preview(scene -> scene.withLights(List.of()).withObjects(scene.objects().subList(0, 1)));
        assertThat(model.selection()).containsExactly(ScenePath.body(0));
    }

    @Test
    void undoTellsWhatItWouldUndo() {
        model.edit(ADD_LIGHT, scene -> scene.plus(Light.at(1, 2, 3)));
        model.edit(Label.of(Edit.MOVE, "ball"), scene -> Moves.translated(scene, Set.of(ScenePath.body(0)), Vec3.X));
        assertThat(model.undoableProperty().get()).contains(Label.of(Edit.MOVE, "ball"));
        model.undo();
        assertThat(model.undoableProperty().get()).contains(ADD_LIGHT);
        assertThat(model.redoableProperty().get()).contains(Label.of(Edit.MOVE, "ball"));
    }

    @Test
    void editAfterUndoForgetsWhatWasUndone() {
        model.edit(ADD_LIGHT, scene -> scene.plus(Light.at(1, 2, 3)));
        model.undo();
        model.edit(Label.of(Edit.RENAME), scene -> scene.withName("kitchen"));
        assertThat(model.redoableProperty().get()).isEmpty();
        model.redo();
        assertThat(model.scene().name()).isEqualTo("kitchen");
    }

    @Test
    void changeThatChangesNothingIsNoStep() {
        model.edit(Label.of(Edit.CHANGE), scene -> scene.with(ScenePath.body(0), body -> body.named("ball")));
        assertThat(model.undoableProperty().get()).isEmpty();
        assertThat(model.unsavedProperty().get()).isFalse();
    }

    @Test
    void refusedChangeLeavesEverythingAsItWas() {
        assertThatThrownBy(() -> model.edit(Label.of(Edit.RENAME), scene -> scene.with(ScenePath.body(0), body -> body.named("bowl"))))
                .isInstanceOf(IllegalArgumentException.class).hasMessageContaining("already an object named \"bowl\"");
        assertThat(model.scene()).isSameAs(start);
        assertThat(model.undoableProperty().get()).isEmpty();
    }

    @Test
    void saveKeepsTheHistoryAndMovesTheUnsavedMark() {
        model.edit(ADD_LIGHT, scene -> scene.plus(Light.at(1, 2, 3)));
        model.saved(model.scene());
        assertThat(model.unsavedProperty().get()).isFalse();
        model.undo();
        assertThat(model.unsavedProperty().get()).isTrue();
        assertThat(model.scene()).isSameAs(start);
        model.redo();
        assertThat(model.unsavedProperty().get()).isFalse();
    }

    @Test
    void gestureIsOneStepHoweverManyPreviews() {
        Gesture drag = model.begin(Label.of(Edit.MOVE, "ball"));
        assertThat(model.gesturingProperty().get()).isTrue();
        for (int i = 1; i <= 100; i++) {
            Vec3 by = new Vec3(i * 0.1, 0, 0);
            drag.preview(scene -> Moves.translated(scene, Set.of(ScenePath.body(0)), by));
        }
        drag.commit();
        assertThat(model.gesturingProperty().get()).isFalse();
        assertThat(model.scene().objects().get(0).placement().position()).isEqualTo(new Vec3(10, 0, 0));
        model.undo();
        assertThat(model.scene()).isSameAs(start);
    }

    @Test
    void cancelledGestureThatSelectsOthersLeavesTheSelectionAsItWas() {
        model.select(ScenePath.body(0));
        Gesture drag = model.begin(Label.of(Edit.MOVE, "ball"));
        drag.previewState(state -> Structure.duplicate(state, state.selection(), Vec3.X));
        assertThat(model.selection()).isNotEqualTo(Set.of(ScenePath.body(0)));
        drag.cancel();
        assertThat(model.selection()).containsExactly(ScenePath.body(0));
    }

    @Test
    void cancelledGestureLeavesNoTrace() {
        Gesture drag = model.begin(Label.of(Edit.MOVE, "ball"));
        drag.preview(scene -> Moves.translated(scene, Set.of(ScenePath.body(0)), Vec3.X));
        assertThat(model.unsavedProperty().get()).isTrue();
        drag.cancel();
        assertThat(model.scene()).isSameAs(start);
        assertThat(model.unsavedProperty().get()).isFalse();
        assertThat(model.undoableProperty().get()).isEmpty();
        drag.preview(scene -> scene.withName("too late"));
        drag.commit();
        assertThat(model.scene()).isSameAs(start);
    }

    @Test
    void undoDuringAGestureCancelsIt() {
        model.edit(ADD_LIGHT, scene -> scene.plus(Light.at(1, 2, 3)));
        Scene before = model.scene();
        Gesture drag = model.begin(Label.of(Edit.MOVE, "ball"));
        drag.preview(scene -> Moves.translated(scene, Set.of(ScenePath.body(0)), Vec3.X));
        model.undo();
        assertThat(model.scene()).isSameAs(before);
        assertThat(drag.isOpen()).isFalse();
    }

    @Test
    void gestureThatIsRefusedKeepsItsLastPreview() {
        Gesture drag = model.begin(Label.of(Edit.RESIZE, "ball"));
        drag.preview(scene -> Moves.scaled(scene, Set.of(ScenePath.body(0)), Vec3.ZERO, new Vec3(2, 2, 2)));
        assertThatThrownBy(() -> drag.preview(scene -> Moves.scaled(scene, Set.of(ScenePath.body(0)), Vec3.ZERO, new Vec3(0, 2, 2))))
                .hasMessageContaining("scale must not be 0");
        drag.commit();
        assertThat(model.scene().objects().get(0).placement().scale()).isEqualTo(new Vec3(2, 2, 2));
    }

    @Test
    void selectionIsNoStepAndSurvivesUndoOfOtherThings() {
        model.select(ScenePath.body(1, 1), ScenePath.light(0));
        assertThat(model.undoableProperty().get()).isEmpty();
        assertThat(model.selection()).containsExactly(ScenePath.body(1, 1), ScenePath.light(0));
        model.edit(ADD_LIGHT, scene -> scene.plus(Light.at(1, 2, 3)));
        assertThat(model.selection()).containsExactly(ScenePath.body(1, 1), ScenePath.light(0));
    }

    @Test
    void itemsThatLeadNowhereAreNotSelected() {
        model.select(ScenePath.body(9), ScenePath.body(1, 7), ScenePath.body(0, 0), ScenePath.light(5), ScenePath.body(1, 1, 0), ScenePath.camera());
        assertThat(model.selection()).containsExactly(ScenePath.body(1, 1, 0), ScenePath.camera());
    }

    @Test
    void whoHearsOfASelectionFindsItsScene() {
        List<Integer> objects = new ArrayList<>();
        model.selectionProperty().addListener((property, old, now) -> objects.add(model.scene().objects().size()));
        model.editState(Label.of(Edit.ADD), state -> Structure.add(state, SceneObject.of(new Sphere(1))));
        assertThat(objects).containsExactly(5);
    }

    @Test
    void recoveredSceneCountsAsUnsaved() {
        model.openUnsaved(TestScenes.kitchen());
        assertThat(model.unsavedProperty().get()).isTrue();
        assertThat(model.undoableProperty().get()).isEmpty();
    }

    @Test
    void hidingIsAStepButNoChangeOfTheFile() {
        model.editState(Label.of(Edit.HIDE), state -> Structure.hide(state, Set.of(ScenePath.body(1)), true));
        assertThat(model.state().isHidden(ScenePath.body(1, 1, 0))).isTrue();
        assertThat(model.unsavedProperty().get()).isFalse();
        model.undo();
        assertThat(model.state().isHidden(ScenePath.body(1))).isFalse();
    }

    @Test
    void copiesOfAMeshAreReadInAPreviewAndAfterwards() throws Exception {
        byte[] corner = "v 0 0 0\nv 3 0 0\nv 0 4 0\nv 0 0 5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n".getBytes(StandardCharsets.UTF_8);
        model.setAssets(Assets.of(Map.of("corner.obj", corner, "other.obj", corner)));
        model.open(SceneFiles.parse("""
                <scene xmlns="urn:paprsek:scene:1">
                  <camera position="0 2 9" target="0 0 0"/>
                  <repeat count="3" position="4 0 0"><mesh file="corner.obj"/></repeat>
                </scene>"""));
        UnaryOperator<Scene> changed = scene -> scene.with(ScenePath.body(0), body -> body.withShape(Mesh.of("other.obj")));
        Gesture gesture = model.begin(Label.of(Edit.CHANGE));
        gesture.preview(changed);
        assertThat(model.scene().objects()).extracting(SceneObject::shape).hasSize(3).allMatch(shape -> shape instanceof Mesh mesh && mesh.file().equals("other.obj") && mesh.isRead());
        gesture.commit();
        assertThat(model.scene().objects()).extracting(SceneObject::shape).allMatch(shape -> shape instanceof Mesh mesh && mesh.isRead());
        model.undo();
        model.edit(Label.of(Edit.CHANGE), changed);
        assertThat(model.scene().objects()).extracting(SceneObject::shape).allMatch(shape -> shape instanceof Mesh mesh && mesh.file().equals("other.obj") && mesh.isRead());
    }

    /** Ten thousand things are not looked through for files for each movement of one of them. */
    @Test
    void whatIsOnlyMovedIsNotReadBeforeTheEnd() {
        model.open(Scene.EMPTY.plus(SceneObject.of(Mesh.of("corner.obj"))));
        Gesture drag = model.begin(Label.of(Edit.MOVE));
        model.setAssets(Assets.of(Map.of("corner.obj", "v 0 0 0\nv 3 0 0\nv 0 4 0\nv 0 0 5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n".getBytes(StandardCharsets.UTF_8))));
        drag.preview(scene -> Moves.translated(scene, Set.of(ScenePath.body(0)), Vec3.X));
        assertThat(((Mesh) model.scene().objects().get(0).shape()).isRead()).isFalse();
        drag.commit();
        assertThat(((Mesh) model.scene().objects().get(0).shape()).isRead()).isTrue();
        assertThat(model.scene().objects().get(0).placement().position()).isEqualTo(Vec3.X);
    }

    @Test
    void aGestureThatChangesNoBodyKeepsTheCopies() throws Exception {
        model.open(SceneFiles.parse("""
                <scene xmlns="urn:paprsek:scene:1">
                  <camera position="0 2 9" target="0 0 0"/>
                  <repeat count="3" position="4 0 0"><sphere radius="1"/></repeat>
                </scene>"""));
        Scene before = model.scene();
        Gesture gesture = model.begin(Label.of(Edit.CAMERA));
        gesture.preview(scene -> scene.withCamera(scene.camera().withPosition(new Vec3(1, 2, 3))));
        assertThat(model.scene().recipe()).as("made anew at the end only").isSameAs(before.recipe());
        gesture.commit();
        assertThat(model.scene().camera().position()).isEqualTo(new Vec3(1, 2, 3));
        assertThat(model.copies().isNone()).isFalse();
    }
}
