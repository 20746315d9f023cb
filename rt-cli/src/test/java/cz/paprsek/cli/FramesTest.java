package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.value.FrameRange;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Frames of films from the command line: pictures with numbers, and films. */
class FramesTest {
    private static final String SCENE = """
            <scene xmlns="urn:paprsek:scene:1">
              <render width="24" height="16" fps="10"/>
              <background color="20 40 90"/>
              <camera name="eye" position="0 1 6" target="0 0 0"/>
              <point-light position="4 5 6"/>
              <sphere name="ball" radius="1"/>
              <sphere radius="0.3" position="{2*t} 1 1"/>
              <animate target="ball" attribute="position"><key t="0" value="-1 0 0"/><key t="1" value="1 0 0"/></animate>
              <animate target="camera:eye" attribute="position"><key t="0" value="0 1 6" ease="smooth"/><key t="2" value="3 1 6"/></animate>
            </scene>
            """;

    @TempDir
    private Path folder;
    private Path scene;

    @BeforeEach
    void writeAScene() throws IOException {
        scene = Files.writeString(folder.resolve("a.xml"), SCENE);
    }

    private Image expected(int frame) throws Exception {
        return Renderer.render(SceneFiles.frames(SceneFiles.read(scene)).apply(frame));
    }

    private static void isSame(Image image, Image other) {
        assertThat(image.toArgb()).isEqualTo(other.toArgb());
    }

    @Test
    void eachFrameIsAPictureOfItsOwn() throws Exception {
        Run run = Run.cli("render", scene, "--frames", "9-11", "-o", folder.resolve("out/pic-{frame}.png"));
        assertThat(run.code()).as(run.err()).isZero();
        try (var files = Files.list(folder.resolve("out"))) {
            assertThat(files.map(file -> file.getFileName().toString()).sorted()).containsExactly("pic-0009.png", "pic-0010.png", "pic-0011.png");
        }
        for (int frame = 9; frame <= 11; frame++) {
            isSame(ImageFiles.read(folder.resolve(String.format("out/pic-%04d.png", frame))), expected(frame));
        }
        Run.cli("render", scene, "--frames", "10", "-o", folder.resolve("alone-{frame}.png"), "--threads", "1", "-q");
        assertThat(folder.resolve("alone-0010.png")).hasSameBinaryContentAs(folder.resolve("out/pic-0010.png"));
        Run.cli("render", scene, "-o", folder.resolve("still.png"), "-q");
        isSame(ImageFiles.read(folder.resolve("still.png")), Renderer.render(SceneFiles.read(scene)));
    }

    @Test
    void aNameWithoutAPlaceForTheNumberGetsOne() {
        assertThat(Run.cli("render", scene, "--frames", "1-2", "-o", folder.resolve("pic.png")).err()).contains("the pictures go to " + folder.resolve("pic-{frame}.png"));
        assertThat(folder.resolve("pic-0001.png")).exists();
        Run.cli("render", scene, "--frames", "2", "-o", folder + "/more/", "--format", "ppm", "-q");
        assertThat(folder.resolve("more/a-0002.ppm")).exists();
    }

    @Test
    void framesAMomentApartAreByTheRate() throws Exception {
        Run.cli("render", scene, "--frames", "5", "--fps", "20", "-o", folder.resolve("p-{frame}.png"), "-q");
        isSame(ImageFiles.read(folder.resolve("p-0005.png")), expected(3));
    }

    @Test
    void aGifAndAnApngAreFilms() throws Exception {
        Run run = Run.cli("render", scene, "--frames", "1-3", "-o", folder.resolve("a.gif"));
        assertThat(run.code()).as(run.err()).isZero();
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        reader.setInput(ImageIO.createImageInputStream(folder.resolve("a.gif").toFile()));
        assertThat(reader.getNumImages(true)).isEqualTo(3);
        Run.cli("render", scene, "--frames", "2-3", "-o", folder.resolve("a.apng"), "-q");
        byte[] apng = Files.readAllBytes(folder.resolve("a.apng"));
        assertThat(new String(apng, StandardCharsets.ISO_8859_1)).contains("acTL", "fdAT", "Software", "scene sha256");
        Image first = expected(2);
        assertThat(ImageIO.read(new ByteArrayInputStream(apng)).getRGB(0, 0, 24, 16, null, 0, 24)).isEqualTo(first.toArgb());
    }

