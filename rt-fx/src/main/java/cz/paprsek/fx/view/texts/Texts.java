package cz.paprsek.fx.view.texts;

import cz.paprsek.fx.model.Label;
import cz.paprsek.scene.Light;
import cz.paprsek.shape.CustomShape;
import cz.paprsek.shape.Shape;
import cz.paprsek.words.Words;
import java.text.DecimalFormatSymbols;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.MissingResourceException;
import java.util.ResourceBundle;

/**
 * All words that a user reads, in one language: what kinds and attributes are called is said in {@link Words}, everything else in one properties
 * file per part of the window and language.
 */
public final class Texts {
    /** The files, in the folder {@code texts}. */
    static final List<String> PARTS = List.of("common", "window", "sheet", "picture", "explain", "lesson", "library", "find", "motion", "xml");
    /** The languages, the first being that of the files without a language in their name. */
    public static final List<Locale> LANGUAGES = List.of(Locale.ENGLISH, Locale.forLanguageTag("cs"));

    private final Locale locale;
    private final Words words;
    private final Map<String, String> texts = new HashMap<>();

    private Texts(Locale locale) {
        this.locale = locale;
        words = Words.in(locale);
        for (String part : PARTS) {
            ResourceBundle bundle = ResourceBundle.getBundle(
                    "cz.paprsek.fx.view.texts." + part, locale, ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES));
            bundle.keySet().forEach(key -> texts.put(key, bundle.getString(key)));
        }
    }

    /** The texts in a language; in English if there are none in it. */
    public static Texts in(Locale locale) {
        return new Texts(LANGUAGES.stream().filter(language -> language.getLanguage().equals(locale.getLanguage())).findFirst().orElse(Locale.ENGLISH));
    }

    /** The language, also for the form of numbers. */
    public Locale locale() {
        return locale;
    }

    /** Whether there is a text of that key. */
    public boolean has(String key) {
        return texts.containsKey(key) || words.has(key);
    }

    /**
     * A text, with {0}, {1} … replaced.
     *
     * @throws MissingResourceException if there is none
     */
    public String of(String key, Object... arguments) {
        String text = texts.get(key);
        if (text == null && words.has(key)) {
            return words.of(key, arguments);
        } else if (text == null) {
            throw new MissingResourceException("there is no text for " + key, Texts.class.getName(), key);
        }
        for (int i = 0; i < arguments.length; i++) {
            text = text.replace("{" + i + "}", String.valueOf(arguments[i]));
        }
        return text;
    }

    /** What is called by the same words wherever it is spoken of. */
    public Words words() {
        return words;
    }

    /** What the model or the library says in English of something that is wrong. */
    public String sentence(String english) {
        return words.sentence(english);
    }

    /** A number as it is written in files, with the decimal sign of the language. */
    public String number(String written) {
        return written.replace('.', DecimalFormatSymbols.getInstance(locale).getDecimalSeparator());
    }

    /** What a kind of shape is called: "sphere". */
    public String kind(Shape shape) {
        return shape instanceof CustomShape ? shape.kind() : of("kind." + shape.kind());
    }

    /** What a kind of light is called: "sun". */
    public String kind(Light light) {
        String key = "kind." + light.kind();
        return words.has(key) ? of(key) : of("kind.light");
    }

    /** What an attribute is called, by its name in files: "Position". */
    public String attribute(String name) {
        StringBuilder key = new StringBuilder("field.");
        for (String part : (name.equals("target") ? "point" : name).split("-", -1)) {
            key.append(key.length() == 6 ? part : part.substring(0, 1).toUpperCase(Locale.ROOT) + part.substring(1));
        }
        return words.has(key.toString()) ? of(key.toString()) : name;
    }

    /** What an edit is called: "Move sphere". */
    public String edit(Label label) {
        return of("edit." + label.edit().name().toLowerCase(Locale.ROOT), label.subject()).strip();
    }
}
