package cz.paprsek.words;

import cz.paprsek.math.Require;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.CustomShape;
import cz.paprsek.shape.Shape;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.stream.Collectors;

/** The words for kinds, faces and attributes, and those of explanations, in one language: English or Czech. Formulas and numbers are the same in both. */
public final class Words {
    public static final Words ENGLISH = new Words(Locale.ENGLISH);
    private static final Words CZECH = new Words(Locale.forLanguageTag("cs"));

    private final ResourceBundle texts;

    private Words(Locale locale) {
        texts = ResourceBundle.getBundle("cz.paprsek.words.words", locale,
                ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES));
    }

    /** The words in a language; in English if there are none in it. */
    public static Words in(Locale locale) {
        return locale.getLanguage().equals("cs") ? CZECH : ENGLISH;
    }

    /** Whether there is a text of that key. */
    public boolean has(String key) {
        return texts.containsKey(key);
    }

    /**
     * A text of {@code words.properties}, with {0}, {1} … replaced.
     *
     * @throws IllegalArgumentException if there is none of that key
     */
    public String of(String key, Object... arguments) {
        Require.that(texts.containsKey(key), "there are no words for " + key);
        String text = texts.getString(key);
        for (int i = 0; i < arguments.length; i++) {
            text = text.replace("{" + i + "}", String.valueOf(arguments[i]));
        }
        return text;
    }

    /** What a body is called, from the outermost operation inwards, such as {@code difference "bowl" › sphere "hollow"}. */
    public String surface(InScene<? extends ScenePath> surface) {
        Scene scene = surface.scene();
        if (surface.part() instanceof ScenePath.LightAt at) {
            String name = scene.lights().get(at.index()).name();
            return of("light", name.isEmpty() ? "#" + (at.index() + 1) : "\"" + name + "\"");
        }
        return ((BodyAt) surface.part()).way().map(step -> kind(step.in(scene).shape()) + " " + step.nameOrNumber(scene))
                .collect(Collectors.joining(" › "));
    }

    /** A shape that was made in code is called as its code says. */
    private String kind(Shape shape) {
        return shape instanceof CustomShape ? shape.kind() : of("kind." + shape.kind());
    }

    /** What comes after the surface: its face if it has several. */
    public String face(Shape.Face face) {
        return switch (face) {
            case ONLY -> "";
            case SIDE, BOTTOM, TOP -> ", " + of("face." + face.text());
            default -> ", " + of("face.axis", face.axis());
        };
    }
}
