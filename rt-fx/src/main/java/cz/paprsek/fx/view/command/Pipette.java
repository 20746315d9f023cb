package cz.paprsek.fx.view.command;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.WeakChangeListener;

/** Makes what is selected of what the body is made of that is clicked next, in whatever view. */
public final class Pipette {
    private final Edits edits;
    private final EditorModel model;
    private final ReadOnlyBooleanWrapper active = new ReadOnlyBooleanWrapper();
    /** Held here, because the model, which outlives the window, holds it weakly. */
    private final ChangeListener<Set<ScenePath>> onSelection = (property, old, now) -> cancel();
    private List<BodyAt> onto = List.of();
    private Optional<BodyAt> taken = Optional.empty();

    Pipette(Edits edits) {
        this.edits = edits;
        this.model = edits.model();
        model.selectionProperty().addListener(new WeakChangeListener<>(onSelection));
    }

    /** Whether the next click is for it. */
    public ReadOnlyBooleanProperty activeProperty() {
        return active.getReadOnlyProperty();
    }

    public boolean isActive() {
        return active.get();
    }

    /** Whose material was taken last; empty if that was given up. */
    public Optional<BodyAt> taken() {
        return taken;
    }

    /** Waits for a click; a second time gives that up. */
    void toggle() {
        taken = Optional.empty();
        onto = Places.bodies(model.selection());
        active.set(!active.get() && !onto.isEmpty());
    }

    public void cancel() {
        active.set(false);
    }

    /** Takes the material of a body, if any is to be taken; beside all bodies it waits on. */
    public void take(Optional<BodyAt> from) {
        if (!active.get() || from.isEmpty()) {
            return;
        }
        Scene scene = model.scene();
        MaterialSource found = from.get().source(scene);
        // What an operation is made of is not what its operand has by itself.
        MaterialSource material = found == Inherited.INHERITED ? from.get().material(scene) : found;
        List<BodyAt> bodies = onto;
        taken = edits.attempt(() -> model.edit(Label.of(Label.Edit.CHANGE, PathNames.of(scene, bodies, edits.texts())),
                now -> now.with(bodies, (at, body) -> body.madeOf(material)))) ? from : Optional.empty();
        active.set(false);
    }
}
