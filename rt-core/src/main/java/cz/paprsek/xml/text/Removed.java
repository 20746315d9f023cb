package cz.paprsek.xml.text;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** What is taken out of a text. If it comes in again elsewhere, it was moved, and keeps its text. */
final class Removed {
    private final List<Piece> pieces = new ArrayList<>();
    private final Map<Form.Body, Deque<Piece>> byBody = new HashMap<>();
    private final Map<Form.Body, Deque<Piece>> byAllButName = new HashMap<>();
    private final Map<String, Deque<Piece>> byName = new HashMap<>();

    /** An element that is taken out, and what it was. */
    static final class Piece {
        private final Element element;
        private final Form form;
        private boolean isMoved;

        private Piece(Element element, Form form) {
            this.element = element;
            this.form = form;
        }

        Element element() {
            return element;
        }

        Form form() {
            return form;
        }

        boolean isMoved() {
            return isMoved;
        }
    }

    /** @param scene where the scene begins that it is in */
    void add(Element element, Form form, int scene) {
        Piece piece = new Piece(element, form);
        pieces.add(piece);
        byBody.computeIfAbsent(form.body(), body -> new ArrayDeque<>()).add(piece);
        byAllButName.computeIfAbsent(form.body().nameless(), body -> new ArrayDeque<>()).add(piece);
        byName.computeIfAbsent(key(form, scene), key -> new ArrayDeque<>()).add(piece);
    }

    List<Piece> pieces() {
        return pieces;
    }

    /**
     * The piece that this is, or was before it was changed in the same scene, or got another name; it is moved then, and will not be found again.
     *
     * @param scene where that begins
     */
    Optional<Piece> moved(Form form, int scene) {
        if (pieces.isEmpty()) {
            return Optional.empty();
        }
        Optional<Piece> found = take(byBody.get(form.body()));
        if (found.isEmpty() && !form.body().attribute("name").isEmpty()) {
            found = take(byName.get(key(form, scene)));
        }
        if (found.isEmpty()) {
            found = take(byAllButName.get(form.body().nameless()));
        }
        found.ifPresent(piece -> piece.isMoved = true);
        return found;
    }

    private static Optional<Piece> take(@Nullable Deque<Piece> candidates) {
        while (candidates != null && !candidates.isEmpty()) {
            Piece piece = candidates.poll();
            if (!piece.isMoved) {
                return Optional.of(piece);
            }
        }
        return Optional.empty();
    }

    private static String key(Form form, int scene) {
        return scene + " " + form.body().name() + " " + form.body().attribute("name");
    }
}
