package cz.paprsek.lesson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.lesson.Question.Verdict;
import cz.paprsek.render.RenderMonitor;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.XMLConstants;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.xml.sax.SAXException;

/** Lessons that others write. */
class LessonFileTest {
    private static final Path PAGE = Path.of("../docs/lessons.md");

    @TempDir
    Path folder;

    private String sample = "";

    /** The sample is that of the page on how to write one: its blocks of XML are the lesson, its scene and the solution. */
    @BeforeEach
    void writeTheSampleOfThePage() throws IOException {
        Matcher blocks = Pattern.compile("```xml\n(.*?)```", Pattern.DOTALL).matcher(Files.readString(PAGE));
        List<String> files = blocks.results().map(block -> block.group(1)).toList();
        assertThat(files).hasSize(2);
        sample = files.get(0);
        Files.writeString(folder.resolve("half.xml"), files.get(1));
        Files.writeString(folder.resolve("half-solved.xml"), files.get(1).replace("radius=\"1\"", "radius=\"2\""));
        Files.writeString(folder.resolve("lesson.xml"), sample);
    }

    private LessonException refused(String text) throws IOException {
        Path file = Files.writeString(folder.resolve("bad.xml"), text);
        try {
            Lesson lesson = Lessons.read(file);
            throw new AssertionError("was read: " + lesson);
        } catch (LessonException e) {
            assertThat(e.problems()).hasSize(1);
            assertThat(e.getMessage()).startsWith(file.toString().substring(0, file.toString().length() - "bad.xml".length())).doesNotContain("\n", "Exception");
            return e;
        }
    }

    private static Schema schema() throws SAXException {
        return SchemaFactory.newInstance(XMLConstants.W3C_XML_SCHEMA_NS_URI).newSchema(new StreamSource(new StringReader(Lessons.schema())));
    }

    @Test
    void theSampleOfThePageIsALesson() throws Exception {
        Lesson lesson = Lessons.read(folder.resolve("lesson.xml"));
        assertThat(lesson.name()).isEqualTo("lesson");
        assertThat(LessonCheck.problems(lesson, RenderMonitor.NONE)).isEmpty();
        schema().newValidator().validate(new StreamSource(new StringReader(sample)));
    }

    @Test
    void shippedLessonsKeepToTheSchema() throws Exception {
        Schema schema = schema();
        for (String name : Lessons.NAMES) {
            schema.newValidator().validate(new StreamSource(Objects.requireNonNull(Lessons.class.getResourceAsStream(name + "/lesson.xml"), name)));
        }
    }

