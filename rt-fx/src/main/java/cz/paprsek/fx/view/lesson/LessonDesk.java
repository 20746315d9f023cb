package cz.paprsek.fx.view.lesson;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.lesson.Lesson;
import cz.paprsek.lesson.Lessons;
import cz.paprsek.scene.Scene;
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
    private String last = Lessons.NAMES.get(0);
    /** Which of the scenes that have been opened is that of the lesson. */
    private int opening = -1;

    /** A part of a lesson, by its number. */
    private record Place(String lesson, int part) {}

    /** Opens a scene in the place of the one there is. */
    @FunctionalInterface
    public interface Opener {
        /**
         * Opens it.
         *
         * @param isAfterLesson whether the one there is began as that of a lesson, and need not be kept
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
        last = name;
    }

    /** Begins a lesson with its scene; nothing happens if the user stays with the scene there is. */
    public void open(Lesson lesson) {
        if (begin(lesson)) {
            current.set(Optional.of(lesson));
        }
    }

    /** Opens the scene of a lesson anew. */
    boolean begin(Lesson lesson) {
        if (!opener.open(lesson.scene(), lesson.assets(), isSceneOpen())) {
            return false;
        }
        opening = model.openingsProperty().get();
        return true;
    }

    /** Ends the lesson there is, or goes on with the one of last time, at first with the first. */
    public void toggle() {
        if (current.get().isPresent()) {
            close();
        } else {
            open(last);
        }
    }

    /** Ends the lesson; its scene stays. */
    public void close() {
        current.set(Optional.empty());
    }

    /** Whether the scene in the editor is that of the lesson, or what has become of it. */
    boolean isSceneOpen() {
        return opening == model.openingsProperty().get();
    }

    /** What has been answered to a question; empty if nothing has. */
    String typed(Lesson lesson, int part) {
        return typed.getOrDefault(new Place(lesson.name(), part), "");
    }

    void type(Lesson lesson, int part, String answer) {
        typed.put(new Place(lesson.name(), part), answer);
    }

    /** Whether a question has been answered rightly, or a task been done, at any time. */
    boolean isDone(Lesson lesson, int part) {
        return done.contains(new Place(lesson.name(), part));
    }

    void markDone(Lesson lesson, int part) {
        done.add(new Place(lesson.name(), part));
    }

    /** How many of a lesson's questions and tasks are done. */
    int done(Lesson lesson) {
        return (int) done.stream().filter(place -> place.lesson().equals(lesson.name())).count();
    }
}
