package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two squares side by side in one file, the left one red and the right one green: each part keeps its material, from the scene's file to POV-Ray's. */
class MeshPartsTest {
    private static final String OBJ = """
            mtllib two.mtl
            v -2 -1 0
            v 0 -1 0
            v 0 1 0
            v -2 1 0
            v 2 -1 0
            v 2 1 0
            g left
            usemtl red
            f 1 2 3
            f 1 3 4
            g right
            usemtl green
            f 2 5 6
            f 2 6 3
            """;

    @TempDir
    Path folder;

    @BeforeEach
    void writeAModel() throws IOException {
        Files.writeString(folder.resolve("two.obj"), OBJ);
        Files.writeString(folder.resolve("two.mtl"), "newmtl red\nKd 0.8 0 0\nnewmtl green\nKd 0 0.8 0\n");
    }

    private Scene scene(String mesh) throws SceneFileException {
        return SceneFiles.parse("<scene xmlns=\"urn:paprsek:scene:1\"><render width=\"40\" height=\"20\"/><ambient color=\"255 255 255\"/>"
                + "<camera position=\"0 0 9\" target=\"0 0 0\" fovy=\"20\"/>" + mesh + "</scene>");
    }

    private Image picture(String mesh) throws SceneFileException {
        Scene scene = scene(mesh);
        return Renderer.render(RenderScene.of(scene, Assets.in(folder), RenderMonitor.NONE), RenderOptions.of(scene), RenderMonitor.NONE).image();
    }

    private static String colors(Image image) {
        return color(image, 14) + " " + color(image, 26);
    }

    private static String color(Image image, int x) {
        boolean isRed = image.red(x, 10) > 0.1;
        boolean isGreen = image.green(x, 10) > 0.1;
        return isRed && isGreen ? "both" : isRed ? "red" : isGreen ? "green" : "none";
    }

    @Test
    void eachPartIsOfItsOwnMaterial() throws SceneFileException {
        assertThat(colors(picture("<mesh file=\"two.obj\"/>"))).isEqualTo("red green");
    }

    @Test
    void oneOfThemCanBeTakenByItsName() throws SceneFileException, IOException {
        String name = MeshFiles.model("two.obj", Assets.in(folder)).triangles().parts().get(0);
        assertThat(colors(picture("<mesh file=\"two.obj\" part=\"" + name + "\"/>"))).isEqualTo("red none");
    }

    @Test
    void aMaterialOfTheSceneStandsForAll() throws SceneFileException {
        assertThat(colors(picture("<mesh file=\"two.obj\"><material color=\"white\"/></mesh>"))).isEqualTo("both both");
    }

    @Test
    void povRayIsToldOfEachPart() throws SceneFileException, IOException {
        StringBuilder text = new StringBuilder();
        PovFiles.write(MeshFiles.read(scene("<mesh file=\"two.obj\"/>"), Assets.in(folder)), text);
        assertThat(text.toString()).contains("texture_list { 2", "<0, 1, 2>, 0", "<1, 4, 5>, 1");
        StringBuilder given = new StringBuilder();
        PovFiles.write(MeshFiles.read(scene("<mesh file=\"two.obj\"><material color=\"white\"/></mesh>"), Assets.in(folder)), given);
        assertThat(given.toString()).contains("face_indices").doesNotContain("texture_list");
    }
}
