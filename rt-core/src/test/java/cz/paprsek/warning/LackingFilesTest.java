package cz.paprsek.warning;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.MeshFiles;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Scenes whose files are not there, or not what they must be: whoever looks for what is suspicious finds what can be found without them. */
class LackingFilesTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {
        "<mesh file='none.stl'/>", "<difference><mesh file='none.stl'/><sphere radius='1'/></difference>",
        "<difference><mesh file='open.obj'/><sphere radius='1'/></difference>", "<union><union><mesh file='open.obj'/></union><sphere radius='1'/></union>",
        "<text value='a' font='none.ttf'/>", "<height-field file='none.png'/>"
    })
    void whatCanBeFoundIsFound(String body) throws IOException, SceneFileException {
        Files.writeString(folder.resolve("open.obj"), "v 0 0 0\nv 3 0 0\nv 0 4 0\nf 1 2 3\n");
        Scene scene = SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 9' target='0 0 0'/>" + body + "</scene>");
        Scene read = MeshFiles.read(scene, Assets.in(folder), (place, problem) -> { });
        assertThat(SceneWarnings.of(read)).extracting(SceneWarning::kind).containsExactly("dark");
    }
}
