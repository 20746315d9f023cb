package cz.paprsek.fx.model;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/**
 * What was done, and what was undone, step by step and without limit: of a scene or of a database. States share what they have in common, so
 * a step costs little. For JavaFX's thread only.
 *
 * @param <S> the state that steps lead from and to
 */
public final class History<S> {
    private final Change<S> change;
    private final Deque<Step<S>> past = new ArrayDeque<>();
    private final Deque<Step<S>> future = new ArrayDeque<>();
    private final ReadOnlyObjectWrapper<Optional<Label>> undoable = new ReadOnlyObjectWrapper<>(Optional.empty());
    private final ReadOnlyObjectWrapper<Optional<Label>> redoable = new ReadOnlyObjectWrapper<>(Optional.empty());

    private record Step<S>(Label label, S before, S after) {}

    /** Makes the change that leads from one state to another to the state there is now, which others may have changed meanwhile. */
    @FunctionalInterface
    public interface Change<S> {
        /** @throws IllegalArgumentException with what is in the way */
        S apply(S now, S from, S to);
    }

    public History(Change<S> change) {
        this.change = change;
    }

    /** Takes note of an edit; what was undone before is gone. */
    public void did(Label label, S before, S after) {
        past.push(new Step<>(label, before, after));
        future.clear();
    }

    /**
     * The state without the last edit; empty if there is none.
     *
     * @throws IllegalArgumentException with what is in the way; the edit can be undone later then
     */
    public Optional<S> undo(S now) {
        Optional<S> next = Optional.ofNullable(past.peek()).map(step -> change.apply(now, step.after(), step.before()));
        next.ifPresent(state -> future.push(past.pop()));
        return next;
    }

    /** As {@link #undo}: the state with the edit that was undone last. */
    public Optional<S> redo(S now) {
        Optional<S> next = Optional.ofNullable(future.peek()).map(step -> change.apply(now, step.before(), step.after()));
        next.ifPresent(state -> past.push(future.pop()));
        return next;
    }

    public void clear() {
        past.clear();
        future.clear();
    }

    /** What undo would undo, as of {@link #tell}. */
    public ReadOnlyObjectProperty<Optional<Label>> undoableProperty() {
        return undoable.getReadOnlyProperty();
    }

    /** What redo would redo, as of {@link #tell}. */
    public ReadOnlyObjectProperty<Optional<Label>> redoableProperty() {
        return redoable.getReadOnlyProperty();
    }

    /** Sets the properties: when the state is there that they belong to. */
    public void tell() {
        undoable.set(Optional.ofNullable(past.peek()).map(Step::label));
        redoable.set(Optional.ofNullable(future.peek()).map(Step::label));
    }
}
