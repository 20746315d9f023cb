package cz.paprsek.render.explain;

import cz.paprsek.math.Require;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.stream.Collectors;

/** The words of explanations in one language: English or Czech. Formulas and numbers are the same in both. */
public final class Words {
    public static final Words ENGLISH = new Words(Locale.ENGLISH);
    private static final Words CZECH = new Words(Locale.forLanguageTag("cs"));
    private static final String AXIS_FACE = " face";

    private final ResourceBundle texts;

    private Words(Locale locale) {
        texts = ResourceBundle.getBundle("cz.paprsek.render.explain.words", locale,
                ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES));
    }

    /** The words in a language; in English if there are none in it. */
    public static Words in(Locale locale) {
        return locale.getLanguage().equals("cs") ? CZECH : ENGLISH;
    }

    /**
     * A text of {@code words.properties}, with {0}, {1} … replaced.
     *
     * @throws IllegalArgumentException if there is none of that key
     */
    public String of(String key, Object... arguments) {
        Require.that(texts.containsKey(key), "explanations have no words for " + key);
        String text = texts.getString(key);
        for (int i = 0; i < arguments.length; i++) {
            text = text.replace("{" + i + "}", String.valueOf(arguments[i]));
        }
        return text;
    }

    String surface(SurfacePath path) {
        return path.labels().stream().map(this::label).collect(Collectors.joining(" › "));
    }

    /** The name of a medium: the label of an object. */
    String medium(Medium medium) {
        return label(medium.name());
    }

    /** What comes after the surface: its face if it has several. */
    String face(String face) {
        if (face.equals("surface")) {
            return "";
        }
        return ", " + (face.endsWith(AXIS_FACE) ? of("face.axis", face.substring(0, face.length() - AXIS_FACE.length())) : of("face." + face));
    }

    /** A kind and a name, such as {@code sphere "ball"}: only the kind has words of its own. */
    private String label(String label) {
        List<String> words = List.of(label.split(" ", 2));
        return words.size() < 2 ? label : of("kind." + words.get(0)) + " " + words.get(1);
    }
}
