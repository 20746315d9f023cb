package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Every way to get a file wrong, and the line that says so. */
class BadFilesTest {
    private static final String NO_SCENE = "1:1: this is not a scene file: it should start with <scene xmlns=\"urn:paprsek:scene:1\">";
    private static final String ROOT = "1:1: a scene file starts with <scene xmlns=\"urn:paprsek:scene:1\">, or <database …>, but here is ";

    /** A scene with a camera on line 2 and the given text from line 3 on. */
    private static String scene(String content) {
        return "<scene xmlns='urn:paprsek:scene:1'>\n<camera position='0 1 5' direction='0 0 -1'/>\n" + content + "</scene>";
    }

    private static Arguments in(String content, String... problems) {
        return Arguments.of(scene(content), List.of(problems));
    }

    static Stream<Arguments> files() {
        return Stream.of(
                Arguments.of("", List.of(NO_SCENE)),
                Arguments.of("hello", List.of(NO_SCENE)),
                Arguments.of("\u0000\u0001\u0002 PNG", List.of(NO_SCENE)),
                Arguments.of("<scene/>", List.of(ROOT + "<scene> without that xmlns")),
                Arguments.of("<scene xmlns='urn:x'/>", List.of(ROOT + "<scene> without that xmlns")),
                Arguments.of("<html/>", List.of(ROOT + "<html>")),
                Arguments.of("<!DOCTYPE scene [<!ENTITY x SYSTEM 'file:///etc/passwd'>]><scene>&x;</scene>",
                        List.of("1:10: a DOCTYPE is not allowed in a scene file; remove it")),
                Arguments.of("<scene xmlns='urn:paprsek:scene:1'/>",
                        List.of("1:1: a scene needs a camera; add <camera position=\"0 1 5\" direction=\"0 0 -1\"/>")),
                Arguments.of("<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 0'/></scene>",
                        List.of("1:36: <camera> needs a direction or a target")),
                Arguments.of("<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 0' direction='0 2 0'/></scene>",
                        List.of("1:36: camera up must not be parallel to the view direction; turn one of them")),
                in("<camera position='0 0 0' target='0 0 1'/>", "3:1: a scene has at most one <camera>, but here are 2"),
                in("  <sphere radius='-1'/>", "3:3: sphere radius must be a finite number above 0, but is \"-1\""),
                in("<sphere radius='1e999'/>", "3:1: sphere radius must be a finite number above 0, but is \"1e999\""),
                in("<sphere radius='NaN'/>", "3:1: sphere radius must be a finite number above 0, but is \"NaN\""),
                in("<sphere radius='INF'/>", "3:1: sphere radius must be a finite number above 0, but is \"INF\""),
                in("<sphere radius='12,5'/>", "3:1: sphere radius must be a finite number above 0, but is \"12,5\""),
                in("<sphere radius='it&apos;s'/>", "3:1: sphere radius must be a finite number above 0, but is \"it's\""),
                in("<sphere raduis='1'/>", "3:1: <sphere> has no attribute \"raduis\"; did you mean \"radius\"?",
                        "3:1: <sphere> needs the attribute radius, a finite number above 0"),
                in("<!-- a\n comment -->\n <spere radius='1'/>", "5:2: <scene> has no element <spere>; did you mean \"sphere\"?"),
                in("<sphere radius='1' position='1 2'/>", "3:1: sphere position must be three finite numbers, x y z, but is \"1 2\""),
                in("<sphere radius='1' scale='1 0 1'/>", "3:1: sphere scale must be one finite number or three, none of them 0, but is \"1 0 1\""),
                in("<sphere radius='1'>round</sphere>", "3:1: <sphere> holds elements only, but here is text"),
                in("<difference><rectangle min='0 0' max='1 1'/></difference>",
                        "3:13: a rectangle has no inside, so <difference> cannot use it; give it a <block>"),
                in("<union><disc radius='1'/></union>", "3:8: a disc has no inside, so <union> cannot use it; give it a <cylinder>"),
                in("<union><point-light position='1 2 3'/></union>", "3:8: <union> has no element <point-light> here"),
                in("<union>\n</union>", "3:1: <union> needs at least one solid inside"),
                in("<block min='1 1 1' max='0 2 2'/>",
                        "3:1: block min must be below max along every axis, but min is 1 1 1 and max is 0 2 2"),
                in("<torus major-radius='1' minor-radius='2'/>", "3:1: torus minor-radius must be at most its major-radius of 1.0, but is 2.0"),
                in("<sphere name='a' radius='1'/>\n<sphere name='a' radius='2'/>",
                        "4:1: there is already an object named \"a\" here; give one of them another name"),
                in("<union>\n<sphere name='a' radius='1'/><sphere name='a' radius='2'/></union>",
                        "4:30: there is already an operand named \"a\" here; give one of them another name"),
                in("<material name='a'/><material name='a'/>", "3:21: there is already a material named \"a\" here; give one of them another name"),
                in("<material name='glass'/>\n<sphere radius='1' material='gass'/>",
                        "4:1: there is no material named \"gass\"; did you mean \"glass\"?"),
                in("<sphere radius='1' material='a'><material/></sphere>",
                        "3:1: there is a material attribute and a <material> inside; remove one of them"),
                in("<sphere radius='1'><material><checkerboard columns='2' rows='2'/></material></sphere>",
                        "3:1: a checkerboard lies on a rectangle or a disc only; give this shape a checker"),
                in("<material name='m' color='1 2 3'><checker size='1'/></material>",
                        "3:1: a material has either a color or a pattern, not both; remove one of them"),
                in("<material name='m' color='1 2 256'/>", "3:1: material color must be three numbers from 0 to 255, red green blue, but is \"1 2 256\""),
                in("<render width='99999999999'/>", "3:1: render width must be a whole number from 1 to 32768, but is \"99999999999\""),
                in("<render hight='3'/>\n<sphere radius='0'/>", "3:1: <render> has no attribute \"hight\"; did you mean \"height\"?",
                        "4:1: sphere radius must be a finite number above 0, but is \"0\""),
                in("<sphere radius='1' name='a&#27;[31mb'/>".replace("&#27;", "&#x85;"),
                        "3:1: sphere name must be a text of 1 to 200 characters without control characters, but is \"a\\u0085[31mb\""));
    }

