package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.ImageFiles;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The pictures that document how a picture lies on each shape are as the renderer makes them. */
class MapPicturesTest {
    private static final Path FOLDER = Path.of("../docs/maps");

    static List<Scene> scenes() throws Exception {
        return SceneFiles.readAll(FOLDER.resolve("maps.xml"));
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void thePictureIsUpToDate(Scene scene) throws Exception {
        Path file = FOLDER.resolve(scene.name() + ".png");
        assertThat(Renderer.render(RenderScene.of(scene), RenderOptions.of(scene).withMode(RenderMode.UV), RenderMonitor.NONE).image().toArgb())
                .as("render docs/maps/maps.xml --mode uv -o 'docs/maps/{name}.png'").isEqualTo(ImageFiles.read(file).toArgb());
        assertThat(Files.readString(FOLDER.resolve("maps.md"))).contains("(" + file.getFileName() + ")");
    }
}
