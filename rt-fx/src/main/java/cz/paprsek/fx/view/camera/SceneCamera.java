package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Cameras;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.ScenePath;
import java.util.function.UnaryOperator;

/** The camera of the scene that is looked through: each move of it is a step of the history. */
record SceneCamera(EditorModel model) implements Viewpoint {

    @Override
    public Camera camera() {
        return model.state().camera();
    }

    @Override
    public Camera camera(EditorState state) {
        return state.camera();
    }

    @Override
    public boolean isLocked() {
        return model.state().isLocked(ScenePath.camera(model.state().eye()));
    }

    @Override
    public Move begin() {
        Gesture gesture = model.begin(Label.of(Label.Edit.CAMERA));
        return new Move() {
            @Override
            public void preview(UnaryOperator<Camera> change) {
                gesture.preview(scene -> Cameras.changed(scene, gesture.start().eye(), change));
            }

            @Override
            public boolean isOpen() {
                return gesture.isOpen();
            }

            @Override
            public void commit() {
                gesture.commit();
            }

            @Override
            public void cancel() {
                gesture.cancel();
            }
        };
    }

    @Override
    public void change(UnaryOperator<Camera> change) {
        int eye = model.state().eye();
        model.edit(Label.of(Label.Edit.CAMERA), scene -> Cameras.changed(scene, eye, change));
    }

    @Override
    public EditorState seen(EditorState state) {
        return state;
    }
}
