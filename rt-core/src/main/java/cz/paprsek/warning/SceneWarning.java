package cz.paprsek.warning;

import cz.paprsek.scene.ScenePath;
import java.util.Objects;
import java.util.Optional;

/**
 * Something in a scene that is allowed but hardly meant, or only worth knowing.
 *
 * @param kind what kind of thing it is, for programs: one word, or some joined by dashes
 * @param object what it is about, as it is called in the message; empty for the scene as a whole
 * @param place where that is; empty for the scene as a whole
 * @param attribute which of its attributes is at fault, by its name in files; empty if none is, or several are
 * @param message a sentence for people
 * @param isNote whether it is only worth knowing: pictures show it as it is meant
 */
public record SceneWarning(String kind, String object, Optional<ScenePath> place, String attribute, String message, boolean isNote) {
    public SceneWarning {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(object, "object");
        Objects.requireNonNull(place, "place");
        Objects.requireNonNull(attribute, "attribute");
        Objects.requireNonNull(message, "message");
    }
}
