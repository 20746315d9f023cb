package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class CliTest {
    private static final String BALL = """
            <scene xmlns="urn:paprsek:scene:1">
              <render width="32" height="24"/>
              <camera position="0 0 5" direction="0 0 -1"/>
              <point-light position="3 3 5"/>
              <sphere radius="1"/>
            </scene>
            """;

    @TempDir
    private Path folder;
    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... args) {
        return new Cli(new PrintWriter(out, true), new PrintWriter(err, true), new Interruption()).run(args);
    }

    private String scene(String name, String text) throws IOException {
        return Files.writeString(folder.resolve(name), text).toString();
    }

    private String path(String name) {
        return folder.resolve(name).toString();
    }

    @Test
    void aSceneBecomesAPictureOfTheSizeItAsksFor() throws IOException {
        assertThat(run("render", scene("ball.xml", BALL), "-o", path("a.png"))).isZero();
        assertThat(ImageIO.read(folder.resolve("a.png").toFile()).getWidth()).isEqualTo(32);
        assertThat(out.toString()).contains("ball.xml -> ").contains("32x24").contains("Mray/s");
        assertThat(err.toString()).isEmpty();
    }

    @Test
    void optionsOverrideTheScene() throws IOException {
        assertThat(run("render", scene("ball.xml", BALL), "-o", path("a.bmp"), "--size", "40x30", "--region", "5,6,20,10",
                "--threads", "2", "--max-depth", "1", "--samples", "2")).isZero();
        var picture = ImageIO.read(folder.resolve("a.bmp").toFile());
        assertThat(picture.getWidth()).isEqualTo(20);
        assertThat(picture.getHeight()).isEqualTo(10);
    }

    @Test
    void patternsRenderManyScenesIntoAFolder() throws IOException {
        scene("one.xml", BALL);
        scene("two.xml", BALL);
        assertThat(run("render", path("*.xml"), "-o", path("pictures") + "/")).isZero();
        assertThat(folder.resolve("pictures").toFile().list()).containsExactlyInAnyOrder("one.png", "two.png");
        assertThat(run("render", path("*.xml"), "-o", path("{name}-small.txt"))).isZero();
        assertThat(Files.readAllLines(folder.resolve("one-small.txt"))).hasSize(24);
    }

    @Test
    void oneBadSceneDoesNotStopTheOthers() throws IOException {
        scene("a.xml", BALL.replace("radius=\"1\"", "radius=\"-1\""));
        scene("b.xml", BALL);
        assertThat(run("render", path("a.xml"), path("b.xml"), path("none.xml"), "-o", path("out") + "/")).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(folder.resolve("out").toFile().list()).containsExactly("b.png");
        assertThat(err.toString().lines()).containsExactly(
                path("a.xml") + ":5:3: sphere radius must be a finite number above 0, but is \"-1\"", path("none.xml") + ": no such file");
    }

    @Test
    void jsonIsOneObjectAScene() throws IOException {
        assertThat(run("render", scene("ball.xml", BALL), "-o", path("a.ppm"), "--json")).isZero();
        assertThat(out.toString().trim()).startsWith("{\"scene\":").endsWith("}").contains("\"primaryRays\":768").contains("\"outcome\":\"done\"");
        assertThat(out.toString().lines()).hasSize(1);
    }

    @Test
    void quietSaysNothing() throws IOException {
        assertThat(run("render", scene("ball.xml", BALL), "-o", path("a.png"), "-q")).isZero();
        assertThat(out.toString() + err).isEmpty();
    }

    @Test
    void twoScenesMayNotGoToOneFile() throws IOException {
        scene("a.xml", BALL);
        scene("b.xml", BALL);
        assertThat(run("render", path("a.xml"), path("b.xml"), "-o", path("a.png"))).isEqualTo(ExitCode.USAGE);
        assertThat(err.toString()).contains("would be written to");
        assertThat(folder.resolve("a.png")).doesNotExist();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--size|12|--size takes WIDTHxHEIGHT",
        "--size|0x5|render width must be a whole number from 1 to 32768, but is 0",
        "--threads|0|threads must be a whole number from 1 to 1024, but is 0",
        "--max-depth|x|'x' is not an int",
        "--region|1,2,3|--region takes X,Y,WIDTH,HEIGHT",
        "--region|30,0,10,10|region 30,0,10,10 must lie inside the picture of 32 × 24 pixels",
        "--format|gif|there is no format \"gif\"",
        "--sise|3x3|Unknown option: '--sise'"})
    void wrongValuesAreRefusedWithASentence(String option, String value, String sentence) throws IOException {
        assertThat(run("render", scene("ball.xml", BALL), "-o", path("a.png"), option, value)).isEqualTo(ExitCode.USAGE);
        assertThat(err.toString()).contains(sentence).contains("--help").doesNotContain("Exception").doesNotContain("\tat ");
        assertThat(folder.resolve("a.png")).doesNotExist();
    }

    @Test
    void aPictureWithoutAnEndingWeKnowIsRefusedBeforeRendering() throws IOException {
        assertThat(run("render", scene("ball.xml", BALL), "-o", path("a.gif"))).isEqualTo(ExitCode.USAGE);
        assertThat(err.toString()).contains("a.gif: the ending does not tell the format");
    }

    @Test
    void aPictureThatCannotBeWrittenFails() throws IOException {
        Files.writeString(folder.resolve("file"), "");
        assertThat(run("render", scene("ball.xml", BALL), "-o", path("file/a.png"))).isEqualTo(ExitCode.FAILED);
        assertThat(err.toString()).contains("file").doesNotContain("Exception");
    }

    @Test
    void validateTellsProblemsAndWarnings() throws IOException {
        String odd = BALL.replace("<sphere radius=\"1\"/>", """
                <material name="odd" diffusion="0.9" reflection="0.5"/>
                  <sphere name="shell" radius="20" material="odd"/>
                  <difference name="cut"><sphere radius="1"/><sphere radius="1" position="9 0 0"/></difference>""");
        assertThat(run("validate", scene("odd.xml", odd))).isZero();
        assertThat(out.toString().lines().map(line -> line.replace(path("odd.xml"), "odd.xml"))).containsExactly(
                "odd.xml: warning: material \"odd\": diffusion + reflection + transparency is 1.4, more than the light that falls on it",
                "odd.xml: warning: difference \"cut\" / sphere number 2 removes nothing: it does not reach the first operand",
                "odd.xml: warning: the camera is inside sphere \"shell\"",
                "odd.xml: warning: the light at 3 3 5 is inside sphere \"shell\", which is opaque: no light gets out");
        assertThat(run("validate", scene("bad.xml", "<scene>"))).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(run("validate", scene("ball.xml", BALL))).isZero();
        assertThat(out.toString()).contains("ball.xml: ok");
    }

    @Test
    void infoTellsWhatIsInAScene() throws IOException {
        assertThat(run("info", scene("ball.xml", BALL))).isZero();
        assertThat(out.toString()).contains("1 sphere").contains("-1.000 -1.000 -1.000 to 1.000 1.000 1.000").contains("32x24");
        assertThat(run("info", "--json", path("ball.xml"))).isZero();
        assertThat(out.toString()).contains("\"kinds\":{\"sphere\":1}");
    }

    @Test
    void theSchemaIsPrinted() {
        assertThat(run("schema")).isZero();
        assertThat(out.toString()).startsWith("<?xml").contains("targetNamespace=\"urn:paprsek:scene:1\"").endsWith("</xs:schema>\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "validate", "info", "schema", "generate-completion"})
    void everyCommandHasHelp(String command) {
        assertThat(run(command, "--help")).isZero();
        assertThat(out.toString()).contains("Usage: rt-cli " + command);
    }

    @Test
    void aMisspeltCommandGetsASuggestion() {
        assertThat(run("rendr", "a.xml")).isEqualTo(ExitCode.USAGE);
        assertThat(err.toString()).contains("render");
        assertThat(run()).isEqualTo(ExitCode.USAGE);
    }
}
