package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.process.Columns;
import cz.paprsek.lesson.Lessons;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LessonCommandTest {
    private static final String LESSON = """
            <lesson xmlns="urn:paprsek:lesson:1" scene="scene.xml"><title><en>One</en><cs>Jedna</cs></title>
            <task condition="objects = %d" solution="scene.xml"><en>Do</en><cs>Dělej</cs><hint><en>h</en><cs>h</cs></hint><why><en>w</en><cs>w</cs></why></task></lesson>
            """;

    @TempDir
    Path folder;

    @Test
    void lessonsAreListedInTheirOrder() {
        Run run = Run.cli("lesson");
        assertThat(run.out().lines()).hasSameSizeAs(Lessons.NAMES);
        assertThat(run.out().lines().map(line -> line.substring(0, line.indexOf(' ')))).containsExactlyElementsOf(Lessons.NAMES);
        assertThat(Run.cli("lesson", "--language", "cs").out()).contains("Stíny");
    }

    @Test
    void theTeacherGetsAllAnswers() {
        Run run = Run.cli("lesson", "sphere");
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.out().replaceAll("\\s+", " ")).contains("Where a ray meets a ball", "At which t does it meet the ball?", "= 4.2 ", "0.6 0 0.8", "5.8");
        assertThat(run.err()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "cs"})
    void everyTerminalShowsWholeLines(String language) {
        for (String name : Lessons.NAMES) {
            assertThat(Run.cli("lesson", name, "--language", language).out().lines()).as(name).allMatch(line -> Columns.of(line) <= Columns.USUAL);
        }
    }

    @Test
    void aFileThatIsNotThereIsNamedOnce() {
        Path missing = folder.resolve("missing.xml");
        Run run = Run.cli("lesson", missing);
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.err()).isEqualTo(missing + ": no such file\n");
    }

    @Test
    void tasksThatAreNoneAreTold() throws IOException {
        Files.writeString(folder.resolve("scene.xml"), "<scene xmlns=\"urn:paprsek:scene:1\"><render width=\"8\" height=\"8\"/><camera position=\"0 0 5\" target=\"0 0 0\"/></scene>");
        Path file = Files.writeString(folder.resolve("mine.xml"), LESSON.formatted(0));
        Run done = Run.cli("lesson", file);
        assertThat(done.code()).isEqualTo(3);
        assertThat(done.err().strip()).isEqualTo(file + ": task 1: its condition is met by the scene that the lesson begins with");
        Files.writeString(file, LESSON.formatted(1));
        assertThat(Run.cli("lesson", file).err().strip()).isEqualTo(file + ": task 1: its condition is not met by its solution");
    }

    @Test
    void whatIsWrongIsSaidInOneLine() throws IOException {
        Path file = Files.writeString(folder.resolve("mine.xml"), LESSON);
        Run run = Run.cli("lesson", file);
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.err().strip()).startsWith(file + ":1:").contains("scene: \"scene.xml\"").doesNotContain("\n");
        assertThat(Run.cli("lesson", folder.resolve("none.xml")).code()).isEqualTo(3);
        Run misspelt = Run.cli("lesson", "shadow");
        assertThat(misspelt.code()).isEqualTo(2);
        assertThat(misspelt.err()).contains("did you mean \"shadows\"?");
    }

    @Test
    void theSchemaIsPrinted() {
        assertThat(new String(Run.cli("lesson", "--schema").bytes(), StandardCharsets.UTF_8)).isEqualTo(Lessons.schema());
    }

    /** Without a question it is the tasks that need the picture. */
    @ParameterizedTest
    @ValueSource(strings = {"", "<question asks=\"color\" pixel=\"0,0\" tolerance=\"1\"><en>e</en><cs>c</cs><hint><en>h</en><cs>h</cs></hint><why><en>w</en><cs>w</cs></why></question>"})
    void aFileThatTheSceneLacksIsNamed(String question) throws IOException {
        Files.writeString(folder.resolve("scene.xml"), "<scene xmlns=\"urn:paprsek:scene:1\"><render width=\"8\" height=\"8\"/><camera position=\"0 0 5\" target=\"0 0 0\"/><sky file=\"none.png\"/></scene>");
        Path file = Files.writeString(folder.resolve("mine.xml"), LESSON.formatted(0).replace("<task", question + "<task"));
        Run run = Run.cli("lesson", file);
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.err().strip()).startsWith(file.toString()).contains("none.png").doesNotContain("\n", "Exception");
    }
}
