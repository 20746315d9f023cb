package cz.paprsek.fx.model;

import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.xml.OriginalText;
import java.util.AbstractSet;
import java.util.Collections;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * All that an edit may change. Places that lead nowhere are dropped.
 *
 * @param scene what is edited
 * @param selection in the order of selecting
 * @param hidden what the editor does not show; files and renders have it all the same
 * @param locked what cannot be picked or moved in the editor
 * @param typed the text that the scene's file starts from, if somebody has written in it since it was opened
 * @param eye which of the scene's cameras is looked through, counted from 0; the scene does not know. One that is not there means the first
 */
public record EditorState(Scene scene, Set<ScenePath> selection, Set<ScenePath> hidden, Set<ScenePath> locked, Optional<OriginalText> typed, int eye) {

    public EditorState {
        selection = existing(scene, selection);
        hidden = existing(scene, hidden);
        locked = existing(scene, locked);
        eye = eye >= 0 && eye < scene.cameras().size() ? eye : 0;
    }

    /** A scene of which nothing is selected, hidden or locked. */
    public static EditorState of(Scene scene) {
        return new EditorState(scene, Set.of(), Set.of(), Set.of(), Optional.empty(), 0);
    }

    public EditorState withScene(Scene value) {
        return new EditorState(value, selection, hidden, locked, typed, eye);
    }

    public EditorState withSelection(Set<? extends ScenePath> value) {
        Set<ScenePath> items = value instanceof Chosen known ? known : new LinkedHashSet<>(value);
        return new EditorState(scene, items, hidden, locked, typed, eye);
    }

    public EditorState withHidden(Set<ScenePath> value) {
        return new EditorState(scene, selection, value, locked, typed, eye);
    }

    public EditorState withLocked(Set<ScenePath> value) {
        return new EditorState(scene, selection, hidden, value, typed, eye);
    }

    public EditorState withTyped(Optional<OriginalText> value) {
        return new EditorState(scene, selection, hidden, locked, value, eye);
    }

    /** Looking through another camera, counted from 0: the scene stays as it is. */
    public EditorState through(int value) {
        return value == eye ? this : new EditorState(scene, selection, hidden, locked, typed, value);
    }

    /** The camera that is looked through. */
    public Camera camera() {
        return scene.cameras().get(eye);
    }

    /** The scene as it is looked at: the camera that is looked through comes first. */
    public Scene seen() {
        return eye == 0 ? scene : scene.through(eye);
    }

    /** Another scene, with each item taken to where it is now; one without a place is dropped. */
    public EditorState moved(Scene value, Function<ScenePath, Optional<ScenePath>> place) {
        int looking = place.apply(ScenePath.camera(eye)).filter(CameraAt.class::isInstance).map(item -> ((CameraAt) item).index()).orElse(0);
        return new EditorState(value, moved(selection, place), moved(hidden, place), moved(locked, place), typed, looking);
    }

    /** Whether an item, or an operation around it, is hidden. */
    public boolean isHidden(ScenePath item) {
        return isWithin(hidden, item);
    }

    /** Whether an item, or an operation around it, is locked. */
    public boolean isLocked(ScenePath item) {
        return isWithin(locked, item);
    }

    private static boolean isWithin(Set<ScenePath> items, ScenePath item) {
        if (items.isEmpty()) {
            return false;
        }
        if (item instanceof BodyAt body && body.depth() > 0) {
            return items.contains(body) || isWithin(items, body.parent());
        }
        return items.contains(item);
    }

    private static Set<ScenePath> existing(Scene scene, Set<ScenePath> items) {
        if (items instanceof Chosen known && known.isIn(scene)) {
            return known;
        }
        Set<ScenePath> kept = new LinkedHashSet<>(items);
        kept.removeIf(item -> !item.isIn(scene));
        return new Chosen(kept);
    }

    /** Places in an order, never changed: of one movement after another the very same, which for ten thousand of them is neither copied nor looked through. */
    private static final class Chosen extends AbstractSet<ScenePath> {
        private final Set<ScenePath> items;
        /** Objects that a scene must have at least. */
        private final int objects;
        private final List<ScenePath> others;

        Chosen(Set<ScenePath> items) {
            this.items = Collections.unmodifiableSet(items);
            objects = 1 + items.stream().filter(Chosen::isObject).mapToInt(item -> ((BodyAt) item).index()).max().orElse(-1);
            others = items.stream().filter(item -> !isObject(item)).toList();
        }

        private static boolean isObject(ScenePath item) {
            return item instanceof BodyAt body && body.depth() == 0 && body.index() >= 0;
        }

        boolean isIn(Scene scene) {
            return scene.objects().size() >= objects && others.stream().allMatch(item -> item.isIn(scene));
        }

        @Override
        public boolean contains(Object item) {
            return items.contains(item);
        }

        @Override
        public Iterator<ScenePath> iterator() {
            return items.iterator();
        }

        @Override
        public int size() {
            return items.size();
        }
    }

    private static Set<ScenePath> moved(Set<ScenePath> items, Function<ScenePath, Optional<ScenePath>> place) {
        return items.stream().flatMap(item -> place.apply(item).stream()).collect(Collectors.toCollection(LinkedHashSet::new));
    }
}
