package cz.paprsek.fx.view.command;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.fx.model.edit.Adding;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.fx.model.edit.Structure;
import cz.paprsek.fx.model.item.Bodies;
import cz.paprsek.fx.model.item.Item;
import cz.paprsek.fx.model.item.Item.BodyAt;
import cz.paprsek.fx.model.item.Item.LightAt;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Shape;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/** What palette, menus and tree do to the scene, each one step with its name. What cannot be done is told in a sentence. */
public final class Commands {
    private final EditorModel model;
    private final Texts texts;
    private final Consumer<String> refusal;

    /** @param refusal is told why something cannot be done; empty when something was done */
    public Commands(EditorModel model, Texts texts, Consumer<String> refusal) {
        this.model = model;
        this.texts = texts;
        this.refusal = refusal;
    }

    /** Adds a shape where the user looks. */
    public void add(Shape shape, Sight sight) {
        String kind = texts.kind(shape);
        edit(Edit.ADD, kind, state -> Adding.shape(state, shape, kind, sight));
    }

    /** Adds a light where the user looks. */
    public void addLight(Sight sight) {
        String kind = texts.of("kind.light");
        edit(Edit.ADD, kind, state -> Adding.light(state, kind, sight));
    }

    /** Makes one solid of what is selected, in the order of selecting. */
    public void combine(Csg.Operation operation) {
        String kind = texts.of("kind." + operation.name().toLowerCase(Locale.ROOT));
        edit(Edit.COMBINE, kind, state -> Structure.combine(state, state.selection(), operation, kind));
    }

    /** Puts what the selected operations are made of in their place. */
    public void dissolve() {
        edit(Edit.DISSOLVE, subject(), state -> Structure.dissolve(state, state.selection()));
    }

    /** Deletes what is selected and not locked. */
    public void delete() {
        Set<Item> items = new LinkedHashSet<>(model.selection());
        items.removeIf(model.state()::isLocked);
        edit(Edit.DELETE, subject(items), state -> Structure.delete(state, items));
    }

    /** Copies what is selected, beside it. */
    public void duplicate() {
        Vec3 aside = new Vec3(Sight.of(model.scene()).size() / 2, 0, 0);
        edit(Edit.DUPLICATE, subject(), state -> Structure.duplicate(state, state.selection(), aside));
    }

    public void rename(Item item, String name) {
        edit(Edit.RENAME, name(item), state -> Structure.rename(state, item, name));
    }

    public void hide(Collection<? extends Item> items, boolean hidden) {
        edit(hidden ? Edit.HIDE : Edit.SHOW, subject(items), state -> Structure.hide(state, items, hidden));
    }

    public void lock(Collection<? extends Item> items, boolean locked) {
        edit(locked ? Edit.LOCK : Edit.UNLOCK, subject(items), state -> Structure.lock(state, items, locked));
    }

    /** Takes objects and operands elsewhere in the order, or into an operation. */
    public void move(Collection<? extends Item> items, Optional<BodyAt> parent, int index) {
        edit(Edit.REORDER, subject(items), state -> Structure.move(state, items, parent, index));
    }

    public void moveLight(LightAt light, int index) {
        edit(Edit.REORDER, name(light), state -> Structure.moveLight(state, light, index));
    }

    /** What a user calls an item: its name, or else its kind. */
    public String name(Item item) {
        if (item instanceof BodyAt at) {
            return Bodies.find(model.scene(), at).map(body -> body.name().isEmpty() ? texts.kind(body.shape()) : body.name()).orElse("");
        }
        if (item instanceof LightAt at && at.index() < model.scene().lights().size()) {
            String name = model.scene().lights().get(at.index()).name();
            return name.isEmpty() ? texts.of("kind.light") : name;
        }
        return texts.of("kind.camera");
    }

    private String subject() {
        return subject(model.selection());
    }

    private String subject(Collection<? extends Item> items) {
        return items.size() == 1 ? name(List.copyOf(items).get(0)) : "";
    }

    private void edit(Edit edit, String subject, UnaryOperator<EditorState> change) {
        try {
            model.editState(Label.of(edit, subject), change);
            refusal.accept("");
        } catch (IllegalArgumentException refused) {
            refusal.accept(String.valueOf(refused.getMessage()));
        }
    }
}
