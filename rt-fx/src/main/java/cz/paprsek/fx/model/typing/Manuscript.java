package cz.paprsek.fx.model.typing;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Label;
import cz.paprsek.io.Failures;
import cz.paprsek.math.Require;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.Problem;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneText;
import cz.paprsek.xml.SceneText.Stand;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyIntegerProperty;
import javafx.beans.property.ReadOnlyIntegerWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleBooleanProperty;

/**
 * The text of the scene, in which may be written: it follows the scene, and what is written becomes a step of the scene's history as soon as it is valid. Until
 * then it is held here, whatever becomes of the scene. For JavaFX's thread only.
 */
public final class Manuscript {
    /** Longer texts are not written by hand, and would be slow, characters. */
    private static final int LONGEST = 4_000_000;
    /** Of more objects it is not even asked. */
    private static final int MOST_OBJECTS = 100_000;

    private final EditorModel model;
    private final Supplier<Optional<OriginalText>> kept;
    private final Worker worker;
    private final BooleanProperty open = new SimpleBooleanProperty();
    private final ReadOnlyObjectWrapper<Page> page = new ReadOnlyObjectWrapper<>(Page.NONE);
    private final ReadOnlyBooleanWrapper held = new ReadOnlyBooleanWrapper();
    private final ReadOnlyBooleanWrapper writable = new ReadOnlyBooleanWrapper();
    private final ReadOnlyIntegerWrapper points = new ReadOnlyIntegerWrapper();
    /** The text of the scene; empty while nobody looks at it. */
    private Optional<SceneText> base = Optional.empty();
    private boolean isBusy;
    private boolean isStale;
    /** Whether it is to be looked at as soon as the scene's text is known and nothing is being dragged. */
    private boolean isWaiting;
    /** The scene and its text that are followed. */
    private EditorState followed;
    /** Whether another scene is being opened, which the model does not have yet. */
    private boolean isOpened;
    /** Counts what makes texts that are still being found out those of another scene. */
    private int turn;

    /** Does what takes long elsewhere, and tells on JavaFX's thread what has come of it, later. */
    public interface Worker {
        <T> void run(Callable<T> work, Consumer<T> done, Consumer<Throwable> failed);
    }

    private record Read(SceneText text, List<Stand> stands) {}

    /** @param kept the text that the scene has where it is kept */
    public Manuscript(EditorModel model, Supplier<Optional<OriginalText>> kept, Worker worker) {
        this.model = model;
        this.kept = kept;
        this.worker = worker;
        followed = model.state();
        // Also of an equal scene that is opened: that is no change, but another text.
        model.stateProperty().addListener(property -> {
            EditorState now = model.state();
            boolean isOther = isOpened || !followed.scene().equals(now.scene()) || !followed.typed().equals(now.typed());
            followed = now;
            isOpened = false;
            if (isOther) {
                follow();
            }
        });
        model.openingsProperty().addListener((property, old, now) -> {
            turn++;
            isOpened = true;
            setBase(Optional.empty());
            page.set(Page.NONE);
        });
        model.gesturingProperty().addListener((property, old, now) -> checkAgain());
        page.addListener((property, old, now) -> held.set(now.isHeld()));
        open.addListener((property, old, now) -> follow());
    }

    /** Whether anybody looks at it. */
    public BooleanProperty openProperty() {
        return open;
    }

    public ReadOnlyObjectProperty<Page> pageProperty() {
        return page.getReadOnlyProperty();
    }

    public Page page() {
        return page.get();
    }

    /** Whether it can be written in: not before the text of the scene is known. */
    public ReadOnlyBooleanProperty writableProperty() {
        return writable.getReadOnlyProperty();
    }

    private void setBase(Optional<SceneText> text) {
        base = text;
        writable.set(text.isPresent());
    }

    /** Shows where it is not valid. */
    public void point() {
        open.set(true);
        points.set(points.get() + 1);
    }

    /** How often it was asked where it is not valid. */
    public ReadOnlyIntegerProperty pointsProperty() {
        return points.getReadOnlyProperty();
    }

    /** Whether anything in it is not in the scene. */
    public ReadOnlyBooleanProperty heldProperty() {
        return held.getReadOnlyProperty();
    }

    /** Takes a text that was written before, and is not in the scene. */
    public void restore(String text) {
        SceneText now = SceneText.of(kept.get(), model.scene());
        setBase(Optional.of(now));
        page.set(new Page(text, Change.between(now.characters(), text), List.of(), false, now.stands()));
        open.set(true);
        check();
    }

    /** Takes what has become of the text by typing. */
    public void write(String text) {
        base.ifPresent(now -> {
            Change written = Change.between(now.characters(), text);
            Page old = page();
            page.set(new Page(text, written, written.isNone() ? List.of() : old.problems(), old.isCrossed() && !written.isNone(), old.stands()));
        });
    }

