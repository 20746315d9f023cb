package cz.paprsek.fx;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.fx.model.edit.Clipboard;
import cz.paprsek.fx.model.edit.Structure;
import cz.paprsek.fx.model.item.Item;
import cz.paprsek.fx.model.item.Items;
import cz.paprsek.fx.view.texts.ItemNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Csg;
import cz.paprsek.xml.SceneFileException;
import java.util.LinkedHashSet;
import java.util.Locale;
import java.util.Set;
import java.util.function.UnaryOperator;
import javafx.scene.input.ClipboardContent;
import org.jspecify.annotations.Nullable;

/** What menus do with the selection; a sentence in the status bar if it cannot be done. */
final class EditActions {
    private static final double OFFSET = 0.25;

    private final EditorModel model;
    private final Texts texts;
    private final Notices notices;

    EditActions(EditorModel model, Texts texts, Notices notices) {
        this.model = model;
        this.texts = texts;
        this.notices = notices;
    }

    void delete() {
        remove(Edit.DELETE);
    }

    /** All that is selected, but for the camera and what is locked. */
    private void remove(Edit edit) {
        Set<Item> items = new LinkedHashSet<>(model.selection());
        items.removeIf(item -> item.equals(Item.CAMERA) || model.state().isLocked(item));
        if (!items.isEmpty()) {
            edit(edit, state -> Structure.delete(state, items));
        }
    }

    void duplicate() {
        edit(Edit.DUPLICATE, state -> Structure.duplicate(state, state.selection(), new Vec3(OFFSET, 0, OFFSET)));
    }

    void cut() {
        if (copy()) {
            remove(Edit.CUT);
        }
    }

    /** Whether there was something to copy. */
    boolean copy() {
        try {
            ClipboardContent content = new ClipboardContent();
            content.putString(Clipboard.copy(model.state(), model.selection()));
            javafx.scene.input.Clipboard.getSystemClipboard().setContent(content);
            return true;
        } catch (IllegalArgumentException nothing) {
            notices.say(String.valueOf(nothing.getMessage()));
            return false;
        }
    }

    void paste() {
        paste(javafx.scene.input.Clipboard.getSystemClipboard().getString());
    }

    /** Adds what is in the text of a scene file. */
    void paste(@Nullable String text) {
        try {
            if (text == null) {
                notices.say(texts.of("edit-problem.clipboard"));
                return;
            }
            EditorState pasted = Clipboard.paste(model.state(), text);
            model.editState(Label.of(Edit.PASTE, ItemNames.of(pasted.scene(), pasted.selection(), texts)), state -> pasted);
        } catch (SceneFileException | IllegalArgumentException noScene) {
            notices.say(texts.of("edit-problem.clipboard"));
        }
    }

    void combine(Csg.Operation operation) {
        String kind = texts.of("kind." + operation.name().toLowerCase(Locale.ROOT));
        edit(Label.of(Edit.COMBINE, kind), state -> Structure.combine(state, Items.bodies(state.selection()), operation, ""));
    }

    /** A group is a union with a name. */
    void group() {
        edit(Edit.GROUP, state -> Structure.combine(state, Items.bodies(state.selection()), Csg.Operation.UNION, texts.of("name.group")));
    }

    void dissolve() {
        edit(Edit.DISSOLVE, state -> Structure.dissolve(state, state.selection()));
    }

    void hide() {
        edit(Edit.HIDE, state -> Structure.hide(state, state.selection(), true).withSelection(Set.of()));
    }

    void showAll() {
        edit(Label.of(Edit.SHOW), state -> Structure.hide(state, state.hidden(), false));
    }

    void lock() {
        edit(Edit.LOCK, state -> Structure.lock(state, state.selection(), true).withSelection(Set.of()));
    }

    void unlockAll() {
        edit(Label.of(Edit.UNLOCK), state -> Structure.lock(state, state.locked(), false));
    }

    /** Everything that is neither hidden nor locked. */
    void selectAll() {
        Set<Item> all = new LinkedHashSet<>();
        for (int i = 0; i < model.scene().objects().size(); i++) {
            all.add(Item.body(i));
        }
        for (int i = 0; i < model.scene().lights().size(); i++) {
            all.add(Item.light(i));
        }
        all.removeIf(item -> model.state().isHidden(item) || model.state().isLocked(item));
        model.select(all);
    }

    private void edit(Edit edit, UnaryOperator<EditorState> change) {
        edit(Label.of(edit, ItemNames.of(model.scene(), model.selection(), texts)), change);
    }

    private void edit(Label label, UnaryOperator<EditorState> change) {
        try {
            model.editState(label, change);
        } catch (IllegalArgumentException refused) {
            notices.say(String.valueOf(refused.getMessage()));
        }
    }
}
