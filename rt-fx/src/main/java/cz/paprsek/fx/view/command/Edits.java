package cz.paprsek.fx.view.command;

import cz.paprsek.formula.Maker;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.edit.Adding;
import cz.paprsek.fx.model.edit.Cameras;
import cz.paprsek.fx.model.edit.Clipboard;
import cz.paprsek.fx.model.edit.Materials;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.fx.model.edit.Pivots;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.fx.model.edit.Softness;
import cz.paprsek.fx.model.edit.Structure;
import cz.paprsek.fx.model.motion.Turntable;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Shape;
import cz.paprsek.text.Numbers;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.scene.input.ClipboardContent;
import org.jspecify.annotations.Nullable;

/** What menus, palette, tree and views do to the scene, each one step with its name. What cannot be done is told in a sentence. */
public final class Edits {
    /** How far a copy stands from its original, in parts of what is large enough to be seen well. */
    private static final double ASIDE = 0.25;

    private final EditorModel model;
    private final Texts texts;
    private final ReadOnlyStringWrapper refusal = new ReadOnlyStringWrapper("");
    private final Pipette pipette;

    public Edits(EditorModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
        pipette = new Pipette(this);
    }

    public Pipette pipette() {
        return pipette;
    }

    /** Why what was wanted last cannot be done; empty if it was done. */
    public ReadOnlyStringProperty refusalProperty() {
        return refusal.getReadOnlyProperty();
    }

    public EditorModel model() {
        return model;
    }

    public Texts texts() {
        return texts;
    }

    /** Adds a shape where the user looks. */
    public void add(Shape shape, Sight sight) {
        String kind = texts.kind(shape);
        edit(Label.of(Edit.ADD, kind), state -> Adding.shape(state, shape, kind, sight));
    }

    /** Adds an object with its middle where the user looks. */
    public void add(SceneObject object, Sight sight) {
        edit(Label.of(Edit.ADD, texts.kind(object.shape())), state -> Adding.object(state, object, sight));
    }

    /** Adds a light of a kind where the user looks. */
    public void add(Light light, Sight sight) {
        String kind = texts.kind(light);
        edit(Label.of(Edit.ADD, kind), state -> Adding.light(state, light, kind, sight));
    }

    /** Makes one solid of what is selected, in the order of selecting. */
    public void combine(Csg.Operation operation) {
        String kind = texts.of("kind." + operation.name().toLowerCase(Locale.ROOT));
        edit(Label.of(Edit.COMBINE, kind), state -> Structure.combine(state, Places.bodies(state.selection()), operation, kind));
    }

    /** A group is a union with a name. */
    void group() {
        edit(Edit.GROUP, model.selection(), state ->
                Structure.combine(state, Places.bodies(state.selection()), Csg.Operation.UNION, texts.of("name.group")));
    }

    /**
     * Repeats what is selected: beside each other, or around the middle of what it stands in. How often, and how far apart, the sheet and the handles say.
     *
     * @param isRound whether around
     */
    void repeat(boolean isRound) {
        Map<String, String> attributes = isRound ? Map.of("count", "6", "rotation", "0 60 0")
                : Map.of("count", "5", "position", Numbers.text(wide(Places.outermost(model.selection()))) + " 0 0");
        repeat(texts.of(isRound ? "object.repeat-round" : "object.repeat"), attributes);
    }

    /** Mirrors what is selected across the plane x = 0 of what it stands in: the copy follows the original. */
    public void mirror() {
        repeat(texts.of("object.mirror"), Map.of("count", "2", "scale", "-1 1 1"));
    }

    private void repeat(String name, Map<String, String> attributes) {
        List<BodyAt> bodies = Places.outermost(model.selection());
        edit(Label.of(Edit.CHANGE, name), state -> state.withScene(SceneFiles.repeated(state.scene(), bodies.stream().map(BodyAt::numbers).toList(), attributes)));
    }

    /** Makes a definition of what is selected, and uses it in its place: the picture stays. */
    void define() {
        Places.bodies(model.selection()).stream().findFirst().ifPresent(at -> edit(Label.of(Edit.CHANGE, texts.of("object.define")), state -> {
            String name = at.in(state.scene()).name();
            return state.withScene(SceneFiles.defined(state.scene(), at.numbers(), name.isEmpty() ? texts.kind(at.in(state.scene()).shape()) : name));
        }));
    }

    /** Uses the definition that what is selected is made by once more, beside it. */
    void another() {
        used().ifPresent(maker -> edit(Label.of(Edit.ADD, maker.attribute("of")), state -> {
            double aside = wide(List.of(new BodyAt(maker.originals().get(0))));
            return state.withScene(SceneFiles.usedAgain(state.scene(), maker.number(), aside));
        }));
    }

