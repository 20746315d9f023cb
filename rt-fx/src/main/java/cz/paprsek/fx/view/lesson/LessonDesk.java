package cz.paprsek.fx.view.lesson;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.lesson.Lesson;
import cz.paprsek.lesson.Lessons;
import cz.paprsek.scene.Scene;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** The lesson that is being held, and how far one has got in this and others: for as long as the editor lives, whatever language it speaks. */
public final class LessonDesk {
    private final EditorModel model;
    private final Opener opener;
    private final ReadOnlyObjectWrapper<Optional<Lesson>> current = new ReadOnlyObjectWrapper<>(Optional.empty());
    private final Map<Place, String> typed = new HashMap<>();
    private final Set<Place> done = new HashSet<>();
    private Optional<Lesson> last = Optional.empty();
    /** Which of the scenes that have been opened is that of the lesson. */
    private int opening = -1;
    /** Whether the lesson has been closed since: what has become of its scene is the user's own. */
    private boolean isLeft;

    /** A part of a lesson, by its number; files of the same name are not the same lesson. */
    private record Place(String name, Optional<Path> file, int part) {
        static Place of(Lesson lesson, int part) {
            return new Place(lesson.name(), lesson.file(), part);
        }
    }

    /** Opens a scene in the place of the one there is. */
    @FunctionalInterface
    public interface Opener {
        /**
         * Opens it.
         *
         * @param isAfterLesson whether the one there is began as that of the lesson that is held, and need not be kept
         * @return false if the user stays because of what is unsaved
         */
        boolean open(Scene scene, Assets assets, boolean isAfterLesson);
    }

    public LessonDesk(EditorModel model, Opener opener) {
        this.model = model;
        this.opener = opener;
    }

    /** The lesson that is being held, if there is one. */
    public ReadOnlyObjectProperty<Optional<Lesson>> currentProperty() {
        return current.getReadOnlyProperty();
    }

    /** Begins one of those that are shipped. */
    public void open(String name) {
        open(Lessons.shipped(name));
    }

    /** Begins a lesson with its scene; nothing happens if the user stays with the scene there is. */
    public void open(Lesson lesson) {
        if (begin(lesson, false)) {
            show(lesson);
        }
    }

    private void show(Lesson lesson) {
        last = Optional.of(lesson);
        current.set(last);
    }

    /**
     * Opens the scene of a lesson anew.
     *
     * @param isWorth whether what has become of the scene there is is not to be given up unasked
     */
    boolean begin(Lesson lesson, boolean isWorth) {
        if (!opener.open(lesson.scene(), lesson.assets(), isSceneOpen() && !isLeft && !isWorth)) {
            return false;
        }
        opening = model.openingsProperty().get();
        isLeft = false;
        return true;
    }

    /** Ends the lesson there is, or goes on with the one of last time, at first with the first. A scene of it that is still there stays as it is. */
    public void toggle() {
        if (current.get().isPresent()) {
            close();
        } else {
            last.ifPresentOrElse(lesson -> {
                if (isSceneOpen()) {
                    show(lesson);
                } else {
                    open(lesson);
                }
            }, () -> open(Lessons.NAMES.get(0)));
        }
    }

    /** Ends the lesson; its scene stays, and is not given up for another one unasked. */
    public void close() {
        isLeft = true;
        current.set(Optional.empty());
    }

    /** Whether the scene in the editor is that of the lesson, or what has become of it. */
    boolean isSceneOpen() {
        return opening == model.openingsProperty().get();
    }

    /** What has been answered to a question; empty if nothing has. */
    String typed(Lesson lesson, int part) {
        return typed.getOrDefault(Place.of(lesson, part), "");
    }

    void type(Lesson lesson, int part, String answer) {
        typed.put(Place.of(lesson, part), answer);
    }

    /** Whether a question has been answered rightly, or a task been done, at any time. */
    boolean isDone(Lesson lesson, int part) {
        return done.contains(Place.of(lesson, part));
    }

    void markDone(Lesson lesson, int part) {
        done.add(Place.of(lesson, part));
    }

    /** How many of a lesson's questions and tasks are done. */
    int done(Lesson lesson) {
        return (int) done.stream().filter(place -> place.equals(Place.of(lesson, place.part()))).count();
    }
}
