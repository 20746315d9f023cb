package cz.paprsek.fx.model;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.MeshFiles;
import cz.paprsek.formula.Written;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.SceneFiles;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyIntegerProperty;
import javafx.beans.property.ReadOnlyIntegerWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import org.jspecify.annotations.Nullable;

/**
 * The one truth of the editor: the scene, what is selected, and the history. Views read {@link #stateProperty} and redraw what is no longer
 * the same; all changes go through here. For JavaFX's thread only.
 */
public final class EditorModel {
    /** What takes copies apart, or is about each of them. */
    private static final Set<Edit> OF_ALL_COPIES = Set.of(Edit.COMBINE, Edit.GROUP, Edit.DISSOLVE, Edit.REORDER, Edit.HIDE, Edit.SHOW, Edit.LOCK, Edit.UNLOCK);

    private final History<EditorState> history = new History<>(EditorModel::step);
    private final ReadOnlyObjectWrapper<EditorState> state;
    private final ReadOnlyObjectWrapper<Scene> scene;
    private final ReadOnlyObjectWrapper<Set<ScenePath>> selection;
    private final ReadOnlyBooleanWrapper unsaved = new ReadOnlyBooleanWrapper();
    private final ReadOnlyBooleanWrapper gesturing = new ReadOnlyBooleanWrapper();
    private final ReadOnlyIntegerWrapper openings = new ReadOnlyIntegerWrapper();
    /** Where pictures come from that the scene names. */
    private Assets assets = Assets.none();
    private Recipe recipe = Recipe.NONE;
    private Map<Optional<ScenePath>, List<Written>> formulas = Map.of();
    private Copies copies = Copies.NONE;
    private @Nullable Scene saved;
    private Optional<OriginalText> savedText = Optional.empty();
    private @Nullable Gesture gesture;

    /** Begins with a scene that counts as saved. */
    public EditorModel(Scene start) {
        state = new ReadOnlyObjectWrapper<>(EditorState.of(start));
        scene = new ReadOnlyObjectWrapper<>(start);
        selection = new ReadOnlyObjectWrapper<>(Set.of());
        saved = start;
    }

    /** Where pictures come from that the scene names. */
    public Assets assets() {
        return assets;
    }

    /** Takes pictures from elsewhere from now on; to be told before the scene that needs them. */
    public void setAssets(Assets value) {
        assets = value;
    }

    /** The state shown: during a gesture, its preview. */
    public EditorState state() {
        return state.get();
    }

    public Scene scene() {
        return state().scene();
    }

    /** The formulas of the scene, by what has them, as {@link SceneFiles#formulas} finds them: once for all who ask. */
    public Map<Optional<ScenePath>, List<Written>> formulas() {
        lookThrough(scene());
        return formulas;
    }

    /** Which bodies of the scene are copies of others. */
    public Copies copies() {
        lookThrough(scene());
        return copies;
    }

    private void lookThrough(Scene now) {
        if (!now.recipe().equals(recipe)) {
            recipe = now.recipe();
            formulas = SceneFiles.formulas(now);
            copies = new Copies(SceneFiles.makers(now));
        }
    }

    /** What is selected, in the order of selecting. */
    public Set<ScenePath> selection() {
        return state().selection();
    }

    /** Changes after every change of any kind. */
    public ReadOnlyObjectProperty<EditorState> stateProperty() {
        return state.getReadOnlyProperty();
    }

    /** Changes only if the scene is another one. */
    public ReadOnlyObjectProperty<Scene> sceneProperty() {
        return scene.getReadOnlyProperty();
    }

    /** Changes only if other items are selected; the scene that they lead into has then been set already. */
    public ReadOnlyObjectProperty<Set<ScenePath>> selectionProperty() {
        return selection.getReadOnlyProperty();
    }

    /** What undo would undo. */
    public ReadOnlyObjectProperty<Optional<Label>> undoableProperty() {
        return history.undoableProperty();
    }

    /** What redo would redo. */
    public ReadOnlyObjectProperty<Optional<Label>> redoableProperty() {
        return history.redoableProperty();
    }