    /** What is replaced, by what, and what is said of it; and whether the schema says so, too. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "<lesson |<lektion |<lektion> must be closed before this|true",
        "urn:paprsek:lesson:1|urn:paprsek:lesson:9|must be in the namespace of lessons|true",
        "scene=\"half.xml\"|scen=\"half.xml\"|<lesson> has no attribute \"scen\"; did you mean \"scene\"?|true",
        "scene=\"half.xml\"|scene=\"../half.xml\"|<lesson> scene: \"../half.xml\": only files in the scene's folder and below can be read, and .. leads out|false",
        "scene=\"half.xml\"|scene=\"/etc/passwd\"|this one is absolute|false",
        "scene=\"half.xml\"|scene=\"none.xml\"|\"none.xml\": |false",
        "<p>|<q>|<q> must be closed before this|true",
        "<hint>|<hynt>|`must be closed before this; add </hynt>`|true",
        "<cs>Poloviční koule</cs>||<title> needs <cs>|true",
        "<en>Half a ball</en>|<en/>|<en> is empty; it needs a text|true",
        "asks=\"distance\"|asks=\"distanc\"|<question> asks must be one of color, light, brightness, direction, distance, point, normal, angle, angle-beyond, facing, alignment, visibility, but is \"distanc\"|true",
        "pixel=\"50,50\"|pixel=\"50,500\"|<question> pixel must be a column and a row of the scene's picture, 101 x 101, such as 0,0, but is \"50,500\"|false",
        "asks=\"distance\"|asks=\"distance\" answer=\"4\"|<question> needs either the attribute answer, or asks and pixel|false",
        "asks=\"distance\"|asks=\"distance\" ray=\"ER\"|<question> has no answer: pixel 50,50 has no ray ER|false",
        "asks=\"distance\"|asks=\"angle-beyond\"|<question> has no answer: pixel 50,50 has no angle-beyond|false",
        "tolerance=\"0.01\"|tolerance=\"0\"|<question> tolerance must be a number above 0|false",
        "tolerance=\"0.01\"|tolerance=\"a bit\"|<question> tolerance must be numbers with blanks between, but has \"a\"|true",
        "tolerance=\"0.01\"|tolerance=\"1d\"|<question> tolerance must be numbers with blanks between, but has \"1d\"|true",
        "tolerance=\"0.01\"|tolerance=\"0x1p-3\"|<question> tolerance must be numbers with blanks between, but has \"0x1p-3\"|true",
        "answer=\"5\"|answer=\"4.004\"|<wrong> answer is right: it is within the tolerance of 4|false",
        "answer=\"5\"|answer=\"5 6\"|<wrong> answer has 2 numbers, but the right one 1|false",
        "condition=\"exists(pixel|condition=\"exists(pixels|<task> condition: character 8: exists wants the name of a table, but found \"pixels\"; did you mean \"pixel\"?|false",
        "`y &lt; 0.02`|`hight &lt; 0.02`|`there is no column \"hight\"`|false",
        "solution=\"half-solved.xml\"||<task> needs the attribute solution|true",
    })
    void whatIsWrongIsSaidInOneLine(String from, String to, String said, boolean isOfSchema) throws Exception {
        assertThat(sample).contains(from);
        String text = sample.replaceFirst(Pattern.quote(from), Matcher.quoteReplacement(to == null ? "" : to));
        assertThat(refused(text).getMessage()).contains(said);
        if (isOfSchema) {
            assertThatThrownBy(() -> schema().newValidator().validate(new StreamSource(new StringReader(text)))).isInstanceOf(SAXException.class);
        }
    }

    @Test
    void whatIsWrongWithAsceneIsSaidAtItsFile() throws IOException {
        Files.writeString(folder.resolve("half.xml"), Files.readString(folder.resolve("half.xml")).replace("radius", "raduis"));
        assertThat(refused(sample).getMessage()).contains("half.xml:").contains("did you mean \"radius\"?");
    }

    @Test
    void nothingIsOpenedBesidesTheFolder() throws IOException {
        Path secret = Files.writeString(folder.resolveSibling("secret-" + folder.getFileName() + ".xml"), Files.readString(folder.resolve("half.xml")));
        Files.createSymbolicLink(folder.resolve("link.xml"), secret);
        assertThat(refused(sample.replace("half.xml", "link.xml")).getMessage()).contains("link.xml");
        Files.delete(secret);
        assertThat(refused("<!DOCTYPE lesson [<!ENTITY a SYSTEM \"file:///etc/passwd\">]>" + sample).getMessage()).contains("there must be no DOCTYPE here; remove it");
        assertThat(refused("").getMessage()).contains(":1:1: the file is empty");
        assertThat(refused("not a lesson").getMessage()).contains(":1:1: ");
        assertThat(refused(sample.substring(0, sample.length() / 2)).getMessage()).contains("bad.xml:");
        assertThat(refused(sample.replace("Half", "\u0000")).getMessage()).contains("bad.xml:2:", "a character that XML does not allow");
        assertThat(refused(sample.replace("<lesson ", "<lektion ").replace("</lesson", "</lektion")).getMessage()).contains(":1:", "a lesson begins with <lesson>, not with <lektion>");
    }

    @Test
    void answersMayBeWrittenAsPeopleWriteThem() throws Exception {
        Question question = Lessons.read(folder.resolve("lesson.xml")).questions().get(0);
        for (String good : List.of("4", " 4.0 ", "4,005", "8/2", "sqrt(16)", "4°", "2 + 2")) {
            assertThat(question.mark(good, List.of(4.0)).verdict()).as(good).isEqualTo(Verdict.RIGHT);
        }
        for (String good : List.of("0.6 0 0.8", "0,6 0 0,8", "(0.6, 0, 0.8)", "0,6; 0; 4/5", "3/5 0 4/5")) {
            assertThat(question.mark(good, List.of(0.6, 0.0, 0.8)).verdict()).as(good).isEqualTo(Verdict.RIGHT);
        }
        for (String unreadable : List.of("", "four", "4 4", "4,", "1/0", "1e999")) {
            assertThat(question.mark(unreadable, List.of(4.0)).verdict()).as(unreadable).isEqualTo(Verdict.UNREADABLE);
        }
        assertThat(question.mark("NaN", List.of(4.0)).verdict()).isEqualTo(Verdict.UNREADABLE);
        assertThat(question.mark("4.02", List.of(4.0)).verdict()).isEqualTo(Verdict.WRONG);
    }
}
