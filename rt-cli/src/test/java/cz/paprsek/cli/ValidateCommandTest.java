package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.warning.SceneWarning;
import cz.paprsek.warning.SceneWarnings;
import cz.paprsek.words.Words;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class ValidateCommandTest {
    private static final String LIGHT = "<point-light name=\"lamp\" position=\"2 3 4\"/>";

    @TempDir
    Path folder;

    private static List<String> warnings(String content) throws Exception {
        return SceneWarnings.of(SceneFiles.parse("<scene xmlns=\"urn:paprsek:scene:1\"><camera position=\"0 1 5\" direction=\"0 0 -1\"/>"
                + content + "</scene>")).stream().map(SceneWarning::message).toList();
    }

    static Stream<Arguments> suspiciousScenes() {
        return Stream.of(
                Arguments.of(LIGHT + "<sphere name=\"x\" radius=\"1\"><material diffusion=\"0.9\" reflection=\"0.3\"/></sphere>",
                        "material of sphere \"x\": diffusion, reflection and transparency add up to 1.2"),
                Arguments.of(LIGHT + "<material name=\"m\" reflection=\"0.9\"/><sphere radius=\"1\" material=\"m\"/>",
                        "material \"m\": diffusion, reflection and transparency add up to 1.7"),
                Arguments.of(LIGHT + "<sphere radius=\"1\" position=\"0 1 4.5\"/>",
                        "the camera is inside sphere #1, which is opaque"),
                Arguments.of(LIGHT + "<plane position=\"0 2 0\"/>", "the camera is inside plane #1, which is opaque"),
                Arguments.of(LIGHT + "<difference><sphere radius=\"5.2\"/><sphere radius=\"1\"/></difference>",
                        "the camera is inside difference #1, which is opaque"),
                Arguments.of(LIGHT + "<block min=\"1 1 1\" max=\"9 9 9\"/>", "light \"lamp\" is inside block #1, which is opaque"),
                Arguments.of(LIGHT + "<difference name=\"d\"><sphere radius=\"1\"/><torus major-radius=\"1\" minor-radius=\"0.2\" "
                        + "position=\"3 0 0\"/></difference>", "torus #2 in difference \"d\" removes nothing"),
                Arguments.of(LIGHT + "<intersection><sphere radius=\"1\"/><sphere name=\"far\" radius=\"1\" position=\"3 0 0\"/></intersection>",
                        "sphere \"far\" in intersection #1 does not meet"),
                Arguments.of(LIGHT + "<material name=\"m\"/><sphere radius=\"1\"/>", "material \"m\" is not used"),
                Arguments.of(LIGHT + "<union><sphere radius=\"1\"><material transparency=\"0.8\" diffusion=\"0\" refractive-index=\"1.5\"/>"
                        + "</sphere><sphere radius=\"2\"><material transparency=\"0.8\" diffusion=\"0\" refractive-index=\"1.3\"/></sphere></union>",
                        "union #1 is transparent, but its operands have different refractive indices"),
                Arguments.of(LIGHT + glass("block", "min='0 0 0' max='1 1 1'", 1.5) + glass("block", "min='0 1 0' max='1 2 1'", 1.33),
                        "block #1 and block #2 touch near "),
                Arguments.of(LIGHT + glass("sphere", "radius='1'", 1.5) + glass("block", "min='0.5 0 0' max='2 1 1'", 1.33),
                        "sphere #1 and block #2 reach into each other near "),
                Arguments.of(LIGHT + "<difference name='tumbler'><material transparency='0.8' diffusion='0' refractive-index='1.5'/>"
                        + "<cylinder radius='0.9' height='1.7'/><cylinder radius='0.8' height='2' position='0 0.2 0'/></difference>"
                        + glass("cylinder", "radius='0.8' height='1' position='0 0.2 0'", 1.33), "difference \"tumbler\" and cylinder #2 touch near "),
                Arguments.of(LIGHT + "<sphere radius='1'><material color='1 0.5 0'/></sphere>",
                        "material of sphere #1: the color 1 0.5 0 is next to black; colours go up to 255"),
                Arguments.of(LIGHT + "<ambient color='40 40 40'/>" + glass("sphere", "radius='1'", 1.5), "material of sphere #1 is clear, but ambient light makes it milky"),
                Arguments.of(LIGHT + "<isosurface name='i' expression='x^2 + y^2 + z^2 &lt; 1'/>", "isosurface \"i\" is nowhere: its formula is not below 0"),
                Arguments.of(LIGHT + "<union><isosurface expression='sqrt(x - 3)'/></union>", "isosurface #1 in union #1 is nowhere"),
                Arguments.of("<point-light position='2 3 4' color='1 1 1'/><sphere radius='1'/>", "light #1: the color 1 1 1 is next to black"),
                Arguments.of("<sphere radius=\"1\"/>", "there is no light and no ambient light"),
                Arguments.of("<point-light position=\"0 0 0\" intensity=\"0\"/><disc radius=\"1\"/>", "there is no light"),
                Arguments.of(LIGHT, "there are no objects"));
    }

    /** The camera is in a room, about which the other bodies are asked. */
    @ParameterizedTest
    @ValueSource(strings = {"<mesh file='none.stl'/>", "<height-field file='none.png'/>", "<text value='A' font='none.ttf'/>",
            "<difference><block min='0 0 0' max='1 1 1'/><height-field file='none.png'/></difference>"})
    void ofBodiesThatAreNotThereNothingIsSaid(String body) throws Exception {
        assertThat(warnings("<point-light position='20 3 4'/>" + body + "<block min='-9 -9 -9' max='9 9 9'/><sphere radius='1'/>")).isEmpty();
    }

    /** In a line, as any other fault. */
    @ParameterizedTest
    @CsvSource({"mesh, stl", "height-field, png"})
    void aFileThatIsNotThereIsToldInALine(String element, String ending) throws IOException {
        Path file = Files.writeString(folder.resolve("lacking.xml"), "<scene xmlns='urn:paprsek:scene:1' name='x'><camera position='0 1 5' target='0 0 0'/>" + LIGHT
                + "<" + element + " file='none." + ending + "'/></scene>");
        Run run = Run.cli("validate", file);
        assertThat(run.code()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(run.err()).startsWith(file + ":1:").contains("none." + ending).hasLineCount(1);
    }

    @ParameterizedTest
    @MethodSource("suspiciousScenes")
    void whatIsHardlyMeantIsWarnedOfOnce(String content, String warning) throws Exception {
        assertThat(warnings(content)).singleElement().asString().startsWith(warning);
    }

    @ParameterizedTest
    @MethodSource("suspiciousScenes")
    void theEditorSaysItInCzech(String content, String warning) throws Exception {
        assertThat(warning.contains(" touch near ")
                || !Words.in(Locale.forLanguageTag("cs")).sentence(warnings(content).get(0)).matches("(?sU).*\\b(is|has|the|of|and|no|in|does|will)\\b.*")).isTrue();
    }

    private static String glass(String kind, String attributes, double index) {
        return "<" + kind + " " + attributes + "><material transparency='0.8' diffusion='0' refractive-index='" + index + "'/></" + kind + ">";
    }

    @Test
    void bodiesOfGlassMayLieWithinOthersApartOrBeOfOneIndex() throws Exception {
        assertThat(warnings(LIGHT + glass("sphere", "radius='1'", 1.5) + glass("sphere", "radius='0.5' position='0.1 0 0'", 1.33)
                + glass("sphere", "radius='1' position='2.1 0 0'", 1.4) + glass("block", "min='-9 -9 -9' max='-8 -8 -8'", 1.5)
                + glass("block", "min='-8 -9 -9' max='-7 -8 -8'", 1.5))).isEmpty();
    }

    @Test
    void aSoundSceneGetsNoWarning() throws Exception {
        assertThat(warnings(LIGHT + "<ambient color=\"9 9 9\"/><material name=\"glass\" diffusion=\"0.1\" reflection=\"0.2\" transparency=\"0.7\" "
                + "refractive-index=\"1.5\"/><sphere radius=\"1\" position=\"2 3 4\" material=\"glass\"/>"
                + "<difference material=\"glass\"><block min=\"0 0 0\" max=\"1 1 1\"/><plane position=\"0 0.5 0\"/></difference>")).isEmpty();
    }

    @Test
    void problemsGoToStandardErrorAndWarningsToStandardOutput() throws IOException {
        Path dark = Scenes.scene(folder.resolve("dark.xml"), "<sphere radius=\"1\" position=\"0 1 0\"/>");
        Path broken = Scenes.broken(folder.resolve("broken.xml"));
        Run run = Run.cli("validate", dark, broken);
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.out()).startsWith(dark + ":1:1: warning: there is no light").endsWith(dark + ": valid, 1 warning\n");
        assertThat(run.err().lines()).hasSizeGreaterThan(1).allMatch(line -> line.startsWith(broken + ":"));
        assertThat(Run.cli("validate", dark).code()).isZero();
        assertThat(Run.cli("validate", dark, "--quiet").out()).isEmpty();
        assertThat(Run.cli("validate", broken, "--json").out()).contains("\"valid\":false,\"problems\":[{\"file\":").contains("\"line\":2,\"column\":");
    }

    @Test
    void warningsForProgramsSayWhichSceneAndObject() throws IOException {
        Path file = Scenes.scene(folder.resolve("dark.xml"), "<material name=\"m\"/><sphere radius=\"1\"/>");
        assertThat(Run.cli("validate", file, "--json").out()).contains("\"valid\":true",
                "{\"file\":\"" + file + "\",\"line\":1,\"column\":1,\"scene\":\"ball\",\"object\":\"\",\"kind\":\"dark\",\"message\":\"there is no light and no ambient light",
                "\"line\":1,\"column\":124,\"scene\":\"ball\",\"object\":\"material \\\"m\\\"\",\"kind\":\"unused\"");
    }

    @Test
    void aLightWithASizeIsInsideOnlyIfAllOfItIs() throws IOException {
        String inside = "<sphere radius=\"0.5\" material=\"m\"/><material name=\"m\"/>";
        for (String light : List.of("<sphere-light position=\"0 0 0\" radius=\"1\"/>", "<area-light position=\"0 0 0\" size=\"2 0.1\"/>", "<area-light position=\"0 0 0\" radius=\"1\"/>")) {
            assertThat(Run.cli("validate", Scenes.scene(folder.resolve("around.xml"), light + inside)).out()).doesNotContain("warning");
            String small = light.replace("\"1\"", "\"0.4\"").replace("2 0.1", "0.4 0.1");
            assertThat(Run.cli("validate", Scenes.scene(folder.resolve("within.xml"), small + inside)).out()).contains("light #1 is inside sphere #1, which is opaque");
        }
    }

    @Test
    void aBodyWithOthersInItIsARoom() throws Exception {
        String room = LIGHT + "<sphere radius=\"50\"/>";
        assertThat(warnings(room)).anyMatch(warning -> warning.startsWith("the camera is inside sphere #1"));
        assertThat(warnings(room + "<sphere radius=\"1\"/>")).noneMatch(warning -> warning.startsWith("the camera is inside"));
        assertThat(warnings(room + "<sphere radius=\"1\" position=\"99 0 0\"/>")).anyMatch(warning -> warning.startsWith("the camera is inside sphere #1"));
    }

    @Test
    void aCameraWithinABallOfLightSeesNothing() throws IOException {
        String ball = "<sphere-light position=\"0 0 0\" radius=\"90\"/><sphere radius=\"0.5\"/>";
        assertThat(Run.cli("validate", Scenes.scene(folder.resolve("ball.xml"), ball)).out()).contains("the camera is inside light #1, which is black from within");
        assertThat(Run.cli("validate", Scenes.scene(folder.resolve("unseen.xml"), ball.replace("/><", " visible=\"false\"/><"))).out()).doesNotContain("warning");
    }

    @Test
    void warningsSayWhereTheThingBegins() throws IOException {
        String scene = """
                <scene xmlns='urn:paprsek:scene:1' name='a'>
                  <!-- <sphere radius="1"/> -->
                  <material name='ů'/><material name='used'/><material name="x"/>\r
                  <sphere radius='1' material='used' name='>'/>\t<difference><material/>
                    <block
                      min='3 3 3' max='4 4 4'/>
                    <union><sphere radius='1' position='9 9 9'/></union>
                  </difference>
                  <point-light position='5 5 5'/><?x?><point-light
                    position='0 0 0'/>
                  <camera position='0 0 5' direction='0 0 -1'/>
                </scene>
                """;
        for (String text : List.of(scene, "\uFEFF" + scene, scene.replaceAll("<(/?)(?=[a-z])", "<$1q:").replace("xmlns=", "xmlns:q="))) {
            int prefix = text.contains("xmlns:q") ? 2 : 0;
            Path file = Files.writeString(folder.resolve("a.xml"), text);
            assertThat(Run.cli("validate", file).out().lines().map(line -> line.replace(file + ":", ""))).containsExactly(
                    "3:3: warning: material \"ů\" is not used",
                    "3:" + (46 + 2 * prefix) + ": warning: material \"x\" is not used",
                    "7:5: warning: union #2 in difference #2 removes nothing: it does not meet the first operand",
                    "9:" + (39 + prefix) + ": warning: light #2 is inside sphere \">\", which is opaque; it lights nothing outside",
                    " valid, 4 warnings");
        }
    }

    /** One attribute is at fault, of an element or of the material inside it; elsewhere it is the element. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "<sphere radius='1'><material diffusion='0.5' color='1 1 0.5'/></sphere> | color='1 | the color",
        "<material name='m' color='0.1 0 0'/><sphere radius='1' material='m'/> | color='0.1 | the color",
        "<point-light name='visible' position='9 9 9' color='1 1 1'/><sphere radius='1'/> | color='1 | the color",
        "<sun-light name=' visible= ' direction='0 -1 0' visible='true'/><sphere radius='1'/> | visible='true | no disc",
        "<camera position='0 0 9' target='0 0 0' aperture='0.1'/><sphere radius='1'/> | aperture='0.1 | blur will be grain",
        "<sphere radius='1'><material diffusion='0.9' reflection='0.9'/></sphere> | <sphere | add up to"})
    void warningsPointAtTheAttributeAtFault(String content, String at, String sentence) throws IOException {
        String text = "<scene xmlns='urn:paprsek:scene:1'>\n<ambient color='white'/><camera position='0 0 5' target='0 0 0'/>\n" + content + "</scene>";
        Path file = Files.writeString(folder.resolve("a.xml"), text);
        int column = content.indexOf(at) + 1;
        assertThat(Run.cli("validate", file).out()).containsOnlyOnce(": warning: ").contains(file + ":3:" + column + ": warning: ").contains(sentence);
    }

    @Test
    void waterThatStandsInAGlassIsNoProblem() throws IOException {
        Path file = Scenes.scene(folder.resolve("a.xml"), LIGHT + glass("block", "min='0 0 0' max='1 1 1'", 1.5) + glass("block", "min='0 1 0' max='1 2 1'", 1.33));
        Run run = Run.cli("validate", file, "--strict");
        assertThat(run.code()).isZero();
        assertThat(run.out()).matches("(?s).*a.xml:1:\\d+: note: block #1 and block #2 touch near .*a.xml: valid, 1 note\n");
        assertThat(Run.cli("validate", file, "--strict", "--json").out()).contains("\"valid\":true", "\"warnings\":[],\"notes\":[{\"file\"", "\"kind\":\"glass-touches\"");
    }

    @Test
    void shippedScenesAreWithoutWarnings() {
        Run run = Run.cli("validate", "../scenes/*.xml", "--strict");
        assertThat(run.err()).isEmpty();
        assertThat(run.code()).isZero();
    }

    @Test
    void whoIsStrictTakesWarningsForProblems() throws IOException {
        Path dark = Scenes.scene(folder.resolve("dark.xml"), "<sphere radius=\"1\"/>");
        Run run = Run.cli("validate", dark, "--strict");
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.err()).startsWith(dark + ":1:1: warning: there is no light").hasLineCount(1);
        assertThat(run.out()).isEmpty();
        assertThat(Run.cli("validate", dark, "--strict", "--json").out()).contains("\"valid\":false,\"problems\":[],\"warnings\":[{");
        assertThat(Run.cli("validate", Scenes.ball(folder.resolve("good.xml")), "--strict").code()).isZero();
    }

    @Test
    void aMissingFileIsABadScene() {
        Run run = Run.cli("validate", folder.resolve("none.xml"));
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.err()).isEqualTo(folder.resolve("none.xml") + ": no such file\n");
    }

    @Test
    void theScenesOfADatabaseAreNamed() throws IOException {
        String camera = "<camera position=\"0 1 5\" direction=\"0 0 -1\"/></scene>";
        Path file = Files.writeString(folder.resolve("db.xml"), "<database xmlns=\"urn:paprsek:scene:1\"><scene name=\"one\">" + camera
                + "<scene name=\"two\">" + camera + "</database>");
        assertThat(Run.cli("validate", file).out()).contains(file + ":1:110: warning: scene \"two\": there are no objects");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void fileNamesThatATerminalWouldObeyAreShownAsCodes() throws IOException {
        Path file = Scenes.ball(folder.resolve("a\u001b[31mb.xml"));
        assertThat(Run.cli("validate", file).out()).contains("a\\u001b[31mb.xml: valid");
        assertThat(Run.cli("info", file).out()).contains("a\\u001b[31mb.xml");
        assertThat(Run.cli("info", file, "--json").out()).contains("a\\u001b[31mb.xml");
        Run rendering = Run.cli("render", file, "-o", folder + "/");
        assertThat(rendering.out() + rendering.err()).contains("a\\u001b[31mb.png").doesNotContain("\u001b");
        assertThat(Run.cli("render", "\u001b[31m.xml", "-o", "\u001b.gif").err()).doesNotContain("\u001b");
    }

    @Test
    void aPictureThatIsMissingIsAProblemWhereItIsNamed() throws Exception {
        Path file = Files.writeString(folder.resolve("a.xml"), """
                <scene xmlns="urn:paprsek:scene:1">
                  <sky file="sky.hdr"/>
                  <camera position="0 1 5" direction="0 0 -1"/> <ambient color="white"/>
                  <sphere radius="1">
                    <material><image filter="nearest" file="gone.png"/></material>
                  </sphere>
                </scene>
                """);
        Run run = Run.cli("validate", file);
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.err()).contains(file + ":2:8: \"sky.hdr\": there is no such file beside the scene", file + ":5:39: \"gone.png\": there is no such file beside the scene");
        for (Run other : List.of(Run.cli("render", file, "-o", folder.resolve("a.png")), Run.cli("explain", file, "3,4"))) {
            assertThat(other.err().strip()).isEqualTo(file + ":5:39: \"gone.png\": there is no such file beside the scene");
            assertThat(other.code()).isEqualTo(3);
        }
        Path assets = Files.createDirectory(folder.resolve("assets"));
        Files.write(assets.resolve("sky.hdr"), new byte[1]);
        Files.write(assets.resolve("gone.png"), new byte[1]);
        assertThat(Run.cli("validate", file, "--assets", assets).code()).isZero();
        for (String command : new String[] {"validate", "render", "info"}) {
            Run nowhere = Run.cli(command, file, "--assets", folder.resolve("nowhere"));
            assertThat(nowhere.err()).contains("--assets: " + folder.resolve("nowhere") + ": no such directory");
            assertThat(nowhere.code()).isEqualTo(2);
        }
        assertThat(Run.cli("validate", file, "--json").out()).contains("\"valid\":false", "\"line\":5");
    }

    /** What a scene is made of: copies, definitions, formulas, another file. What stands behind them stands elsewhere in the scene than in the file. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            <repeat count='5'><sphere radius='1'/></repeat>|§<sphere radius='1'><material reflection='0.9'/></sphere>
            <repeat count='{n}'><sphere radius='1'/></repeat>|<mesh §file='none.stl'/>
            <param name='r' value='0.9'/>|<repeat count='2'>§<sphere radius='1'><material reflection='{r}'/></sphere></repeat>
            <sphere radius='{n}'/>|<define name='d'><mesh §file='none.stl'/></define><union><instance of='d'/><instance of='d'/></union>
            <repeat count='5'><text value='a&#10;b'/></repeat>|<text value='A' §font='none.ttf'/>
            <repeat count='5'><extrude height='1' path='M0 0H1~V1Z'/></repeat>|<sphere radius='1'><material><image §file='none.png'/></material></sphere>
            """)
    void whatIsMadeIsToldWhereItStands(String before, String body) throws IOException {
        String head = "<scene xmlns='urn:paprsek:scene:1'><param name='n' value='3'/><camera position='0 1 50' target='0 0 0'/>" + LIGHT + "\n" + before.replace('~', '\n') + "\n";
        Path file = Files.writeString(folder.resolve("made.xml"), head + body.replace("§", "") + "</scene>");
        String place = file + ":" + (head.chars().filter(c -> c == '\n').count() + 1) + ":" + (body.indexOf('§') + 1) + ": ";
        assertThat(Run.cli("validate", "-D", "n=4", file, "--strict").err().lines()).hasSize(1).allSatisfy(told -> assertThat(told).startsWith(place));
    }

    @Test
    void whatIsIncludedIsToldWhereItStandsThere() throws IOException {
        Files.writeString(folder.resolve("parts.xml"), """
                <scene xmlns='urn:paprsek:scene:1'><camera position='0 1 5' target='0 0 0'/>
                  <material name='m' reflection='0.9'/>
                </scene>
                """);
        Path file = Files.writeString(folder.resolve("made.xml"), "<scene xmlns='urn:paprsek:scene:1'><include file='parts.xml'/><camera position='0 1 50' target='0 0 0'/>" + LIGHT
                + "<sphere radius='1' material='m'/></scene>");
        assertThat(Run.cli("validate", file).out()).startsWith(folder.resolve("parts.xml") + ":2:3: warning: material \"m\": ");
    }
}
