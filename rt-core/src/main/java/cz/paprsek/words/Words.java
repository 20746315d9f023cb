package cz.paprsek.words;

import cz.paprsek.math.Require;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.CustomShape;
import cz.paprsek.shape.Shape;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.ResourceBundle;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The words for kinds, faces and attributes, and those of explanations, in one language: English or Czech. Formulas and numbers are the same in both. */
public final class Words {
    public static final Words ENGLISH = new Words(Locale.ENGLISH);
    private static final Words CZECH = new Words(Locale.forLanguageTag("cs"));

    private static final Pattern UNIT = Pattern.compile(" (°|\\(.*\\))$");
    private static final Pattern QUOTED = Pattern.compile("\"[^\"]*\"");
    private static final Pattern DECIMAL_POINT = Pattern.compile("(?<=[0-9])\\.(?=[0-9])");
    private static final Pattern BETWEEN_NUMBERS = Pattern.compile("(?<=[0-9⁰¹²³⁴⁵⁶⁷⁸⁹)°∞]), (?=[−0-9(∞])");

    private final boolean hasDecimalComma;
    private final ResourceBundle texts;
    private final UnaryOperator<String> sentences;
    private final UnaryOperator<String> names;

    private Words(Locale locale) {
        hasDecimalComma = !locale.equals(Locale.ENGLISH);
        if (locale.equals(Locale.ENGLISH)) {
            sentences = UnaryOperator.identity();
            names = UnaryOperator.identity();
        } else {
            Sentences table = new Sentences("sentences_" + locale.getLanguage() + ".txt", this::word);
            sentences = table::of;
            names = table::name;
        }
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

    /** Numbers and formulas with the decimal sign of the language, and with semicolons between numbers where that is a comma; names within quotes stay as they are. */
    public String figures(String english) {
        if (!hasDecimalComma) {
            return english;
        }
        StringBuilder text = new StringBuilder();
        Matcher quoted = QUOTED.matcher(english);
        int from = 0;
        while (quoted.find()) {
            text.append(commas(english.substring(from, quoted.start()))).append(quoted.group());
            from = quoted.end();
        }
        return text.append(commas(english.substring(from))).toString();
    }

    private static String commas(String text) {
        return DECIMAL_POINT.matcher(BETWEEN_NUMBERS.matcher(text).replaceAll("; ")).replaceAll(",");
    }

    /** A sentence that the library has made in English to tell what is wrong; as it is if there are no other words for it. */
    public String sentence(String english) {
        return sentences.apply(Objects.requireNonNull(english, "english"));
    }

    /** What the library names in English, or as files have it, such as {@code area-light} or {@code a camera inside of glass}; as it is if there is no other word for it. */
    public String name(String english) {
        return names.apply(Objects.requireNonNull(english, "english"));
    }

    /** What an element or an attribute is called, by its name in files: {@code major-radius}. The unit behind it on a sheet is no part of a sentence. */
    private Optional<String> word(String name) {
        String label = "field." + Pattern.compile("-(.)").matcher(name).replaceAll(letter -> letter.group(1).toUpperCase(Locale.ROOT));
        return Stream.of("kind." + name, "element." + name, label).filter(this::has).map(this::of).findFirst()
                .map(text -> text.substring(0, 1).toLowerCase(Locale.ROOT) + UNIT.matcher(text.substring(1)).replaceFirst(""));
    }

    /** What a body is called, from the outermost operation inwards, such as {@code difference "bowl" › sphere "hollow"}; of what is repeated also which copy it is. */
    public String surface(InScene<? extends ScenePath> surface) {
        Scene scene = surface.scene();
        if (surface.part() instanceof ScenePath.LightAt at) {
            String name = scene.lights().get(at.index()).name();
            return of("light", name.isEmpty() ? "#" + (at.index() + 1) : "\"" + name + "\"");
        }
        return ((BodyAt) surface.part()).way().map(step -> kind(step.in(scene).shape()) + " " + step.nameOrNumber(scene)
                + CopyOf.of(scene, step).stream().map(copy -> ", " + copy.text(this)).collect(Collectors.joining()))
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