    @Test
    void aY4mGoesToStandardOutput() throws Exception {
        Run run = Run.cli("render", scene, "--frames", "1-3", "--format", "y4m", "-o", "-");
        String head = "YUV4MPEG2 W24 H16 F10:1 Ip A1:1 C444\n";
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(new String(run.bytes(), StandardCharsets.ISO_8859_1)).startsWith(head + "FRAME\n").hasSize(head.length() + 3 * (6 + 3 * 24 * 16));
        Image second = expected(2);
        int rgb = second.argb(12, 8);
        double y = 16 + 219 / 255.0 * (0.299 * (rgb >> 16 & 0xFF) + 0.587 * (rgb >> 8 & 0xFF) + 0.114 * (rgb & 0xFF));
        assertThat(run.bytes()[head.length() + 6 + 3 * 24 * 16 + 6 + 8 * 24 + 12] & 0xFF).isEqualTo((int) Math.rint(y));
    }

    @Test
    void aSecondRunGoesOnWithTheFramesThatAreThere() throws Exception {
        Path pattern = folder.resolve("r-{frame}.png");
        Run.cli("render", scene, "--frames", "1-3", "--resume", "-o", pattern, "-q");
        assertThat(folder.resolve("r-{frame}.png.resume")).doesNotExist();
        byte[] second = Files.readAllBytes(folder.resolve("r-0002.png"));
        Stop stop = new Stop();
        // Broken at frame 3, whose file cannot be replaced.
        Files.delete(folder.resolve("r-0003.png"));
        Files.createDirectories(folder.resolve("r-0003.png/in the way"));
        assertThat(Run.watched(false, stop, "render", scene, "--frames", "1-3", "--resume", "-o", pattern, "-q").code()).isNotZero();
        Files.delete(folder.resolve("r-0003.png/in the way"));
        Files.delete(folder.resolve("r-0003.png"));
        Run again = Run.cli("render", scene, "--frames", "1-3", "--resume", "-o", pattern);
        assertThat(again.err()).contains("frame 1: is there already", "frame 2: is there already").doesNotContain("frame 3: is");
        assertThat(Files.readAllBytes(folder.resolve("r-0002.png"))).isEqualTo(second);
        isSame(ImageFiles.read(folder.resolve("r-0003.png")), expected(3));
        assertThat(folder.resolve("r-{frame}.png.resume")).doesNotExist();
    }

    private List<Path> framesThatAreThere(String first, String last, Object... more) {
        Object[] words = Stream.concat(Stream.of("render", scene, "--frames", first + "-" + last, "--resume", "-o", folder.resolve("r-{frame}.png")), Stream.of(more)).toArray();
        Run run = Run.cli(words);
        assertThat(run.code()).as(run.err()).isZero();
        return run.err().lines().filter(line -> line.contains("is there already")).map(line -> folder.resolve("r-000" + line.replaceAll(".*frame (\\d).*", "$1") + ".png")).toList();
    }

    /** The first two frames are there, the third cannot be. */
    private Path ledgerOfTwo(Object... more) throws IOException {
        Files.deleteIfExists(folder.resolve("r-0003.png"));
        Path third = Files.createDirectories(folder.resolve("r-0003.png/in the way"));
        assertThat(Run.cli(Stream.concat(Stream.of("render", scene, "--frames", "1-3", "--resume", "-o", folder.resolve("r-{frame}.png"), "-q"), Stream.of(more)).toArray()).code()).isNotZero();
        return third;
    }

    private void clear(Path third) throws IOException {
        Files.delete(third);
        Files.delete(third.getParent());
    }

