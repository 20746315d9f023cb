package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.render.Renderer;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** How pictures are written: bits, exposure, tone, and what they tell of themselves. */
class PictureOptionsTest {
    @TempDir
    private Path folder;
    private Path scene;

    @BeforeEach
    void writeAScene() throws IOException {
        scene = Scenes.ball(folder.resolve("ball.xml"));
    }

    @ParameterizedTest
    @CsvSource({"png, EIGHT_BIT", "jpg, EIGHT_BIT", "tif, EIGHT_BIT", "hdr, SHARED_EXPONENT", "exr, HALF"})
    void formatsThatTellOfThemselvesHoldTheSamePicture(String ending, Precision precision) throws Exception {
        Path picture = folder.resolve("a." + ending);
        assertThat(Run.cli("render", scene, "-o", picture, "--quiet").code()).isZero();
        Image expected = Renderer.render(SceneFiles.read(scene));
        assertThat(ImageFiles.readStored(picture).precision()).isEqualTo(precision);
        Path plain = folder.resolve("plain." + ending);
        ImageFiles.write(expected, plain);
        assertThat(Run.cli("compare", picture, plain, "--tolerance", "0").code()).isZero();
        assertThat(Files.readString(picture, StandardCharsets.ISO_8859_1)).contains("--size 16x8 --samples 1 --max-depth 5", "Paprsek ");
    }

    @Test
    void bitsAreThoseAskedFor() throws IOException {
        Run.cli("render", scene, "-o", folder.resolve("a.png"), "--bits", "16");
        assertThat(ImageFiles.readStored(folder.resolve("a.png")).precision()).isEqualTo(Precision.SIXTEEN_BIT);
        Run.cli("render", scene, "-o", folder.resolve("a.exr"), "--bits", "32");
        assertThat(ImageFiles.readStored(folder.resolve("a.exr")).precision()).isEqualTo(Precision.FLOAT);
        assertThat(Run.cli("render", scene, "-o", folder.resolve("a.jpg"), "--bits", "16"))
                .matches(run -> run.code() == 2 && run.err().contains("jpg has 8 bits per channel, not 16"));
    }

    @Test
    void exposureAndToneChangeTheLightThatIsWritten() throws Exception {
        Image plain = Renderer.render(SceneFiles.read(scene));
        Run.cli("render", scene, "-o", folder.resolve("a.pfm"), "--exposure", "-1");
        assertThat(ImageFiles.read(folder.resolve("a.pfm")).red(8, 4)).isEqualTo(plain.red(8, 4) / 2);
        Run.cli("render", scene, "-o", folder.resolve("b.pfm"), "--tone", "filmic");
        assertThat(ImageFiles.read(folder.resolve("b.pfm")).red(8, 4)).isLessThan(plain.red(8, 4)).isPositive();
        assertThat(Run.cli("render", scene, "--exposure", "1000")).matches(run -> run.code() == 2 && run.err().contains("from -100 to 100"));
        assertThat(Run.cli("render", scene, "--tone", "filmik")).matches(run -> run.code() == 2 && run.err().contains("did you mean \"filmic\""));
    }

    /** What is told must not differ from run to run, or with the number of threads. */
    @Test
    void aPictureMadeAgainHasTheSameBytes() {
        for (String ending : List.of("png", "jpg", "tif", "hdr", "exr")) {
            Run.cli("render", scene, "-o", folder.resolve("1." + ending), "--threads", "1", "--size", "70x90");
            Run.cli("render", scene, "-o", folder.resolve("2." + ending), "--threads", "3", "--size", "70x90");
            assertThat(folder.resolve("1." + ending)).hasSameBinaryContentAs(folder.resolve("2." + ending));
        }
    }

    @Test
    void aShortRenderLoadsNothingOfTheDesktop() throws Exception {
        Path log = folder.resolve("classes.txt");
        Process process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xlog:class+load:file=" + log,
                "-cp", System.getProperty("java.class.path"), Main.class.getName(), "render", scene.toString(), "-o", folder.resolve("a.png").toString(), "--quiet")
                .inheritIO().start();
        assertThat(process.waitFor()).isZero();
        assertThat(Files.readAllLines(log)).anyMatch(line -> line.contains("cz.paprsek.image.png.PngWriter"))
                .noneMatch(line -> line.contains("java.awt.") || line.contains("javax.imageio.") || line.contains("sun.awt."));
    }

    @Test
    void aPictureTellsItsCameraAndTheDigestOfTheWholeSceneAsConvertWritesIt() throws Exception {
        Path scene = Scenes.scene(folder.resolve("two.xml"), "<camera name=\"side\" position=\"5 1 0\" target=\"0 1 0\"/><point-light position=\"2 3 4\"/>"
                + "<point-light name=\"lamp\" position=\"-2 3 4\"/><sphere radius=\"1\"/>");
        Path written = folder.resolve("written.xml");
        assertThat(Run.cli("convert", scene, written).code()).isZero();
        String digest = HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(written)));
        Path picture = folder.resolve("side.png");
        assertThat(Run.cli("render", scene, "-o", picture, "--camera", "side", "--light", "lamp", "--quiet").code()).isZero();
        assertThat(Files.readString(picture, StandardCharsets.ISO_8859_1)).contains("scene sha256 " + digest).contains(" --camera side --light lamp");
        assertThat(Run.cli("render", scene, "-o", picture, "--quiet").code()).isZero();
        assertThat(Files.readString(picture, StandardCharsets.ISO_8859_1)).contains("scene sha256 " + digest).doesNotContain("--camera");
    }
}
