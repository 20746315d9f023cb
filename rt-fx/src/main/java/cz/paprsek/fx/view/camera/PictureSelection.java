package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Places;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import javafx.scene.input.MouseEvent;

/** Selects what is clicked in a picture. */
final class PictureSelection {
    private final EditorModel model;

    PictureSelection(EditorModel model) {
        this.model = model;
    }

    /** @param seen what is there, innermost; empty for nothing */
    void click(MouseEvent event, Optional<ScenePath> seen) {
        boolean more = event.isShiftDown() || event.isShortcutDown();
        if (seen.isPresent()) {
            select(seen.get() instanceof BodyAt innermost && !event.isAltDown() ? more ? innermost.object() : deeper(innermost) : seen.get(), more);
        } else if (!more) {
            model.select();
        }
    }

    /** Selects the object of a body whose menu is asked for, unless it, or what it is within, is selected already. */
    void ask(BodyAt body) {
        if (Places.bodies(model.selection()).stream().noneMatch(selected -> selected.equals(body) || selected.holds(body))) {
            select(body.object(), false);
        }
    }

    /** The object, or what is one level further inside if that is selected already. */
    BodyAt deeper(BodyAt innermost) {
        if (model.selection().size() == 1 && model.selection().iterator().next() instanceof BodyAt selected && selected.holds(innermost)) {
            return selected.child(innermost.numbers().get(selected.depth() + 1));
        }
        return innermost.object();
    }

    private void select(ScenePath chosen, boolean more) {
        if (model.state().isLocked(chosen)) {
            return;
        }
        Set<ScenePath> selection = new LinkedHashSet<>(more ? model.selection() : Set.of());
        if (!more || !selection.remove(chosen)) {
            selection.add(chosen);
        }
        model.select(selection);
    }
}
