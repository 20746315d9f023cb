package cz.paprsek.lesson;

import java.util.Locale;
import java.util.Objects;

/** A text in both languages. */
public record Said(String english, String czech) {
    public Said {
        Objects.requireNonNull(english, "english");
        Objects.requireNonNull(czech, "czech");
    }

    /** What is the same in all languages. */
    static Said inAll(String text) {
        return new Said(text, text);
    }

    /** The text in a language; in English if it is not Czech. */
    public String in(Locale locale) {
        return locale.getLanguage().equals("cs") ? czech : english;
    }
}