    /** Gives up what is not in the scene. */
    public void giveUp() {
        base.ifPresent(now -> write(now.characters()));
    }

    /**
     * Puts what is written into the scene if it is valid, else finds out what is wrong with it; when somebody has stopped typing. Waits for what is being dragged,
     * and until the text has what has become of the scene elsewhere.
     */
    public void check() {
        isWaiting = page().isHeld() && !isCurrent();
        if (page().isHeld() && !isWaiting) {
            SceneText from = base.orElseThrow();
            String text = page().text();
            worker.run(() -> from.typed(text, model.assets()), typed -> {
                if (isCurrent() && base.filter(from::equals).isPresent() && page().text().equals(text)) {
                    take(typed);
                } else {
                    check();
                }
            }, fault -> {
                if (page().text().equals(text)) {
                    refused(fault);
                }
            });
        }
    }

    private void checkAgain() {
        if (isWaiting && isCurrent()) {
            check();
        }
    }

    /** Whether the text is that of the scene as it is and stays until the next step. */
    private boolean isCurrent() {
        return !isBusy && !model.gesturingProperty().get() && base.filter(text -> text.scene().equals(model.scene())).isPresent();
    }

    /** As {@link #check}, at once, with what has become of the scene elsewhere; false if it is not valid. */
    public boolean flush() {
        if (page().isHeld() && base.isPresent()) {
            try {
                if (!isCurrent()) {
                    turn++;
                    followed(read(kept.get(), model.scene()));
                }
                take(base.get().typed(page().text(), model.assets()));
            } catch (SceneFileException | IOException | IllegalArgumentException fault) {
                refused(fault);
            }
        }
        return !page().isHeld();
    }

    private void take(SceneText typed) {
        Optional<SceneText> before = base;
        Page old = page();
        try {
            setBase(Optional.of(typed));
            page.set(new Page(typed.characters(), Change.between("", ""), List.of(), false, old.stands()));
            model.editState(Label.of(Label.Edit.WRITE, "XML"), state -> Followed.to(state, typed.scene()).withTyped(Optional.of(typed.kept())));
        } catch (IllegalArgumentException fault) {
            setBase(before);
            page.set(old);
            refused(fault);
        }
    }

    private void refused(Throwable fault) {
        List<Problem> problems = fault instanceof SceneFileException wrong ? wrong.problems()
                : List.of(new Problem("text", 1, 1, fault instanceof IOException unreadable ? Failures.sentence(unreadable) : String.valueOf(fault.getMessage())));
        Page old = page();
        page.set(new Page(old.text(), old.written(), problems, old.isCrossed(), old.stands()));
    }

    private void follow() {
        if (!open.get() && !page().isHeld()) {
            setBase(Optional.empty());
        } else if (isBusy) {
            isStale = true;
        } else {
            isBusy = true;
            Scene scene = model.scene();
            Optional<OriginalText> from = kept.get();
            int now = turn;
            worker.run(() -> read(from, scene), read -> {
                isBusy = false;
                if (now == turn) {
                    followed(read);
                }
                again();
            }, fault -> {
                isBusy = false;
                if (now == turn && !page().isHeld()) {
                    setBase(Optional.empty());
                    page.set(Page.NONE);
                }
                if (now == turn) {
                    refused(fault);
                }
                again();
            });
        }
    }

    private static Read read(Optional<OriginalText> kept, Scene scene) {
        Require.that(scene.objects().size() <= MOST_OBJECTS, "the text of a scene of more than " + MOST_OBJECTS + " objects is too long to be shown here");
        SceneText text = SceneText.of(kept, scene);
        Require.that(text.characters().length() <= LONGEST, "a text of more than " + LONGEST + " characters is too long to be shown here");
        return new Read(text, text.stands());
    }

    private void again() {
        if (isStale) {
            isStale = false;
            follow();
        }
        checkAgain();
    }

    private void followed(Read read) {
        String now = read.text().characters();
        Page old = page();
        Optional<Change> elsewhere = base.map(before -> Change.between(before.characters(), now));
        setBase(Optional.of(read.text()));
        Optional<Change> still = !old.isHeld() ? Optional.empty() : elsewhere.flatMap(other -> other.isNone() ? Optional.of(old.written()) : old.written().behind(other));
        if (!old.isHeld()) {
            page.set(new Page(now, Change.between("", ""), List.of(), false, read.stands()));
        } else if (still.isPresent()) {
            page.set(new Page(still.get().applied(now), still.get(), old.problems(), old.isCrossed(), read.stands()));
        } else {
            page.set(new Page(old.text(), Change.between(now, old.text()), old.problems(), true, read.stands()));
        }
    }

    /** The names that what is written there may have. */
    public Scene scene() {
        return model.scene();
    }
}
