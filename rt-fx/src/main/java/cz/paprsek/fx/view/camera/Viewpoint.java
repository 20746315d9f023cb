package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.scene.Camera;
import java.util.function.UnaryOperator;

/** From where a picture is seen, and what moves that. */
interface Viewpoint {
    /** A move under way, such as a drag. */
    interface Move {
        /** Shows what becomes of the camera as it was at the start. */
        void preview(UnaryOperator<Camera> change);

        boolean isOpen();

        void commit();

        void cancel();
    }

    Camera camera();

    /** The camera that a state is seen by from here, such as that of another time. */
    Camera camera(EditorState state);

    /** Whether it is not to be moved. */
    boolean isLocked();

    Move begin();

    void change(UnaryOperator<Camera> change);

    /** A state as it is seen from here. */
    EditorState seen(EditorState state);

    /** Is told when another camera is looked through that no state knows of. */
    default void setOnMoved(Runnable listener) {}
}
