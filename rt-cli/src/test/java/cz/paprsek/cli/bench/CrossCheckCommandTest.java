package cz.paprsek.cli.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.Scenes;
import cz.paprsek.image.ImageFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CrossCheckCommandTest {
    private static final Path SUITE = Path.of("../rt-core/src/test/resources/crosscheck");

    @TempDir
    Path folder;

    @Test
    void theTableSaysHowFarThePicturesAreApart() {
        Run run = Run.cli("crosscheck", "--recorded", SUITE.resolve("spher*.xml"), SUITE.resolve("combined-table.xml"));
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.out().lines()).hasSize(4).first().asString().startsWith("POV-Ray 3.7, recorded");
        assertThat(run.out()).containsPattern("sphere.xml +0\\.5 +0\\.\\d+ +0  the same\n");
    }

    @Test
    void aDifferenceIsToldByTheExitCodeAndShown() throws IOException {
        Path scene = folder.resolve("sphere.xml");
        Files.writeString(scene, Files.readString(SUITE.resolve("sphere.xml")).replace("radius=\"0.9\"", "radius=\"0.8\""));
        Files.copy(SUITE.resolve("sphere.png"), folder.resolve("sphere.png"));
        Run run = Run.cli("crosscheck", "--recorded", scene, "--heatmaps", folder);
        assertThat(run.code()).isEqualTo(1);
        assertThat(run.out()).contains("DIFFERENT");
        assertThat(ImageFiles.read(folder.resolve("sphere.xml.png")).width()).isEqualTo(64);
    }

    @Test
    void aSceneWithoutARecordingIsSaidToHaveNone() throws IOException {
        Run run = Run.cli("crosscheck", "--recorded", Scenes.ball(folder.resolve("ball.xml")), Scenes.broken(folder.resolve("broken.xml")));
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.err()).contains("there is no recorded picture " + folder.resolve("ball.png"), "did you mean \"radius\"?");
        assertThat(Run.cli("crosscheck", "--recorded", "--record", folder.resolve("ball.xml")).code()).isEqualTo(2);
    }

    @Test
    void whereItIsInstalledPovRayRunsAndIsRecorded() throws IOException {
        Run skipped = Run.cli("crosscheck", "--recorded", SUITE.resolve("sphere.xml"));
        assertThat(skipped.code()).isZero();
        assumeTrue(PovRay.installed().isPresent(), "povray is not installed");
        Path ball = Scenes.ball(folder.resolve("ball.xml"));
        Run live = Run.cli("crosscheck", ball, "--record");
        assertThat(live.code()).as(live.out() + live.err()).isZero();
        assertThat(live.out()).contains("run now", "ball.xml", "the same");
        assertThat(folder.resolve("ball.png")).isNotEmptyFile();
        assertThat(Run.cli("crosscheck", ball, "--recorded").code()).isZero();
        assertThat(Run.cli("crosscheck", ball, "--size", "20x10").code()).isZero();
        Run frame = Run.cli("crosscheck", "../scenes/carousel.xml", "--frame", 30, "--size", "48x36");
        assertThat(frame.code()).as(frame.out() + frame.err()).isZero();
        assertThat(Run.cli("crosscheck", ball, "--record", "--frame", 2).err()).contains("--record is of scenes as they are written");
    }

    /** Each has a row, and a map, of its own. */
    @Test
    void theScenesOfADatabaseAreToldApart() throws IOException {
        Path database = folder.resolve("two.xml");
        for (String name : new String[] {"red", "a/b"}) {
            assertThat(Run.cli("db", "add", database, Scenes.ball(folder.resolve("ball.xml")), "--name", name).code()).isZero();
        }
        assertThat(Run.cli("crosscheck", "--recorded", database).err()).contains("two.xml is a database of 2 scenes, and a recorded picture lies beside a file of one");
        assumeTrue(PovRay.installed().isPresent(), "povray is not installed");
        Run run = Run.cli("crosscheck", database, "--size", "32x24", "--tolerance", 0, "--at-most", 0, "--heatmaps", folder.resolve("maps"));
        assertThat(run.out()).containsPattern("two\\.xml: red +[0-9]").containsPattern("two\\.xml: a/b +[0-9]");
        assertThat(folder.resolve("maps").toFile().list()).containsExactlyInAnyOrder("two.xml- red.png", "two.xml- a-b.png");
    }

    /** POV-Ray finds a picture only by letters of ASCII: it is told, and given, another name. */
    @Test
    void povRayFindsPicturesWhateverTheirNames() throws IOException {
        Run.cli("render", Scenes.ball(folder.resolve("ball.xml")), "-o", folder.resolve("kůra \"1\".png"));
        Path scene = Scenes.scene(folder.resolve("kůra.xml"), """
                <ambient color="white"/><rectangle min="-3 -3" max="3 3"><material><image file="kůra &quot;1&quot;.png" filter="bilinear"/></material></rectangle>""");
        Run convert = Run.cli("convert", scene, folder.resolve("pov/kůra.pov"));
        assertThat(convert.code()).as(convert.err()).isZero();
        assertThat(folder.resolve("pov/kůra.pov")).content().contains("png \"k_16fra \\\"1\\\".png\"");
        assertThat(folder.resolve("pov/k_16fra \"1\".png")).hasSameBinaryContentAs(folder.resolve("kůra \"1\".png"));
        assumeTrue(PovRay.installed().isPresent(), "povray is not installed");
        Run live = Run.cli("crosscheck", scene);
        assertThat(live.code()).as(live.out() + live.err()).isZero();
    }

    @Test
    void povRayIsGivenThePicturesOfModels() throws IOException {
        assumeTrue(PovRay.installed().isPresent(), "povray is not installed");
        Run.cli("render", Scenes.ball(folder.resolve("ball.xml")), "-o", folder.resolve("bark.png"));
        Files.writeString(folder.resolve("bark.mtl"), """
                newmtl bark
                map_Kd bark.png
                """);
        Files.writeString(folder.resolve("bark.obj"), """
                mtllib bark.mtl
                usemtl bark
                v -1 0 0
                v 1 0 0
                v 0 2 0
                vt 0 0
                vt 1 0
                vt 0 1
                f 1/1 2/2 3/3
                """);
        Run live = Run.cli("crosscheck", Scenes.scene(folder.resolve("model.xml"), "<ambient color=\"white\"/><mesh file=\"bark.obj\"/>"), "--at-most", "100%");
        assertThat(live.code()).as(live.out() + live.err()).isZero();
    }
}