    /** The use of a definition that what is selected is made by, innermost. */
    Optional<Maker> used() {
        return Places.bodies(model.selection()).stream().findFirst().flatMap(at -> model.copies().of(at).stream().filter(maker -> !maker.isRepeat()).findFirst());
    }

    /** How far apart copies of bodies stand without touching: their width, and a little more. */
    private double wide(List<BodyAt> bodies) {
        Scene scene = model.scene();
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (BodyAt at : bodies) {
            Bounds box = at.in(scene).shape().bounds().transformed(at.in(scene).placement().toParent());
            least = Math.min(least, box.minX());
            most = Math.max(most, box.maxX());
        }
        double width = most > least && Double.isFinite(most - least) ? (most - least) * 1.25 : 1;
        return Double.parseDouble(Numbers.text(new BigDecimal(width).round(new MathContext(2)).doubleValue()));
    }

    /** Puts what the selected operations are made of in their place. */
    public void dissolve() {
        edit(Edit.DISSOLVE, model.selection(), state -> Structure.dissolve(state, state.selection()));
    }

    /** Adds a camera that sees what the one looked through sees. */
    public void addCamera() {
        String kind = texts.of("kind.camera");
        edit(Label.of(Edit.ADD, kind), state -> Cameras.add(state, kind));
    }

    /** Turns what is selected once around. */
    void turntable() {
        List<BodyAt> bodies = Places.outermost(model.selection());
        edit(Label.of(Edit.CHANGE, texts.of("object.turntable")), state -> state.withScene(Turntable.bodies(state.scene(), bodies)));
    }

    /** Takes the camera that is looked through once around what it looks at. */
    void turnCamera() {
        edit(Label.of(Edit.CHANGE, texts.of("view-menu.turntable")), Turntable::camera);
    }

    /** Makes a camera the first. */
    void makeFirst(int camera) {
        edit(Edit.REORDER, Set.of(ScenePath.camera(camera)), state -> Cameras.first(state, camera));
    }

    /** Makes shadows softer: of the lights that are selected, or of all if none is. */
    void soften() {
        List<LightAt> lights = Places.lights(model.selection());
        edit(Label.of(Edit.CHANGE, texts.of("object.soften")), state -> state.withScene(Softness.softened(state, lights)));
    }

    void removeCamera(int camera) {
        edit(Edit.DELETE, Set.of(ScenePath.camera(camera)), state -> Cameras.remove(state, List.of(ScenePath.camera(camera))));
    }

    /** Deletes what is selected, but for the last camera and what is locked. */
    public void delete() {
        remove(Edit.DELETE);
    }

    private void remove(Edit edit) {
        Set<ScenePath> items = new LinkedHashSet<>(model.selection());
        items.removeIf(model.state()::isLocked);
        if (!items.isEmpty()) {
            edit(edit, items, state -> Structure.delete(state, items));
        }
    }