    @Test
    void someOfTheFramesDoNotEndTheFilm() throws Exception {
        clear(ledgerOfTwo());
        assertThat(framesThatAreThere("1", "1")).hasSize(1);
        assertThat(framesThatAreThere("1", "3")).hasSize(2);
    }

    @Test
    void whatHasBeenReplacedIsNotThere() throws Exception {
        clear(ledgerOfTwo());
        String ledger = Files.readString(folder.resolve("r-{frame}.png.resume"));
        Files.writeString(scene, SCENE.replace("20 40 90", "90 40 20"));
        clear(ledgerOfTwo());
        assertThat(Files.readString(folder.resolve("r-{frame}.png.resume"))).startsWith(ledger);
        Files.writeString(scene, SCENE);
        // Without --resume too, and one by itself.
        assertThat(Run.cli("render", scene, "--frame", "2", "-o", folder.resolve("r-{frame}.png"), "-q").code()).isZero();
        assertThat(framesThatAreThere("1", "3")).isEmpty();
        for (int frame = 1; frame <= 3; frame++) {
            isSame(ImageFiles.read(folder.resolve("r-000" + frame + ".png")), expected(frame));
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            --integrator path --samples 16 | --integrator path --samples 32
            --bits 8 | --bits 16
            --shutter 1 --camera eye | --shutter 1 --camera other
            --tone filmic | --exposure 1
            """)
    void aFrameAskedForInAnotherWayIsNotThere(String before, String now) throws Exception {
        Files.writeString(scene, SCENE.replace("<point-light", "<camera name=\"other\" position=\"1 2 6\" target=\"0 0 0\"/><point-light"));
        clear(ledgerOfTwo((Object[]) before.split(" ")));
        assertThat(framesThatAreThere("1", "3", (Object[]) now.split(" "))).isEmpty();
        clear(ledgerOfTwo((Object[]) now.split(" ")));
        assertThat(framesThatAreThere("1", "3", (Object[]) now.split(" "))).hasSize(2);
        try (var files = Files.list(folder)) {
            assertThat(files.map(file -> file.getFileName().toString())).noneMatch(name -> name.endsWith(".resume"));
        }
    }

    @Test
    void whatSomebodyHasPutInThePlaceOfAFrameIsNotThere() throws Exception {
        clear(ledgerOfTwo());
        Files.write(folder.resolve("r-0002.png"), Files.readAllBytes(folder.resolve("r-0001.png")));
        Files.setLastModifiedTime(folder.resolve("r-0002.png"), FileTime.fromMillis(1_000_000));
        assertThat(framesThatAreThere("1", "3")).containsExactly(folder.resolve("r-0001.png"));
        isSame(ImageFiles.read(folder.resolve("r-0002.png")), expected(2));
    }

    @Test
    void wrongWordsAreWrongUsageOfFramesThatAreResumedToo() {
        for (String resume : List.of("--quiet", "--resume")) {
            Run run = Run.cli("render", scene, "--frames", "1-2", resume, "--max-depth", "999", "-o", folder.resolve("r-{frame}.png"));
            assertThat(run.code()).as(run.err()).isEqualTo(ExitCode.WRONG_USAGE);
        }
    }

    @Test
    void ofPathsThatWereInterruptedAnotherSceneBeginsAnew() throws Exception {
        Path pattern = folder.resolve("r-{frame}.png");
        assertThat(Run.cli("render", scene, "--frame", "1", "--integrator", "path", "--samples", "16", "--resume", "-o", pattern, "-q").code()).isZero();
        assertThat(folder.resolve("r-0001.png.resume")).exists();
        Files.writeString(scene, SCENE.replace("20 40 90", "90 40 20"));
        assertThat(framesThatAreThere("1", "2", "--integrator", "path", "--samples", "16")).isEmpty();
        Run.cli("render", scene, "--frame", "1", "--integrator", "path", "--samples", "16", "-o", folder.resolve("plain.png"), "-q");
        assertThat(folder.resolve("r-0001.png")).hasSameBinaryContentAs(folder.resolve("plain.png"));
        // A film does not touch what is kept of a frame by itself, for more paths.
        assertThat(folder.resolve("r-0001.png.resume")).exists();
        assertThat(folder.resolve("r-0001.png.film.resume")).doesNotExist();
    }

    @Test
    void aSettingThatChangesDoesSoInFilmsToo() throws Exception {
        Files.writeString(scene, SCENE.replace("fps=\"10\"", "fps=\"10\" exposure=\"{-20*t}\""));
        Run run = Run.cli("render", scene, "--frames", "1-2", "-o", folder.resolve("a.apng"), "-q");
        assertThat(run.code()).as(run.err()).isZero();
        Run.cli("render", scene, "--frame", "2", "-o", folder.resolve("b.png"), "-q");
        Run.cli("render", scene, "--frames", "2-2", "-o", folder.resolve("b.gif"), "-q");
        Run.cli("render", scene, "--frames", "1-2", "-o", folder.resolve("a.gif"), "-q");
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        reader.setInput(ImageIO.createImageInputStream(folder.resolve("a.gif").toFile()));
        assertThat(reader.read(1).getRGB(12, 8)).isEqualTo(ImageIO.read(folder.resolve("b.gif").toFile()).getRGB(12, 8));
        Run shares = Run.cli("render", scene, "--frames", "1-2", "--shard", "1/1", "-o", folder.resolve("parts"));
        assertThat(shares.code()).isEqualTo(2);
        assertThat(shares.err()).contains("frame 2 has another <render> than frame 1");
    }

    @Test
    void partsOfFramesAreMergedIntoAFolder() throws Exception {
        assertThat(Run.cli("render", scene, "--frames", "1-2", "--shard", "1/1", "-o", folder.resolve("parts"), "-q").code()).isZero();
        Run run = Run.cli("merge", folder.resolve("parts"), "-o", folder + "/out/");
        assertThat(run.code()).as(run.err()).isZero();
        isSame(ImageFiles.read(folder.resolve("out/parts-0002.png")), expected(2));
    }

    @Test
    void numbersInNamesAreThoseOfFilesInAnyLanguage() {
        Locale usual = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag("ar-EG"));
            assertThat(new FrameRange(1, 100).padded(7)).isEqualTo("0007");
        } finally {
            Locale.setDefault(usual);
        }
    }

    @Test
    void bracesAreNoFormulas() {
        Scene read = Scene.EMPTY.withRecipe(new Scene.Recipe("{".repeat(1_000_000), Map.of(), List.of()));
        assertThat(SceneFiles.frames(read).apply(1).cameras()).isEqualTo(read.cameras());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            --frames 0-3 | frames begin with 1
            --frames 3-1 | go from the lower to the higher number
            --frames x | expected frames such as 1-100, or 7, but found 'x'
            -o a.gif | gif is a film; say of which frames, such as --frames 1-100
            -o a-{frame}.png | {frame} is the number of a frame; say which, such as --frames 1-100
            --fps 10 | --fps is for frames of a film; say which, such as --frames 1-100
            --shutter 0.5 | --shutter is for frames of a film
            --frame 0 | frames begin with 1, but here is 0
            --frame 1 --frames 1-2 | --frame is for one, --frames for several
            --frames 1-2 --shutter 2 | render shutter must be a number from 0 to 1, but is 2
            --frames 1-2 --fps 60 -o a.gif | gif shows 50 pictures a second at most, not 60
            --frames 1-2 --fps 0 -o a.gif | render fps must be a finite number above 0, but is 0
            --frames 1-2 -o a.gif --aov depth | are for pictures, and gif is a film
            --frames 1-2 -o a{frame}/p.png | {frame} can stand in the name of a picture, not in that of a folder
            --frames 1-2 --shutter 0.5 --mistake full-fovy -o a.png | while the shutter is open
            --frames 1-2 --format png -o - | pictures of frames go to files; --format y4m makes a film
            """)
    void whatCannotBeIsSaidInOneLine(String options, String sentence) {
        Run run = Run.cli((Object[]) ("render " + scene + " " + options.replace("-o a", "-o " + folder + "/a")).split(" "));
        assertThat(run.code()).as(run.err()).isEqualTo(2);
        assertThat(run.err()).contains(sentence).doesNotContain("\tat ");
    }

    @Test
    void aFrameThatMakesNoSceneIsNamed() throws Exception {
        Files.writeString(scene, SCENE.replace("radius=\"0.3\"", "radius=\"{0.25-t}\""));
        Run run = Run.cli("render", scene, "--frames", "2-5", "-o", folder.resolve("f-{frame}.png"), "-q");
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.err().lines().toList()).hasSize(1).first().asString().contains("frame 4: ").contains("radius");
        assertThat(folder.resolve("f-0003.png")).exists();
        List.of(scene).forEach(file -> assertThat(file).exists());
    }