    /** Whether the scene differs from that opened or saved last. Scenes share what has not changed, so that the comparison costs little. */
    public ReadOnlyBooleanProperty unsavedProperty() {
        return unsaved.getReadOnlyProperty();
    }

    /** Whether a gesture is under way: what is shown may still be cancelled. */
    public ReadOnlyBooleanProperty gesturingProperty() {
        return gesturing.getReadOnlyProperty();
    }

    /** How many scenes have been opened, one in the place of another; changes before the scene does. */
    public ReadOnlyIntegerProperty openingsProperty() {
        return openings.getReadOnlyProperty();
    }

    /**
     * Changes the scene, as one step; no step if the change returns an equal scene. A gesture under way is committed first.
     *
     * @throws IllegalArgumentException with what is wrong, if the change makes a scene that cannot be; nothing is changed then
     */
    public void edit(Label label, UnaryOperator<Scene> change) {
        editState(label, before -> before.withScene(change.apply(before.scene())));
    }

    /** As {@link #edit}, for changes that also move, hide or select items, such as those of {@code Structure}. */
    public void editState(Label label, UnaryOperator<EditorState> change) {
        commitGesture();
        EditorState before = state();
        boolean isOfAll = OF_ALL_COPIES.contains(label.edit());
        EditorState changed = change.apply(isOfAll ? before.withSelection(copies().all(before.selection())) : before);
        EditorState after = withMeshes(isOfAll ? settled(before, changed) : following(before, changed));
        boolean isStep = isStep(before, after);
        if (isStep) {
            history.did(label, before, after);
        }
        show(isStep ? after : before.withSelection(after.selection()));
    }

    /** Begins a gesture; one under way is committed first. */
    public Gesture begin(Label label) {
        commitGesture();
        Gesture fresh = new Gesture(this, label, state());
        gesture = fresh;
        gesturing.set(true);
        return fresh;
    }

    /** Selects items and no others; no step of the history. Places that lead nowhere are left out. */
    public void select(Set<? extends ScenePath> items) {
        EditorState now = state();
        EditorState next = original(now.withSelection(items));
        if (!isSame(next.selection(), now.selection())) {
            show(next);
        }
    }

    public void select(ScenePath... items) {
        select(new LinkedHashSet<>(List.of(items)));
    }

    /** Looks through another camera of the scene, counted from 0: no step of the history, and nothing changes but the view. */
    public void look(int camera) {
        commitGesture();
        EditorState now = state();
        EditorState next = now.through(camera);
        if (next.eye() != now.eye()) {
            show(next);
        }
    }

    /** Undoes the last step, or cancels the gesture under way. */
    public void undo() {
        if (gesture != null) {
            gesture.cancel();
        } else {
            history.undo(state()).ifPresent(this::show);
        }
    }

    /** Does again what was undone last. */
    public void redo() {
        commitGesture();
        history.redo(state()).ifPresent(this::show);
    }

    /** Takes another scene, which counts as saved; the history is forgotten. */
    public void open(Scene fresh) {
        commitGesture();
        history.clear();
        EditorState read = withMeshes(EditorState.of(fresh));
        saved = read.scene();
        savedText = Optional.empty();
        openings.set(openings.get() + 1);
        show(read);
    }

    /** Takes another scene which counts as unsaved, such as one recovered; the history is forgotten. */
    public void openUnsaved(Scene fresh) {
        open(fresh);
        saved = null;
        show(state());
    }

    /** As {@link #openUnsaved(Scene)}, with the text that somebody has written for it. */
    public void openUnsaved(Scene fresh, OriginalText typed) {
        openUnsaved(fresh);
        show(state().withTyped(Optional.of(typed)));
    }

    /** Takes another scene in the place of this one as a step that can be undone, and which counts as saved: the file changed on disk. */
    public void reload(Label label, Scene fresh) {
        editState(label, old -> old.withScene(fresh).withTyped(Optional.empty()));
        saved(fresh);
    }

    /** Takes note that a scene has been saved; the history stays. */
    public void saved(Scene value) {
        saved = value;
        savedText = state().typed();
        show(state());
    }

