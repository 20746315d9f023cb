package cz.paprsek.cli.input;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.Scenes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is read is not written over, whichever command, name or link leads there. */
class OriginalsTest {
    @TempDir
    Path folder;

    private Path scene;
    private Path picture;

    @BeforeEach
    void write() throws IOException {
        scene = Scenes.ball(folder.resolve("ball.xml"));
        picture = folder.resolve("wood.png");
        assertThat(Run.cli("render", scene, "-o", picture).code()).isZero();
    }

    /** With exit code 2, a sentence that names the file, and the file as it was. */
    private static void assertSpared(Path original, String sentence, Object... words) throws IOException {
        byte[] before = Files.readAllBytes(original);
        Run run = Run.cli(words);
        assertThat(run.err()).contains(sentence + original + "; name another place\n");
        assertThat(run.code()).isEqualTo(2);
        assertThat(original).hasBinaryContent(before);
    }

    /** A scene that shows the picture. */
    private Path wood() throws IOException {
        return Files.writeString(folder.resolve("wood.xml"), Files.readString(scene).replace("</scene>", """
                <rectangle min="-1 -1" max="1 1"><material><image file="wood.png"/></material></rectangle></scene>"""));
    }

    @Test
    void aPictureIsNotRenderedOverOneThatItShows() throws IOException {
        Path wood = wood();
        Path link = Files.createSymbolicLink(folder.resolve("link.png"), picture);
        for (Object output : List.of(picture, folder + "/{name}.png", folder + "/", link)) {
            assertSpared(picture, "the picture of " + wood + " would overwrite the scene's own ", "render", wood, "-o", output);
        }
        assertSpared(picture, "would overwrite the scene's own ", "render", wood, "-o", picture, "--frames", "1-2", "--format", "gif");
        assertSpared(picture, "would overwrite the scene's own ", "render", wood, "-o", picture, "--frame", "1");
        assertThat(Run.cli("render", wood, "-o", folder.resolve("other.png")).code()).isZero();
    }

    /** With a material that shows a picture. */
    private Path model(String shown) throws IOException {
        Path model = folder.resolve("wood.obj");
        Files.writeString(model, """
                mtllib wood.mtl
                usemtl wood
                v 0 0 0
                v 1 0 0
                v 0 1 0
                vt 0 0
                f 1/1 2/1 3/1
                """);
        Files.writeString(folder.resolve("wood.mtl"), """
                newmtl wood
                map_Kd %s
                """.formatted(shown));
        return model;
    }

    @Test
    void aModelIsNotRenderedOverThePictureOfItsMaterial() throws IOException {
        Path model = model("wood.png");
        assertSpared(picture, "the picture of " + model + " would overwrite the scene's own ", "render", model, "-o", folder + "/", "--size", "4x4");
    }

    /** Beside the model, a picture that it has elsewhere might be looked for. */
    @Test
    void aModelIsRenderedAgainOverItsOwnPicture() throws IOException {
        Files.copy(picture, Files.createDirectory(folder.resolve("maps")).resolve("wood.png"));
        Path model = model("maps/wood.png");
        for (Path shown : List.of(model, Scenes.scene(folder.resolve("shown.xml"), "<mesh file='wood.obj'/>"))) {
            Run run = Run.cli("render", shown, "-o", picture, "--size", "4x4");
            assertThat(run.code()).as(run.err()).isZero();
        }
    }

    @Test
    void picturesThatAreComparedAreNoPlaceForTheirDifference() throws IOException {
        Path other = Files.copy(picture, folder.resolve("other.png"));
        assertSpared(picture, "the heat map would overwrite the picture ", "compare", picture, other, "--heatmap", picture);
        assertSpared(other, "the heat map would overwrite the picture ", "compare", picture, other, "--heatmap", folder.resolve("./other.png"));
    }

    @Test
    void aSceneIsNoPlaceForWhatIsSaidOfIt() throws IOException {
        assertSpared(scene, "the drawing would overwrite the scene ", "explain", scene, "3,3", "--svg", scene);
        assertSpared(scene, "evidence would overwrite the scene ", "grade", scene, picture, "--evidence", scene);
        Path other = Files.copy(picture, folder.resolve("other.png"));
        assertSpared(picture, "evidence would overwrite the scene's own ", "grade", wood(), other, "--evidence", picture);
    }

    @Test
    void aSceneThatAnotherIncludesIsNoPlaceForThat() throws IOException {
        Path parts = Files.writeString(folder.resolve("parts.xml"), "<scene xmlns='urn:paprsek:scene:1'><define name='post'><cylinder radius='1' height='2'/></define></scene>");
        Path whole = Scenes.scene(folder.resolve("whole.xml"), "<include file='parts.xml'/><instance of='post'/>");
        assertSpared(parts, "the new file would overwrite the scene's own ", "convert", whole, parts);
    }

    @Test
    void aDatabaseIsNotReplacedByOneOfItsScenesEvenByForce() throws IOException {
        Path database = folder.resolve("all.xml");
        assertThat(Run.cli("db", "init", database).code()).isZero();
        assertSpared(database, "the scene would overwrite the database ", "db", "extract", database, "Gears", "-o", database, "--force");
    }
}