    @Test
    void oneFrameIsAPictureAndAScene() throws Exception {
        Run.cli("render", scene, "--frames", "4-4", "-o", folder.resolve("x-{frame}.png"), "-q");
        Run run = Run.cli("render", scene, "--frame", "4", "-o", folder.resolve("one.png"), "-q");
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(folder.resolve("one.png")).hasSameBinaryContentAs(folder.resolve("x-0004.png"));
        Run.cli("convert", scene, folder.resolve("frame.xml"), "--frame", "4");
        Scene frame = SceneFiles.read(folder.resolve("frame.xml"));
        assertThat(frame).isEqualTo(SceneFiles.frames(SceneFiles.read(scene)).apply(4));
        assertThat(Run.cli("explain", scene, "12,8", "--frame", "4").out()).isEqualTo(Run.cli("explain", folder.resolve("frame.xml"), "12,8").out());
        Run.cli("convert", scene, folder.resolve("a.pov"), "--frame", "4", "-q");
        Run.cli("convert", folder.resolve("frame.xml"), folder.resolve("b.pov"), "-q");
        assertThat(Files.readString(folder.resolve("a.pov"))).isEqualTo(Files.readString(folder.resolve("b.pov")));
        assertThat(Run.cli("info", scene).out()).contains("animations   2", "position, 2 keys, t 0 to 2", "fps 10");
        assertThat(Run.cli("info", scene, "--json").out()).contains("\"target\":\"camera:eye\"");
    }