    /** Copies what is selected, beside it. */
    void duplicate() {
        double aside = ASIDE * Sight.of(model.state()).size();
        edit(Edit.DUPLICATE, model.selection(), state -> Structure.duplicate(state, state.selection(), new Vec3(aside, 0, aside)));
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
            refusal.set("");
            return true;
        } catch (IllegalArgumentException nothing) {
            refusal.set(texts.sentence(String.valueOf(nothing.getMessage())));
            return false;
        }
    }

    void paste() {
        paste(javafx.scene.input.Clipboard.getSystemClipboard().getString());
    }

    /** Adds what is in the text of a scene file. */
    public void paste(@Nullable String text) {
        try {
            if (text == null) {
                refusal.set(texts.of("edit-problem.clipboard"));
                return;
            }
            EditorState pasted = Clipboard.paste(model.state(), text);
            edit(Edit.PASTE, pasted, state -> pasted);
        } catch (SceneFileException | IllegalArgumentException noScene) {
            refusal.set(texts.of("edit-problem.clipboard"));
        }
    }

    /** Makes a body of the material of a scene that has but one. */
    void give(BodyAt at, Scene scene) {
        scene.materials().forEach((name, material) -> edit(Edit.CHANGE, Set.of(at), state ->
                state.withScene(Materials.give(state.scene(), Set.of(at), name, material)).withSelection(Set.of(at))));
    }

    /** Makes what is selected of a named material; if nothing is, shows the scene's materials. */
    public void giveToSelected(String name, Material material) {
        List<BodyAt> bodies = Places.bodies(model.selection());
        if (bodies.isEmpty()) {
            model.select();
        } else {
            edit(Edit.CHANGE, bodies, state -> state.withScene(Materials.give(state.scene(), bodies, name, material)));
        }
    }

    /** Does one of the things of {@code Arranging} to what is selected. */
    void arrange(Edit edit, BiFunction<EditorState, Set<ScenePath>, EditorState> arranging) {
        edit(edit, model.selection(), state -> arranging.apply(state, state.selection()));
    }

    /** Gives what is selected pivots of their own, to be moved, or takes them away. */
    void pivot() {
        List<BodyAt> bodies = Places.bodies(model.selection());
        boolean isOwn = !hasPivot();
        edit(Edit.CHANGE, bodies, state -> state.withScene(Pivots.given(state.scene(), bodies, isOwn)));
    }

    boolean hasPivot() {
        return Places.bodies(model.selection()).stream().anyMatch(at -> Pivots.given(model.scene(), at).isPresent());
    }

    /** Leaves what is selected out of pictures, or takes it in again. */
    void leaveOut() {
        List<BodyAt> bodies = Places.bodies(model.selection());
        boolean isOut = !isLeftOut();
        edit(Edit.CHANGE, bodies, state -> state.withScene(state.scene().with(bodies, (at, body) -> body.hidden(isOut))));
    }

    boolean isLeftOut() {
        List<BodyAt> bodies = Places.bodies(model.selection());
        return !bodies.isEmpty() && bodies.stream().allMatch(at -> at.in(model.scene()).hidden());
    }

    public void rename(ScenePath item, String name) {
        edit(Edit.RENAME, Set.of(item), state -> Structure.rename(state, item, name));
    }

    public void hide(Collection<? extends ScenePath> items, boolean hidden) {
        edit(hidden ? Edit.HIDE : Edit.SHOW, items, state -> Structure.hide(state, items, hidden));
    }

    public void lock(Collection<? extends ScenePath> items, boolean locked) {
        edit(locked ? Edit.LOCK : Edit.UNLOCK, items, state -> Structure.lock(state, items, locked));
    }

    /** Hides what is selected, or shows it if it is hidden already. */
    void hideOrShow() {
        hide(model.selection(), !isHidden());
    }

    boolean isHidden() {
        return !model.selection().isEmpty() && model.state().hidden().containsAll(model.selection());
    }

    void showAll() {
        edit(Label.of(Edit.SHOW), state -> Structure.hide(state, state.hidden(), false));
    }

    /** Locks what is selected, or unlocks it if it is locked already. */
    void lockOrUnlock() {
        lock(model.selection(), !isLocked());
    }

    boolean isLocked() {
        return !model.selection().isEmpty() && model.state().locked().containsAll(model.selection());
    }

    void unlockAll() {
        edit(Label.of(Edit.UNLOCK), state -> Structure.lock(state, state.locked(), false));
    }

    /** Takes objects and operands elsewhere in the order, or into an operation. */
    public void move(Collection<? extends ScenePath> items, Optional<BodyAt> parent, int index) {
        edit(Edit.REORDER, items, state -> Structure.move(state, items, parent, index));
    }

    /** Moves items of the scene by a way in the world. */
    public void translate(Set<ScenePath> items, Vec3 by) {
        edit(Edit.MOVE, items, state -> state.withScene(Moves.translated(state.scene(), items, by)));
    }

    public void moveLight(LightAt light, int index) {
        edit(Edit.REORDER, Set.of(light), state -> Structure.moveLight(state, light, index));
    }

    /** Selects everything that is neither hidden nor locked. */
    void selectAll() {
        Set<ScenePath> all = new LinkedHashSet<>();
        for (int i = 0; i < model.scene().objects().size(); i++) {
            all.add(ScenePath.body(i));
        }
        for (int i = 0; i < model.scene().lights().size(); i++) {
            all.add(ScenePath.light(i));
        }
        all.removeIf(item -> model.state().isHidden(item) || model.state().isLocked(item));
        model.select(all);
    }

    private void edit(Edit edit, EditorState named, UnaryOperator<EditorState> change) {
        edit(Label.of(edit, PathNames.of(named.scene(), named.selection(), texts)), change);
    }

    private void edit(Edit edit, Collection<? extends ScenePath> items, UnaryOperator<EditorState> change) {
        edit(Label.of(edit, PathNames.of(model.scene(), items, texts)), change);
    }

    private void edit(Label label, UnaryOperator<EditorState> change) {
        attempt(() -> model.editState(label, change));
    }

    /**
     * Does what may be refused, such as a step of a gesture.
     *
     * @return whether it was done
     */
    public boolean attempt(Runnable change) {
        try {
            change.run();
            refusal.set("");
            return true;
        } catch (IllegalArgumentException refused) {
            refusal.set(texts.sentence(String.valueOf(refused.getMessage())));
            return false;
        }
    }
}
