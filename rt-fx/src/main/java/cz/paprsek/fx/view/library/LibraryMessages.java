package cz.paprsek.fx.view.library;

import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;

/** What the library says at the bottom of its window. */
final class LibraryMessages {
    private final ReadOnlyStringWrapper text = new ReadOnlyStringWrapper("");

    ReadOnlyStringProperty textProperty() {
        return text.getReadOnlyProperty();
    }

    void say(String sentence) {
        text.set(sentence);
    }

    /** Does what the user wants, or says why not; whether it was done. */
    boolean attempt(Runnable wish) {
        try {
            wish.run();
            say("");
            return true;
        } catch (IllegalArgumentException refused) {
            say(String.valueOf(refused.getMessage()));
            return false;
        }
    }
}