    @Test
    void whatMovesIsBlurredWhileTheShutterIsOpen() throws Exception {
        Run run = Run.cli("render", scene, "--frames", "3", "--shutter", "1", "--samples", "3", "-o", folder.resolve("b-{frame}.png"), "--threads", "2", "-q");
        assertThat(run.code()).as(run.err()).isZero();
        Run.cli("render", scene, "--frame", "3", "--shutter", "1", "--samples", "3", "-o", folder.resolve("b.png"), "--threads", "1", "-q");
        assertThat(folder.resolve("b.png")).hasSameBinaryContentAs(folder.resolve("b-0003.png"));
        Run.cli("render", scene, "--frame", "3", "--samples", "3", "-o", folder.resolve("sharp.png"), "-q");
        assertThat(ImageFiles.read(folder.resolve("b.png")).toArgb()).isNotEqualTo(ImageFiles.read(folder.resolve("sharp.png")).toArgb());
        assertThat(Run.cli("render", scene, "--frame", "3", "--shutter", "1", "--mode", "depth")).matches(wrong -> wrong.code() == 2 && wrong.err().contains("while the shutter is open"));
    }

    @Test
    void onlyWhatChangesIsTheNextFramesOwn() throws Exception {
        Scene read = SceneFiles.read(scene);
        Scene first = SceneFiles.frames(read).apply(1);
        Scene second = SceneFiles.frames(read).apply(2);
        assertThat(second.lights().get(0)).isEqualTo(first.lights().get(0));
        assertThat(second.objectsOtherThanIn(first)).containsExactly(0, 1);
    }
}
