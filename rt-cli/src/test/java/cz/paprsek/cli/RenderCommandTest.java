package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.render.Renderer;
import cz.paprsek.xml.SceneFiles;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Objects;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RenderCommandTest {
    @TempDir
    Path folder;

    private Path ball;

    @BeforeEach
    void writeTheBall() throws IOException {
        ball = Scenes.ball(folder.resolve("ball.xml"));
    }

    @Test
    void aSceneBecomesThePictureTheLibraryRenders() throws Exception {
        Path picture = folder.resolve("a.png");
        Run run = Run.cli("render", ball, "-o", picture);
        assertThat(run.code()).isZero();
        assertThat(run.out()).matches("\\Q" + ball + " -> " + picture + "\\E  16x8  \\d+\\.\\d\\d s  \\d+\\.\\d Mray/s\n");
        assertThat(run.err()).startsWith(ball + ": rendering 16x8 on ");
        assertThat(Objects.requireNonNull(ImageIO.read(picture.toFile())).getRGB(0, 0, 16, 8, null, 0, 16))
                .isEqualTo(Renderer.render(SceneFiles.read(ball)).toArgb());
    }

    @Test
    void anyThreadCountGivesTheSameFile() throws IOException {
        Run.cli("render", ball, "-o", folder.resolve("1.png"), "--threads", "1", "--size", "100x90");
        Run.cli("render", ball, "-o", folder.resolve("3.png"), "--threads", "3", "--size", "100x90");
        assertThat(folder.resolve("1.png")).hasSameBinaryContentAs(folder.resolve("3.png"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"bmp", "ppm", "pgm", "pfm", "ppm16", "txt", "lum"})
    void theEndingSaysTheFormat(String ending) throws Exception {
        Path picture = folder.resolve("a." + ending);
        assertThat(Run.cli("render", ball, "-o", picture, "--quiet")).matches(run -> run.out().isEmpty() && run.err().isEmpty());
        assertThat(Files.readAllBytes(picture)).isEqualTo(expected(ImageFormat.of(ending).orElseThrow()));
    }

    @Test
    void formatAndRawGoBeyondTheEnding() throws Exception {
        Run.cli("render", ball, "-o", folder.resolve("a.ppm"), "--format", "ppm16");
        assertThat(Files.readAllBytes(folder.resolve("a.ppm"))).isEqualTo(expected(ImageFormat.PPM16));
        Run.cli("render", ball, "-o", folder.resolve("a.txt"), "--raw");
        assertThat(Files.readAllBytes(folder.resolve("a.txt"))).isEqualTo(expected(ImageFormat.RAW));
        Run refused = Run.cli("render", ball, "-o", folder.resolve("a.png"), "--raw");
        assertThat(refused.code()).isEqualTo(2);
        assertThat(refused.err()).contains("--raw is for text");
    }

    @Test
    void aPictureOnStandardOutputIsAloneThere() throws Exception {
        Run run = Run.cli("render", ball, "--format", "txt", "-o", "-");
        assertThat(run.bytes()).isEqualTo(expected(ImageFormat.TXT));
        assertThat(run.out()).isEmpty();
        assertThat(run.err()).contains(ball + " -> -  16x8");
        assertThat(Run.cli("render", ball, "-o", "-", "--json").code()).isEqualTo(2);
    }

    private byte[] expected(ImageFormat format) throws Exception {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageFiles.write(Renderer.render(SceneFiles.read(ball)), bytes, format);
        return bytes.toByteArray();
    }

    @Test
    void aRegionIsThatPartOfTheWholePicture() throws Exception {
        Run.cli("render", ball, "-o", folder.resolve("whole.txt"));
        Run.cli("render", ball, "-o", folder.resolve("part.txt"), "--region", "5,2,4,3");
        StringBuilder part = new StringBuilder();
        for (String row : Files.readAllLines(folder.resolve("whole.txt")).subList(2, 5)) {
            part.append(String.join(" ", Arrays.asList(row.split(" ")).subList(5, 9))).append('\n');
        }
        assertThat(folder.resolve("part.txt")).hasContent(part.toString());
    }

    @Test
    void oneBadSceneDoesNotStopTheOthersAndTheExitCodeTells() throws IOException {
        Path broken = Scenes.broken(folder.resolve("a-broken.xml"));
        Run run = Run.cli("render", folder.resolve("*.xml"), folder.resolve("missing.xml"), "-o", folder.resolve("out") + "/");
        assertThat(run.code()).isEqualTo(3);
        assertThat(folder.resolve("out/ball.png")).isNotEmptyFile();
        assertThat(folder.resolve("out/a-broken.png")).doesNotExist();
        assertThat(run.err()).contains(broken + ":2:", "did you mean \"radius\"?", folder.resolve("missing.xml") + ": no such file\n")
                .doesNotContain("Exception");
    }

    @Test
    void jsonSaysWhatCameOfEveryScene() throws IOException {
        Scenes.broken(folder.resolve("x.xml"));
        Run run = Run.cli("render", ball, folder.resolve("x.xml"), "-o", folder.resolve("{name}.ppm"), "--json", "-q");
        String[] lines = run.out().split("\n");
        assertThat(lines).hasSize(2);
        assertThat(lines[0])
                .contains("\"outcome\":\"done\"", "\"scene\":\"ball\"", "\"format\":\"ppm\"", "\"width\":16", "\"height\":8")
                .contains("\"seconds\":{\"build\":", "\"trace\":", "\"rays\":{\"primary\":128,\"reflected\":0,\"refracted\":0,\"shadow\":");
        assertThat(lines[1]).contains("\"outcome\":\"bad scene\"", "\"problems\":[\"");
    }

    @Test
    void aPictureBeyondAllMemoryIsRefusedButAPartOfItIsNot() throws IOException {
        Path huge = folder.resolve("huge.xml");
        Files.writeString(huge, Files.readString(ball).replaceAll("(width|height)=\"[0-9]+\"", "$1=\"32768\""));
        Run whole = Run.cli("render", huge, "-o", folder.resolve("huge.png"), "--quiet");
        assertThat(whole.code()).isEqualTo(2);
        assertThat(whole.err()).contains("32768 × 32768 pixels").contains("region by region").hasLineCount(1);
        assertThat(Run.cli("render", huge, "-o", folder.resolve("part.png"), "--region", "0,0,8,8", "--quiet").code()).isZero();
    }

    @Test
    void aFileThatCannotBeWrittenIsAFailure() throws IOException {
        Path picture = Files.createFile(folder.resolve("a.png"));
        assumeTrue(picture.toFile().setWritable(false) && !Files.isWritable(picture),
                "this user may write everything");
        Run run = Run.cli("render", ball, "-o", picture);
        assertThat(run.code()).isEqualTo(1);
        assertThat(run.err()).contains(picture + ": no permission to write this file");
    }

    @Test
    void aRequestToStopLeavesNoFileAndExitsWith130() throws IOException {
        Stop stop = new Stop();
        stop.request();
        Run run = Run.watched(false, stop, "render", ball, ball, "-o", folder.resolve("out") + "/");
        assertThat(run.code()).isEqualTo(130);
        assertThat(folder.resolve("out")).isEmptyDirectory();
    }

    @Test
    void somebodyAtATerminalSeesABarThatIsGoneAtTheEnd() {
        Run run = Run.watched(true, new Stop(), "render", ball, "-o", folder.resolve("a.png"));
        assertThat(run.err()).contains("\r").endsWith(" \r").doesNotContain("\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"pfm", "exr", "txt", "lum"})
    void depthsAndCountsAreNumbersForPrograms(String ending) throws IOException {
        Path file = folder.resolve("depth." + ending);
        assertThat(Run.cli("render", ball, "--mode", "depth", "-o", file).code()).isZero();
        Path read = ending.equals("txt") ? Files.copy(file, folder.resolve("copy.lum")) : file;
        Image depth = ImageFiles.read(read);
        // The ball of radius 1 is seen from 5 away, a little beside the middle.
        assertThat(depth.red(8, 4)).isBetween(4f, 4.1f);
        assertThat(depth.red(0, 0)).isZero();
        Path counts = folder.resolve("rays." + ending);
        assertThat(Run.cli("render", ball, "--mode", "rays", "-o", counts).code()).isZero();
        Image rays = ImageFiles.read(ending.equals("txt") ? Files.move(counts, folder.resolve("rays-copy.lum")) : counts);
        assertThat(rays.height()).as("no legend").isEqualTo(depth.height());
        assertThat(rays.red(0, 0)).isEqualTo(1);
    }
}
