package cz.paprsek.fx.view.texts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import cz.paprsek.attribute.ElementTable;
import cz.paprsek.fx.model.Label;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Shape;
import cz.paprsek.words.Words;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Properties;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

class TextsTest {
    /** Texts whose keys are put together: any of these beginnings counts as used. */
    private static final List<String> MADE = List.of(
            "handles.", "free.", "kind.", "edit.", "format.", "field.", "alternative.", "template.", "theme.", "ready.", "mode.", "font.", "lesson.", "explain.save.", "hand.", "glossary.", "edit-menu.undo-", "edit-menu.redo-", "ease.", "library.word.", "javafx.");
    static final List<String> PARTS = Texts.PARTS;
    /** Texts that are the same in every language. */
    private static final List<String> INTERNATIONAL = List.of("glossary.vectors", "glossary.theta", "glossary.whitted", "hand.escape", "glossary.f", "explain.save.txt", "explain.save.json", "render.actual", "unit.degrees", "unit.pixels", "timeline.seconds-unit");

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
        String sources = sources();
        for (String part : PARTS) {
            for (String key : load(part + ".properties").stringPropertyNames()) {
                assertThat(sources.contains("\"" + key + "\"") || MADE.stream().anyMatch(key::startsWith)).as("%s is used", key).isTrue();
            }
        }
    }

    @Test
    void noTextStandsInTwoParts() throws IOException {
        Properties seen = new Properties();
        for (String part : PARTS) {
            for (String key : load(part + ".properties").stringPropertyNames()) {
                assertThat(Words.ENGLISH.has(key)).as("%s is among the words already", key).isFalse();
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
        Properties properties = new Properties();
        try (Reader reader = new InputStreamReader(
                Objects.requireNonNull(Texts.class.getResourceAsStream(file), file), StandardCharsets.UTF_8)) {
            properties.load(reader);
        }
        return properties;
    }

    private static List<String> placeholders(String text) {
        return Stream.iterate(0, i -> i + 1).limit(10).map(i -> "{" + i + "}").filter(text::contains).toList();
    }

    private static String sources() throws IOException {
        StringBuilder all = new StringBuilder();
        try (Stream<Path> files = Files.walk(Path.of("src/main/java"))) {
            for (Path file : files.filter(f -> f.toString().endsWith(".java")).toList()) {
                all.append(Files.readString(file));
            }
        }
        return all.toString();
    }
}
