package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.scene.Camera;
import java.util.List;
import java.util.function.UnaryOperator;

/** A camera that no scene has: to look at things from elsewhere. Moving it changes nothing that is kept. */
final class FreeCamera implements Viewpoint {
    private Camera camera;
    private Runnable onMoved = () -> {};

    FreeCamera(Camera start) {
        camera = start;
    }

    @Override
    public Camera camera() {
        return camera;
    }

    @Override
    public Camera camera(EditorState state) {
        return camera;
    }

    @Override
    public boolean isLocked() {
        return false;
    }

    @Override
    public Move begin() {
        Camera start = camera;
        return new Move() {
            private boolean open = true;

            @Override
            public void preview(UnaryOperator<Camera> change) {
                if (open) {
                    show(change.apply(start));
                }
            }

            @Override
            public boolean isOpen() {
                return open;
            }

            @Override
            public void commit() {
                open = false;
            }

            @Override
            public void cancel() {
                preview(same -> same);
                open = false;
            }
        };
    }

    @Override
    public void change(UnaryOperator<Camera> change) {
        show(change.apply(camera));
    }

    @Override
    public EditorState seen(EditorState state) {
        // Without what moves: a film is of the scene's own cameras.
        return EditorState.of(state.seen().withAnimations(List.of()).withCamera(camera)).withHidden(state.hidden());
    }

    @Override
    public void setOnMoved(Runnable listener) {
        onMoved = listener;
    }

    private void show(Camera fresh) {
        camera = fresh;
        onMoved.run();
    }
}
