package cz.paprsek.sheet;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.render.RenderScene;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.font.Fonts;
import cz.paprsek.words.Words;
import cz.paprsek.xml.SceneFiles;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalLong;
import java.util.Properties;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.InflaterOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Worksheets as PDF. Readers that are no part of this project were tried by hand: MuPDF finds nothing to repair, and the same text. */
class SheetPdfTest {
    private static final String SCENE = """
            <scene name="Koule v žluťoučkém světle" xmlns="urn:paprsek:scene:1"><render width="48" height="32" max-depth="3"/><background color="20 40 90"/><ambient color="60 60 60"/>
            <camera position="0 1 6" target="0 1 0"/><point-light position="3 5 4" intensity="0.8"/><plane><material color="200 200 200"/></plane>
            <sphere radius="1" position="0 1 0"><material color="220 60 40" specular="0.5" shininess="20" transparency="0.7" refractive-index="1.5" reflection="0.2"/></sphere></scene>
            """;

    private static Worksheet sheet(Locale language) throws Exception {
        Scene scene = SceneFiles.read(new ByteArrayInputStream(SCENE.getBytes(StandardCharsets.UTF_8)), "scene");
        return new Worksheet(scene, RenderScene.of(scene), scene.settings(), List.of(new int[] {24, 12}, new int[] {5, 30}), OptionalLong.empty(), Words.in(language));
    }

    /** Whether the table of objects says where each begins; what is packed is unpacked. */
    private static Map<Integer, String> objects(byte[] file) throws Exception {
        String text = new String(file, StandardCharsets.ISO_8859_1);
        assertThat(text).startsWith("%PDF-1.7\n").endsWith("%%EOF\n");
        int table = Integer.parseInt(text.substring(text.lastIndexOf("startxref\n") + 10, text.lastIndexOf("\n%%EOF")));
        assertThat(text.substring(table)).startsWith("xref\n0 ");
        Map<Integer, String> objects = new HashMap<>();
        Matcher entries = Pattern.compile("(\\d{10}) 00000 n \n").matcher(text.substring(table));
        while (entries.find()) {
            int number = objects.size() + 1;
            int at = Integer.parseInt(entries.group(1));
            assertThat(text.startsWith(number + " 0 obj\n", at)).isTrue();
            String object = text.substring(at, text.indexOf("\nendobj\n", at));
            int stream = object.indexOf("\nstream\n");
            if (stream > 0) {
                Matcher length = Pattern.compile("/Length (\\d+)").matcher(object);
                assertThat(length.find()).isTrue();
                int end = at + stream + 8 + Integer.parseInt(length.group(1));
                assertThat(text.startsWith("\nendstream", end)).isTrue();
                ByteArrayOutputStream plain = new ByteArrayOutputStream();
                try (InflaterOutputStream out = new InflaterOutputStream(plain)) {
                    out.write(file, at + stream + 8, end - at - stream - 8);
                }
                object = plain.toString(StandardCharsets.ISO_8859_1);
            }
            objects.put(number, object);
        }
        return objects;
    }

    private static Map<String, String> characters(String table) {
        Map<String, String> characters = new HashMap<>();
        Matcher lines = Pattern.compile("<(\\p{XDigit}{4})> <(\\p{XDigit}{4})>\n").matcher(table);
        while (lines.find()) {
            characters.put(lines.group(1), Character.toString(Integer.parseInt(lines.group(2), 16)));
        }
        return characters;
    }

    /** The words of all pages as one, by the tables that readers go by. */
    private static String text(byte[] file) throws Exception {
        Map<Integer, String> objects = objects(file);
        List<Map<String, String>> fonts = objects.values().stream().filter(object -> object.contains("begincmap")).map(SheetPdfTest::characters).toList();
        assertThat(fonts).hasSize(2);
        Map<String, String> plain = characters(Objects.requireNonNull(objects.get(8)));
        Map<String, String> bold = characters(Objects.requireNonNull(objects.get(13)));
        StringBuilder all = new StringBuilder();
        Pattern shown = Pattern.compile("/F(\\d) .*?<(\\p{XDigit}*)> Tj");
        for (int i = 1; i <= objects.size(); i++) {
            Matcher words = shown.matcher(Objects.requireNonNull(objects.get(i)));
            while (words.find()) {
                for (int at = 0; at < words.group(2).length(); at += 4) {
                    all.append(Objects.requireNonNull((words.group(1).equals("1") ? plain : bold).get(words.group(2).substring(at, at + 4))));
                }
            }
        }
        return all.toString().replace(" ", "");
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "cs"})
    void allThatThePageSaysIsInThePdf(String language) throws Exception {
        Worksheet sheet = sheet(Locale.forLanguageTag(language));
        String text = text(sheet.pdf());
        Matcher pieces = Pattern.compile("<(h1|h2|h3|p|td|span)[^>]*>([^<]+)").matcher(sheet.html().replaceAll("(?s)<svg.*?</svg>|<head>.*?</head>", ""));
        int found = 0;
        while (pieces.find()) {
            assertThat(text).contains(pieces.group(2).replace("&gt;", ">").replace("&lt;", "<").replace("&amp;", "&").replace(" ", ""));
            found++;
        }
        assertThat(found).isGreaterThan(60);
        assertThat(text).contains("žluťoučkém", "θ₂", "kS·max(0,R·L)ⁿ");
    }

    @Test
    void itIsTheSameWheneverItIsMade() throws Exception {
        assertThat(sheet(Locale.ENGLISH).pdf()).isEqualTo(sheet(Locale.ENGLISH).pdf()).hasSizeLessThan(150_000);
    }

    /** What words of explanations are written with, in either language and either kind of letters. */
    @ParameterizedTest
    @ValueSource(strings = {"words", "words_cs"})
    void theFontsHaveEveryLetterOfTheWords(String file) throws Exception {
        Properties words = new Properties();
        try (Reader reader = new InputStreamReader(Objects.requireNonNull(Words.class.getResourceAsStream(file + ".properties")), StandardCharsets.UTF_8)) {
            words.load(reader);
        }
        for (String font : List.of("sans", "sans-bold")) {
            words.forEach((key, word) -> word.toString().codePoints().forEach(c -> assertThat(Fonts.shipped(font).orElseThrow().glyph(c)).as("%s: %s", key, Character.toString(c)).isPositive()));
        }
    }
}
