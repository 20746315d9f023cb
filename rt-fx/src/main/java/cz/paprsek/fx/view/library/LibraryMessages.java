package cz.paprsek.fx.view.library;

import cz.paprsek.fx.view.texts.Texts;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;

/** What the library says at the bottom of its window. */
final class LibraryMessages {
    private final ReadOnlyStringWrapper text = new ReadOnlyStringWrapper("");
    private final Texts texts;

    LibraryMessages(Texts texts) {
        this.texts = texts;
    }

    ReadOnlyStringProperty textProperty() {
        return text.getReadOnlyProperty();
    }

    /** Says a sentence as it is: in the language of the window. */
    void say(String sentence) {
        text.set(sentence);
    }

    /** Says what the library has said in English of something that is wrong. */
    void wrong(String english) {
        say(texts.sentence(english));
    }

    /** Does what the user wants, or says why not; whether it was done. */
    boolean attempt(Runnable wish) {
        try {
            wish.run();
            say("");
            return true;
        } catch (IllegalArgumentException refused) {
            wrong(String.valueOf(refused.getMessage()));
            return false;
        }
    }
}
