package cz.paprsek.fx.model;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** What was, and what was undone, without limit. Scenes share what they have in common, so a step costs little. */
final class History {
    private record Step(Label label, EditorState state) {}

    private final Deque<Step> past = new ArrayDeque<>();
    private final Deque<Step> future = new ArrayDeque<>();

    /** Takes note of an edit; what was undone before is gone. */
    void did(Label label, EditorState before) {
        past.push(new Step(label, before));
        future.clear();
    }

    /** The state before the last edit; empty if there is none. */
    Optional<EditorState> undo(EditorState now) {
        return swap(past, future, now);
    }

    /** The state after the edit that was undone last; empty if there is none. */
    Optional<EditorState> redo(EditorState now) {
        return swap(future, past, now);
    }

    Optional<Label> undoable() {
        return Optional.ofNullable(past.peek()).map(Step::label);
    }

    Optional<Label> redoable() {
        return Optional.ofNullable(future.peek()).map(Step::label);
    }

    void clear() {
        past.clear();
        future.clear();
    }

    private static Optional<EditorState> swap(Deque<Step> from, Deque<Step> to, EditorState now) {
        if (from.isEmpty()) {
            return Optional.empty();
        }
        Step step = from.pop();
        to.push(new Step(step.label(), now));
        return Optional.of(step.state());
    }
}