    /** With the triangles of meshes, where their files can be read; else the picture says what is wrong with them. */
    private EditorState withMeshes(EditorState next) {
        Scene read = MeshFiles.read(next.scene(), assets, (place, problem) -> {});
        return next.withScene(read);
    }

    /** With formulas where their values have stayed, and the number where it has been changed by hand. */
    private static EditorState settled(EditorState before, EditorState after) {
        return after.scene().equals(before.scene()) ? after : after.withScene(SceneFiles.settled(after.scene()));
    }

    /** As the other, where copies follow the first. */
    private EditorState following(EditorState before, EditorState after) {
        return copies().isNone() || after.scene().equals(before.scene()) ? settled(before, after) : after.withScene(SceneFiles.following(after.scene()));
    }

    /** Shows what has become of a scene so far. */
    void preview(EditorState start, EditorState fresh) {
        Scene before = start.scene();
        Scene changed = fresh.scene();
        // Another camera or other settings are looked at many times a second, and nothing follows them.
        boolean isSame = changed.objects() == before.objects() || changed.objects().equals(before.objects());
        boolean isOfCopies = !copies().isNone() && !(isSame && changed.lights().equals(before.lights()) && changed.materials().equals(before.materials()));
        EditorState shown = isOfCopies ? fresh.withScene(SceneFiles.following(changed)) : fresh;
        show(!isOfCopies && (isSame || haveShapes(before, changed)) ? shown : withMeshes(shown));
    }

    /** Whether all things have the shapes they had, so that no files are to be read for them. */
    @SuppressWarnings("ReferenceEquality")
    private static boolean haveShapes(Scene before, Scene now) {
        return now.objects().size() == before.objects().size()
                && Arrays.stream(now.objectsOtherThanIn(before)).allMatch(i -> now.objects().get(i).shape() == before.objects().get(i).shape());
    }

    boolean isOpen(Gesture candidate) {
        return gesture == candidate;
    }

    void end(Gesture ended, boolean keep) {
        if (gesture != ended) {
            return;
        }
        gesture = null;
        gesturing.set(false);
        EditorState now = keep ? withMeshes(settled(ended.start(), state())) : state();
        boolean isStep = keep && isStep(ended.start(), now);
        if (isStep) {
            history.did(ended.label(), ended.start(), now);
        }
        // What a preview has selected, such as copies, means something else where they are not.
        show(isStep ? now : keep ? ended.start().withSelection(now.selection()) : ended.start());
    }

    /** Sets all properties, the state first, from which the methods above answer: whoever hears of any change finds all of it. */
    void show(EditorState shown) {
        EditorState next = original(shown);
        boolean selectsOthers = !isSame(next.selection(), selection.get());
        state.set(next);
        history.tell();
        unsaved.set(!next.scene().equals(saved) || !next.typed().equals(savedText));
        scene.set(next.scene());
        if (selectsOthers) {
            selection.set(next.selection());
        }
    }

    /** In the same order, too. What is only moved is the very same. */
    @SuppressWarnings("ReferenceEquality")
    private static boolean isSame(Set<ScenePath> one, Set<ScenePath> other) {
        return one == other || List.copyOf(one).equals(List.copyOf(other));
    }

    /** With the first in place of any copy that is selected. */
    private EditorState original(EditorState next) {
        lookThrough(next.scene());
        Set<ScenePath> originals = copies.originals(next.selection());
        return originals.equals(next.selection()) ? next : next.withSelection(originals);
    }

    private void commitGesture() {
        if (gesture != null) {
            gesture.commit();
        }
    }

    /** A step leads to its other end, but one goes on looking through the camera one looks through, unless the step was about that. */
    private static EditorState step(EditorState now, EditorState from, EditorState to) {
        boolean isAboutCameras = from.eye() != to.eye() || from.scene().cameras().size() != to.scene().cameras().size();
        return isAboutCameras ? to : to.through(now.eye());
    }

    /** Selecting alone is no step. */
    private static boolean isStep(EditorState before, EditorState after) {
        return !before.scene().equals(after.scene()) || !before.hidden().equals(after.hidden()) || !before.locked().equals(after.locked())
                || !before.typed().equals(after.typed());
    }
}
