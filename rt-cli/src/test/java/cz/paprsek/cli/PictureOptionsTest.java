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
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

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

    /** One that is compressed beside the rays, and one that is not: as long as there are several stripes. */
    @ParameterizedTest
    @ValueSource(strings = {"--bits 8", "--bits 16", "--transparent", "--region 5,7,600,500", "--mode rays", "--exposure 1"})
    void aFileHasTheBytesThatGoToStandardOutput(String words) throws IOException {
        Function<Object, Run> render = output -> Run.cli(Stream.concat(Stream.of("render", scene, "--size", "700x603", "--format", "png", "--quiet", "-o", output), Stream.of(words.split(" "))).toArray());
        Run run = render.apply("-");
        assertThat(run.err()).isEmpty();
        assertThat(render.apply(folder.resolve("a.png")).code()).isZero();
        assertThat(Files.readAllBytes(folder.resolve("a.png"))).isEqualTo(run.bytes());
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
    void aShortRenderLoadsNothingOfTheDesktopNorOfPicocli() throws Exception {
        Path log = folder.resolve("classes.txt");
        Process process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xlog:class+load:file=" + log,
                "-cp", System.getProperty("java.class.path"), Main.class.getName(), "render", scene.toString(), "-o", folder.resolve("a.png").toString(), "--quiet")
                .inheritIO().start();
        assertThat(process.waitFor()).isZero();
        assertThat(Files.readAllLines(log)).anyMatch(line -> line.contains("cz.paprsek.image.png.PngWriter"))
                .noneMatch(line -> line.contains(" picocli.CommandLine source") || line.contains("java.awt.") || line.contains("javax.imageio.") || line.contains("sun.awt."));
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

    /** What the file wishes is what the option does, and the option has the last word. */
    @Test
    void aSceneMayAskForItsExposureAndTone() throws Exception {
        Path wishing = folder.resolve("wishing.xml");
        Files.writeString(wishing, Files.readString(scene).replace("height=\"8\"", "height=\"8\" exposure=\"-1.5\" tone=\"filmic\""));
        Run.cli("render", wishing, "-o", folder.resolve("a.pfm"));
        Run.cli("render", scene, "-o", folder.resolve("b.pfm"), "--exposure", "-1.5", "--tone", "filmic");
        assertThat(folder.resolve("a.pfm")).hasSameBinaryContentAs(folder.resolve("b.pfm"));
        Run.cli("render", wishing, "-o", folder.resolve("c.pfm"), "--exposure", "0", "--tone", "none");
        Run.cli("render", scene, "-o", folder.resolve("d.pfm"));
        assertThat(folder.resolve("c.pfm")).hasSameBinaryContentAs(folder.resolve("d.pfm"));
        Run.cli("render", wishing, "-o", folder.resolve("e.pfm"), "--mode", "normals");
        Run.cli("render", scene, "-o", folder.resolve("f.pfm"), "--mode", "normals");
        assertThat(folder.resolve("e.pfm")).as("normals are no light").hasSameBinaryContentAs(folder.resolve("f.pfm"));
        Run.cli("render", wishing, "-o", folder.resolve("a.png"));
        assertThat(Files.readString(folder.resolve("a.png"), StandardCharsets.ISO_8859_1)).contains(" --exposure -1.5 --tone filmic");
        assertThat(Run.cli("info", wishing).out()).contains(", exposure -1.5, tone filmic");
        assertThat(Run.cli("info", wishing, "--json").out()).contains("\"exposure\":-1.5,\"tone\":\"filmic\"");
        assertThat(Run.cli("explain", wishing, "8,4").out()).contains(", with an exposure of -1.5 and tone filmic = ");
        assertThat(Run.cli("explain", scene, "8,4", "--exposure", "1", "--json").out()).contains("\"exposure\":1,\"tone\":\"none\",\"shown\":");
        assertThat(Run.cli("convert", wishing, folder.resolve("a.pov")).err()).contains("POV-Ray knows neither exposure nor tone");
        assertThat(Run.cli("render", scene, "--mode", "depth", "--exposure", "1")).matches(run -> run.code() == 2 && run.err().contains("--mode depth does not show"));
    }

    @Test
    void aFileThatAsksWronglyIsToldWhereAndWhat() throws Exception {
        Path wrong = Files.writeString(folder.resolve("wrong.xml"), Files.readString(scene).replace("height=\"8\"", "height=\"8\" exposure=\"bright\" tone=\"filmik\""));
        Run run = Run.cli("validate", wrong);
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.err()).contains("exposure", "a number of stops from -100 to 100", "tone must be none or filmic, but is \"filmik\"");
    }

    @Test
    void aTransparentPictureHasNothingWhereNothingIsHit() throws Exception {
        Path bright = Files.writeString(folder.resolve("bright.xml"), Files.readString(scene).replace("<camera", "<background color=\"white\"/><camera"));
        assertThat(Run.cli("render", bright, "-o", folder.resolve("a.png"), "--transparent", "--samples", "4", "--bits", "16").code()).isZero();
        java.awt.image.BufferedImage png = javax.imageio.ImageIO.read(folder.resolve("a.png").toFile());
        assertThat(png.getRGB(0, 0)).isZero();
        assertThat(png.getRGB(8, 4) >>> 24).isEqualTo(255);
        assertThat(Files.readString(folder.resolve("a.png"), StandardCharsets.ISO_8859_1)).contains(" --transparent");
        assertThat(Run.cli("render", bright, "-o", folder.resolve("a.exr"), "--transparent").code()).isZero();
        assertThat(ImageFiles.readLayers(folder.resolve("a.exr")).at("A", 0, 0)).isZero();
        assertThat(Run.cli("render", bright, "-o", folder.resolve("a.jpg"), "--transparent"))
                .matches(run -> run.code() == 2 && run.err().contains("jpg has no opacity; --transparent needs a picture in png or exr"));
    }

    @Test
    void layersAreInOneFileWithTheirPicture() throws Exception {
        Path file = folder.resolve("a.exr");
        assertThat(Run.cli("render", scene, "-o", file, "--aov", "normal,depth", "--aov", "object", "--uncompressed").code()).isZero();
        assertThat(ImageFiles.readLayers(file).names()).containsExactly("B", "G", "R", "depth.Z", "normal.X", "normal.Y", "normal.Z", "object.ID");
        assertThat(ImageFiles.readLayers(file).at("depth.Z", 8, 4)).isBetween(4f, 4.1f);
        assertThat(Run.cli("render", scene, "-o", folder.resolve("plain.exr")).code()).isZero();
        assertThat(Run.cli("compare", file, folder.resolve("plain.exr"), "--tolerance", "0").code()).isZero();
        Run piped = Run.cli("render", scene, "--format", "exr", "--aov", "normal,depth", "--aov", "object", "--uncompressed", "-o", "-", "--quiet");
        assertThat(piped.bytes()).isEqualTo(Files.readAllBytes(file));
        assertThat(Run.cli("render", scene, "-o", folder.resolve("a.png"), "--aov", "depth")).matches(run -> run.code() == 2 && run.err().contains("png has no layers; --aov needs a picture in exr"));
        assertThat(Run.cli("render", scene, "-o", file, "--aov", "normals")).matches(run -> run.code() == 2 && run.err().contains("did you mean \"normal\""));
        assertThat(Run.cli("render", scene, "-o", file, "--aov", "depth,depth")).matches(run -> run.code() == 2 && run.err().contains("once"));
        assertThat(Run.cli("render", scene, "-o", file, "--aov", "depth", "--mode", "depth")).matches(run -> run.code() == 2 && run.err().contains("pictures of light"));
        assertThat(Run.cli("render", scene, "-o", folder.resolve("a.png"), "--uncompressed")).matches(run -> run.code() == 2 && run.err().contains("--uncompressed is for exr"));
    }
}
