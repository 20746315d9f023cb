package cz.paprsek.fx.view.texts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import cz.paprsek.attribute.ElementTable;
import cz.paprsek.fx.model.Label;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Shape;
import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Properties;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

class TextsTest {
    /** Beginnings of keys that are put together of one of these and what the program has a name for: a word in quotes, a type, a component or a constant. */
    private static final List<String> MADE = List.of(
            "handles.", "free.", "kind.", "edit.", "format.", "field.", "field.shares.", "alternative.", "template.", "theme.", "ready.", "mode.", "font.", "lesson.", "explain.save.", "hand.", "glossary.", "edit-menu.undo-", "edit-menu.redo-", "ease.", "library.word.", "library.word.extrude-", "library.word.lathe-", "library.word.text-", "javafx.", "color.name.",
            "element.", "face.", "line.", "mistake.", "pattern.", "reading.");
    /** Of what is said of kinds, attributes and rays, also without a window. */
    private static final String WORDS = "words";
    static final List<String> PARTS = Stream.concat(Texts.PARTS.stream(), Stream.of(WORDS)).toList();
    private static final List<Path> SOURCES = List.of(Path.of("src/main/java"), Path.of("../rt-core/src/main/java"), Path.of("../rt-cli/src/main/java"));
    private static final Pattern NAME = Pattern.compile("\"[a-zA-Z0-9.-]+\"|\\w+");
    private static final Pattern KEY = Pattern.compile("\"[a-z][a-z-]*(\\.[a-zA-Z0-9-]+)+\"");
    /** Files, and windows whose places are remembered. */
    private static final Pattern NO_KEY = Pattern.compile(".*\\.(css|png|properties)|window\\.(library|manual|mistakes|presenter)");
    /** What is said of a thing beside its name. */
    private static final Pattern ADDITION = Pattern.compile("\\.(means|does)$");
    /** Texts that are the same in every language. */
    private static final List<String> INTERNATIONAL = List.of("glossary.vectors", "glossary.theta", "glossary.whitted", "hand.escape", "glossary.f", "explain.save.txt", "explain.save.json", "render.actual", "unit.degrees", "unit.pixels", "timeline.seconds-unit",
            "element.x", "element.y", "element.z", "field.font", "field.fresnel", "field.value", "kind.gauss", "kind.mitchell", "kind.whitted", "name.fresnel", "reading.diffusion", "reading.reflection", "reading.specular", "reading.transparency");

    @ParameterizedTest
    @FieldSource("PARTS")
    void everyTextIsThereInEveryLanguageWithTheSamePlaceholders(String part) throws IOException {
        Properties english = load(part + ".properties");
        Properties czech = load(part + "_cs.properties");
        assertThat(new TreeSet<>(czech.stringPropertyNames())).isEqualTo(new TreeSet<>(english.stringPropertyNames()));
        for (String key : english.stringPropertyNames()) {
            assertThat(czech.getProperty(key)).as(key).isNotBlank();
            assertThat(placeholders(czech.getProperty(key))).as(key).isEqualTo(placeholders(english.getProperty(key)));
            assertThat(czech.getProperty(key).equals(english.getProperty(key))).as("%s is not translated", key).isEqualTo(INTERNATIONAL.contains(key));
        }
    }

    @Test
    void noTextIsUnused() throws IOException {
        Set<String> named = new HashSet<>();
        for (Path sources : SOURCES) {
            named.addAll(named(sources, NAME));
        }
        Set<String> things = named.stream().map(TextsTest::plain).collect(Collectors.toSet());
        for (String part : PARTS) {
            for (String key : load(part + ".properties").stringPropertyNames()) {
                boolean isMade = MADE.stream().filter(key::startsWith).anyMatch(made -> things.contains(plain(key.substring(made.length()))));
                assertThat(named.contains('"' + key + '"') || named.contains('"' + ADDITION.matcher(key).replaceFirst("") + '"') || isMade).as("%s is used", key).isTrue();
            }
        }
    }

