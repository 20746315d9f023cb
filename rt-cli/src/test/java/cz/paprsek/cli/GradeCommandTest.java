package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class GradeCommandTest {
    private static final String SCENE = """
            <scene xmlns="urn:paprsek:scene:1"><render width="48" height="32" max-depth="3"/><background color="20 40 90"/><ambient color="60 60 60"/>
            <camera position="0 2 6" target="0 0.6 0"/><point-light position="3 5 4" intensity="0.8"/><point-light position="-4 3 2" color="255 200 120" intensity="0.4"/>
            <rectangle min="-4 -4" max="4 4" rotation="-90 0 0"><material><checkerboard columns="8" rows="8" even="230 230 230" odd="60 60 60"/></material></rectangle>
            <sphere radius="0.9" position="-1 0.9 0"><material color="220 60 40" specular="0.7" shininess="20" reflection="0.2"/></sphere>
            <block min="0 0 0" max="1 1 1" position="0.4 0 0.2" rotation="0 30 0"><material color="60 90 200"/></block></scene>
            """;

    @TempDir
    Path folder;

    private Path scene;

    @BeforeEach
    void writeTheScene() throws IOException {
        scene = Files.writeString(folder.resolve("scene.xml"), SCENE);
    }

    private Path picture(String name, String... mistakes) {
        Path picture = folder.resolve(name);
        Run run = mistakes.length == 0 ? Run.cli("render", scene, "-o", picture) : Run.cli("render", scene, "-o", picture, "--mistake", String.join(",", mistakes));
        assertThat(run.code()).as(run.err()).isZero();
        return picture;
    }

    @Test
    void aRightPictureIsRight() {
        Run run = Run.cli("grade", scene, picture("a.png"));
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.out()).startsWith("right\n").contains("0.00 % of pixels");
    }

    @Test
    void onePictureOfAFolderIsTold() throws IOException {
        Path right = picture("a.png");
        assertThat(Run.cli("grade", scene, folder).out()).startsWith(right + ": right\n");
        assertThat(Run.cli("grade", scene, folder.resolve("*.png")).out()).startsWith(right + ": right\n");
        assertThat(Run.cli("grade", scene, scene).err()).endsWith("but looks like a scene; render it, and compare the picture\n");
    }

    @Test
    void theMistakeIsToldWithItsLineAndShown() throws IOException {
        Path evidence = folder.resolve("why.png");
        Run run = Run.cli("grade", scene, picture("a.ppm", "full-fovy"), "--evidence", evidence);
        assertThat(run.code()).isEqualTo(1);
        assertThat(run.out()).startsWith("full-fovy\n").contains("should be", "tan(fovy/2)", "100.00 % of what is wrong is explained");
        Image four = ImageFiles.read(evidence);
        assertThat(four.width()).isEqualTo(96);
        assertThat(four.height()).isEqualTo(64);
    }

    @Test
    void brightnessAsTextIsEnough() {
        assertThat(Run.cli("grade", scene, picture("a.txt", "no-shadow")).out()).startsWith("no-shadow\n").contains("in brightness");
    }

    /** In one line, which is gone before anything is told. */
    @Test
    void whoWatchesIsToldHowFarItIs() {
        Path picture = picture("a.png", "no-shadow");
        Run watched = Run.watched(true, new Stop(), "grade", scene, picture);
        assertThat(watched.err()).startsWith("\r").contains("a.png: rendering the right picture").endsWith("\r").doesNotContain("\n");
        String[] drawn = watched.err().split("\r", -1);
        assertThat(drawn[drawn.length - 2]).as("the last thing that is drawn").isBlank().hasSize(drawn[drawn.length - 3].stripTrailing().length());
        Run other = Run.cli("grade", scene, picture);
        assertThat(other.err()).isEmpty();
        assertThat(watched.out()).isEqualTo(other.out()).startsWith("no-shadow\n");
    }

    @Test
    void twoMistakesAreFound() {
        assertThat(Run.cli("grade", scene, picture("a.png", "no-shadow", "gamma-missing")).out()).startsWith("no-shadow + gamma-missing\n");
    }

    @Test
    void aFolderIsATableWithOneLineForEachPicture() throws IOException {
        picture("1.png");
        picture("2.png", "flip-x");
        Files.writeString(folder.resolve("notes.md"), "not a picture");
        Run run = Run.cli("grade", scene, folder, "--csv");
        assertThat(run.code()).isEqualTo(1);
        assertThat(run.text()).startsWith("picture,verdict,mistakes,beyond,largest,mean,explained,left\n").contains("1.png\",right,,0,", "2.png\",mistaken,flip-x,").hasLineCount(3);
    }

    @Test
    void evidenceHasTheNameOfItsPictureAndIsWrittenOverNoneOfThem() throws IOException {
        Path picture = picture("a.ppm", "flip-y");
        assertThat(Run.cli("grade", scene, picture, "--evidence", folder.resolve("why") + "/").code()).isEqualTo(1);
        assertThat(folder.resolve("why/a.png")).exists();
        picture("a.png", "flip-x");
        assertThat(Run.cli("grade", scene, folder, "--evidence", folder.resolve("both") + "/").err()).contains("would both be", "a.png; grade them one by one\n");
        assertThat(Run.cli("grade", scene, folder.resolve("a.png"), "--evidence", folder + "/").err()).contains("evidence would overwrite the picture " + folder.resolve("a.png") + "; name another place\n");
        Path link = Files.createSymbolicLink(folder.resolve("link.png"), folder.resolve("a.png"));
        assertThat(Run.cli("grade", scene, folder.resolve("a.png"), "--evidence", link).err()).contains("evidence would overwrite the picture " + folder.resolve("a.png"));
    }

    @Test
    void whatNothingExplainsIsNotExplained() throws IOException {
        Image noise = new Image(48, 32);
        for (int i = 0; i < 48 * 32; i++) {
            noise.set(i % 48, i / 48, i * 7919 % 101 / 100.0, i * 104_729 % 103 / 102.0, i * 1301 % 97 / 96.0);
        }
        ImageFiles.write(noise, folder.resolve("noise.png"));
        assertThat(Run.cli("grade", scene, folder.resolve("noise.png")).out()).startsWith("unexplained\n");
    }

    @Test
    void whatThePlainTracerDoesNotKnowIsSaid() throws IOException {
        Path picture = picture("a.png", "flip-y");
        Files.writeString(scene, SCENE.replace("</scene>", "<torus major-radius=\"1\" minor-radius=\"0.2\"/></scene>"));
        Run run = Run.cli("grade", scene, picture);
        assertThat(run.code()).isEqualTo(1);
        assertThat(run.out()).startsWith("unexplained\n").contains("does not know torus");
        Run wrong = Run.cli("render", scene, "-o", folder.resolve("b.png"), "--mistake", "flip-y");
        assertThat(wrong.code()).isEqualTo(2);
        assertThat(wrong.err()).contains("does not know torus").hasLineCount(1);
    }

    @Test
    void pictureTellsItsMistakesAndAPixelItsNumbers() throws IOException {
        assertThat(Files.readString(picture("a.png", "acne", "flip-x"), StandardCharsets.ISO_8859_1)).contains("--mistake flip-x,acne");
        Run run = Run.cli("explain", scene, "24,16", "--mistake", "full-fovy");
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.out()).startsWith("full-fovy: the whole vertical angle").contains("* h            0.82843", "  d  ", "sRGB");
        assertThat(Run.cli("explain", scene, "24,16", "--mistake", "full-fovy", "--json").out()).contains("\"mistakes\":[\"full-fovy\"]", "\"different\":[\"h\",\"w\"");
        assertThat(Run.cli("explain", scene, "99,16", "--mistake", "full-fovy").err()).startsWith("paprsek: " + scene + ": pixel 99,16 must lie inside");
        assertThat(Run.cli("render", scene, "-o", folder.resolve("x.png"), "--mistake", "full-fovi").err()).contains("did you mean \"full-fovy\"?");
    }

    @Test
    void whatIsMissingIsSaidInOneLine() {
        Run run = Run.cli("grade", scene, folder.resolve("none.png"));
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.err()).isEqualTo(folder.resolve("none.png") + ": no such file\n");
        assertThat(Run.cli("grade", scene, folder, "--csv", "--json").code()).isEqualTo(2);
    }
}
