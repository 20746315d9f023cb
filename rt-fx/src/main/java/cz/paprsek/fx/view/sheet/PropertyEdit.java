package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.fx.model.property.Property;
import cz.paprsek.scene.Scene;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;

/** Changes of one property: at once as one step of the history, or bit by bit as one gesture. What is refused changes nothing and is told. */
final class PropertyEdit {
    private final EditorModel model;
    private final String subject;
    private final Consumer<Optional<String>> refusal;
    private @Nullable Gesture gesture;

    /**
     * @param subject what is changed, for "Undo change …"
     * @param refusal is told why a change was refused, or that the last one was not
     */
    PropertyEdit(EditorModel model, String subject, Consumer<Optional<String>> refusal) {
        this.model = model;
        this.subject = subject;
        this.refusal = refusal;
    }

    /** The scene as it is now. */
    Scene scene() {
        return model.scene();
    }

    /** The formula that a property's value is made of; empty if it is a number as it is. */
    Optional<String> formula(Property property, Scene scene) {
        return property.formula(scene, model.formulas());
    }

    /** Changes the scene in one step; whether it was not refused. */
    boolean change(UnaryOperator<Scene> change) {
        return attempt(() -> model.edit(label(), change));
    }

    /** Begins to change the scene bit by bit. */
    void begin() {
        gesture = model.begin(label());
    }

    /** Whether a change bit by bit is under way. */
    boolean isOpen() {
        return gesture != null && gesture.isOpen();
    }

    /** Shows the scene of the beginning with a change. */
    void preview(UnaryOperator<Scene> change) {
        Gesture current = gesture;
        if (current != null && current.isOpen()) {
            attempt(() -> current.preview(change));
        }
    }

    /** Keeps what was shown last. */
    void commit() {
        Gesture current = gesture;
        gesture = null;
        if (current != null && current.isOpen()) {
            current.commit();
            refusal.accept(Optional.empty());
        }
    }

    /** Goes back to the beginning. */
    void cancel() {
        Gesture current = gesture;
        gesture = null;
        if (current != null) {
            current.cancel();
            refusal.accept(Optional.empty());
        }
    }

    /** Tells why something was not even tried. */
    void refuse(IllegalArgumentException reason) {
        refusal.accept(Optional.of(String.valueOf(reason.getMessage())));
    }

    /** Takes back what was told last. */
    void forgive() {
        refusal.accept(Optional.empty());
    }

    private boolean attempt(Runnable change) {
        try {
            change.run();
            refusal.accept(Optional.empty());
            return true;
        } catch (IllegalArgumentException refused) {
            refuse(refused);
            return false;
        }
    }

    private Label label() {
        return Label.of(Edit.CHANGE, subject);
    }
}