    /** What is asked for by a key in quotes is there: a slip would be found only by who comes to that place in the window. */
    @Test
    void noTextIsMissing() throws IOException {
        Set<String> beginnings = new HashSet<>();
        for (String part : PARTS) {
            load(part + ".properties").stringPropertyNames().forEach(key -> beginnings.add(beginning(key)));
        }
        Texts texts = Texts.in(Locale.ENGLISH);
        assertThat(named(SOURCES.get(0), KEY)).extracting(quoted -> quoted.substring(1, quoted.length() - 1))
                .filteredOn(key -> beginnings.contains(beginning(key)) && !NO_KEY.matcher(key).matches()).filteredOn(key -> !texts.has(key)).isEmpty();
    }

    private static String beginning(String key) {
        return key.substring(0, key.indexOf('.') + 1);
    }

    /** A name whichever way it is written: {@code SHADOW_FREE}, {@code shadow-free}, {@code shadowFree}. */
    private static String plain(String name) {
        return name.toLowerCase(Locale.ROOT).replaceAll("[-_\"]", "");
    }

    @Test
    void noTextStandsInTwoParts() throws IOException {
        Properties seen = new Properties();
        for (String part : PARTS) {
            for (String key : load(part + ".properties").stringPropertyNames()) {
                assertThat(seen.put(key, part)).as(key).isNull();
            }
        }
    }

    @ParameterizedTest
    @FieldSource("cz.paprsek.fx.view.texts.Texts#LANGUAGES")
    void everyKindAndEditHasAName(Locale language) {
        Texts texts = Texts.in(language);
        assertThat(texts.locale()).isEqualTo(language);
        ElementTable.of(Shape.class).filter(kind -> kind != Csg.class)
                .forEach(kind -> assertThat(texts.of("kind." + ElementTable.name(kind))).isNotBlank());
        for (Csg.Operation operation : Csg.Operation.values()) {
            assertThat(texts.of("kind." + operation.name().toLowerCase(Locale.ROOT))).isNotBlank();
        }
        for (Label.Edit edit : Label.Edit.values()) {
            assertThat(texts.edit(Label.of(edit, "ball"))).contains("ball");
            assertThat(texts.edit(Label.of(edit))).doesNotContain("{").doesNotEndWith(" ");
        }
    }

    @Test
    void whatARecordRefusesIsSaidInTheLanguageOfTheWindow() {
        String refused = String.valueOf(catchThrowable(() -> new Block(Vec3.ZERO, Vec3.ONE, 2)).getMessage());
        assertThat(Texts.in(Locale.ENGLISH).sentence(refused)).isEqualTo(refused);
        assertThat(Texts.in(Locale.forLanguageTag("cs")).sentence(refused)).startsWith("kvádr, zaoblení: má být nejvýše").doesNotContain("must");
    }

    @Test
    void otherLanguagesGetEnglish() {
        assertThat(Texts.in(Locale.JAPANESE).locale()).isEqualTo(Locale.ENGLISH);
        assertThat(Texts.in(Locale.forLanguageTag("cs-CZ")).of("kind.sphere")).isEqualTo("koule");
    }

    private static Properties load(String file) throws IOException {
        Path folder = file.startsWith(WORDS) ? Path.of("../rt-core/src/main/resources/cz/paprsek/words") : Path.of("src/main/resources/cz/paprsek/fx/view/texts");
        Properties properties = new Properties();
        try (Reader reader = Files.newBufferedReader(folder.resolve(file))) {
            properties.load(reader);
        }
        return properties;
    }

    private static List<String> placeholders(String text) {
        return Stream.iterate(0, i -> i + 1).limit(10).map(i -> "{" + i + "}").filter(text::contains).toList();
    }

    /** What is found in the sources below a folder. */
    private static Set<String> named(Path folder, Pattern what) throws IOException {
        Set<String> all = new HashSet<>();
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(f -> f.toString().endsWith(".java")).toList()) {
                what.matcher(Files.readString(file)).results().forEach(found -> all.add(found.group()));
            }
        }
        return all;
    }
}