    @ParameterizedTest
    @MethodSource("files")
    void eachMistakeGetsItsLine(String xml, List<String> expected) {
        assertThat(problems(xml)).containsExactlyElementsOf(expected);
    }

    @ParameterizedTest
    @ValueSource(strings = {"de", "ja", "zh-CN", "cs"})
    void theLanguageOfTheMachineDoesNotMatter(String language) {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag(language));
            assertThat(problems(scene("<sphere raduis='1' radius='x'/><spere/>"))).containsExactly(
                    "3:1: <sphere> has no attribute \"raduis\"",
                    "3:1: sphere radius must be a finite number above 0, but is \"x\"",
                    "3:32: <scene> has no element <spere>; did you mean \"sphere\"?");
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void aFileCutAnywhereIsRefusedInOneLine() {
        String whole = scene("<difference name='a'>\n<sphere radius='1'/><block min='0 0 0' max='1 1 1'/></difference>\n");
        for (int end = 0; end < whole.length(); end++) {
            assertThat(problems(whole.substring(0, end))).as(whole.substring(0, end)).hasSizeBetween(1, 2);
        }
    }

    @Test
    void deepNestingIsRefusedQuickly() {
        org.junit.jupiter.api.Assertions.assertTimeoutPreemptively(Duration.ofSeconds(5), () ->
                assertThat(problems(scene("<union>".repeat(200_000)))).containsExactly("3:3494: elements are nested deeper than 500"));
    }

    @Test
    void bytesThatAreNoTextAreRefused() {
        byte[] latin = scene("<sphere radius='1' name='é'/>").getBytes(StandardCharsets.ISO_8859_1);
        byte[] unknown = "<?xml version='1.0' encoding='klingon'?><scene/>".getBytes(StandardCharsets.UTF_8);
        for (byte[] bytes : List.of(latin, unknown, new byte[] {-1, -40, 3, 9})) {
            SceneFileException refused = catchThrowableOfType(SceneFileException.class,
                    () -> SceneFiles.read(new ByteArrayInputStream(bytes), "x"));
            assertThat(refused.problems()).hasSize(1);
        }
    }

    @Test
    void aMissingFileAndAFolderAreNamed(@TempDir Path folder) {
        assertThatExceptionOfType(IOException.class).isThrownBy(() -> SceneFiles.read(folder.resolve("none.xml")))
                .withMessage(folder.resolve("none.xml") + ": no such file");
        assertThatExceptionOfType(IOException.class).isThrownBy(() -> SceneFiles.read(folder))
                .withMessage(folder + ": this is a directory, not a scene file");
    }

    private static List<String> problems(String xml) {
        SceneFileException refused = catchThrowableOfType(SceneFileException.class, () -> SceneFiles.parse(xml));
        assertThat(refused).as("refused").isNotNull();
        return refused.problems().stream().map(problem -> problem.toString().replaceFirst("^text:", "")).toList();
    }
}
