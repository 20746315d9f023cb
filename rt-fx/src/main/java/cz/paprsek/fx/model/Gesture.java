package cz.paprsek.fx.model;

import cz.paprsek.scene.Scene;
import java.util.function.UnaryOperator;

/** A change under way, such as a drag: shown as it goes, and one step of the history at the end. Does nothing once it has ended. */
public final class Gesture {
    private final EditorModel model;
    private final Label label;
    private final EditorState start;

    Gesture(EditorModel model, Label label, EditorState start) {
        this.model = model;
        this.label = label;
        this.start = start;
    }

    /** The state when it began, which every preview starts from. */
    public EditorState start() {
        return start;
    }

    /** Whether it has neither been committed nor cancelled. */
    public boolean isOpen() {
        return model.isOpen(this);
    }

    /**
     * Shows the scene as it was at the start with a change; the previous preview is forgotten.
     *
     * @throws IllegalArgumentException if the change makes a scene that cannot be; the previous preview stays
     */
    public void preview(UnaryOperator<Scene> change) {
        if (isOpen()) {
            model.preview(start, start.withScene(change.apply(start.scene())));
        }
    }

    /** As {@link #preview}, of changes that also move or select items. */
    public void previewState(UnaryOperator<EditorState> change) {
        if (isOpen()) {
            model.preview(start, change.apply(start));
        }
    }

    /** Keeps what is shown as one step; no step if nothing is different. */
    public void commit() {
        model.end(this, true);
    }

    /** Goes back to the start. */
    public void cancel() {
        model.end(this, false);
    }

    Label label() {
        return label;
    }
}
