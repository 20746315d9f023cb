package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code --camera}, wherever a picture or a pixel of a scene is asked for. */
class CameraOptionTest {
    @TempDir
    Path folder;

    private Path file;
    private Scene scene;

    @BeforeEach
    void writeASceneOfThreeCameras() throws Exception {
        file = folder.resolve("three.xml");
        Files.writeString(file, "<scene xmlns=\"urn:paprsek:scene:1\"><render width=\"24\" height=\"16\"/><point-light position=\"3 4 5\"/>"
                + "<camera name=\"front\" position=\"0 0 5\" target=\"0 0 0\"/>"
                + "<camera name=\"plan\" position=\"0 5 0\" direction=\"0 -1 0\" projection=\"orthographic\" height=\"4\"/>"
                + "<camera position=\"0 0 5\" target=\"0 0 0\" projection=\"fisheye\"/>"
                + "<block min=\"-1 -1 -1\" max=\"1 1 1\"/><sphere radius=\"0.5\" position=\"1 1 1\"><material color=\"red\"/></sphere></scene>");
        scene = SceneFiles.read(file);
    }

    @Test
    void aPictureIsTakenByTheCameraOfThatNameOrNumber() throws IOException {
        for (String camera : new String[] {"plan", "3", "1"}) {
            Path picture = folder.resolve(camera + ".pfm");
            assertThat(Run.cli("render", file, "-o", picture, "--camera", camera, "-q").code()).isZero();
            assertThat(ImageFiles.read(picture).toArgb()).isEqualTo(Renderer.render(scene.through(camera)).toArgb());
        }
        assertThat(folder.resolve("plan.pfm")).satisfies(plan -> assertThat(Files.readAllBytes(plan)).isNotEqualTo(Files.readAllBytes(folder.resolve("1.pfm"))));
    }

    @Test
    void aCameraThatIsNotThereIsToldWithThoseThatAre() {
        Run run = Run.cli("render", file, "-o", folder.resolve("a.png"), "--camera", "plam");
        assertThat(run.code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(run.err()).contains(file + ": there is no camera \"plam\"; did you mean \"plan\"?; the scene has 3 cameras: front, plan");
        assertThat(Run.cli("explain", file, "1,1", "--camera", "4").err()).contains("there is no camera \"4\"; the scene has 3 cameras: front, plan");
        assertThat(Run.cli("convert", file, folder.resolve("a.pov"), "--camera", "").code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(folder.resolve("a.png")).doesNotExist();
    }

    @Test
    void aPixelIsExplainedAndASceneConvertedAsThatCameraSeesIt() throws Exception {
        assertThat(Run.cli("explain", file, "12,8", "--camera", "plan", "--color", "never").out()).contains("block").containsPattern("distance +t += 4\\n");
        assertThat(Run.cli("explain", file, "0,0", "--camera", "3", "--color", "never").out()).contains("outside");
        Path pov = folder.resolve("a.pov");
        assertThat(Run.cli("convert", file, pov, "--camera", "plan").code()).isZero();
        assertThat(Files.readString(pov)).contains("camera { orthographic location");
        Path xml = folder.resolve("plan.xml");
        assertThat(Run.cli("convert", file, xml, "--camera", "plan").code()).isZero();
        assertThat(SceneFiles.read(xml)).isEqualTo(scene.through("plan"));
    }

    @Test
    void allAreListed() {
        assertThat(Run.cli("info", file).out().replaceAll(" +", " ")).contains("cameras 3\n").contains("front position 0 0 5, target 0 0 0, up 0 1 0, fovy 45")
                .contains("plan position 0 5 0, direction 0 -1 0, up 0 0 -1, projection orthographic, height 4").contains("- position 0 0 5, target 0 0 0, up 0 1 0, projection fisheye, angle 180");
        assertThat(Run.cli("info", file, "--json").out()).contains("\"cameras\":[{\"name\":\"front\",", "\"projection\":\"fisheye\"", "\"height\":4}");
    }

    @Test
    void aLensOfFewRaysIsWarnedOf() throws IOException {
        Path blurred = folder.resolve("blurred.xml");
        Files.writeString(blurred, Files.readString(file).replace("target=\"0 0 0\"/><camera name=\"plan\"", "target=\"0 0 0\" aperture=\"0.1\"/><camera name=\"plan\""));
        assertThat(Run.cli("validate", blurred).out()).contains("a camera's lens has an aperture, but a pixel has one ray; blur will be grain: give <render> samples=\"4\" or more");
        assertThat(Run.cli("convert", blurred, folder.resolve("b.pov")).err()).contains("is given the middle of it, and all is sharp");
    }
}
