package cz.paprsek.resume;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SceneDigestTest {
    private static final String INCLUDED = "<scene xmlns=\"urn:paprsek:scene:1\"><camera position=\"0 0 9\" target=\"0 0 0\"/><param name=\"size\" value=\"1\"/></scene>";

    @TempDir
    private Path folder;

    private String digest(String size, String included, String... more) throws Exception {
        Files.writeString(folder.resolve("part.xml"), included);
        Path file = Files.writeString(folder.resolve("a.xml"), "<scene xmlns=\"urn:paprsek:scene:1\"><include file=\"part.xml\"/><camera position=\"0 0 9\" target=\"0 0 0\"/>"
                + "<repeat count=\"{1+t}\"><sphere radius=\"" + size + "\"/></repeat></scene>");
        Scene scene = SceneFiles.read(file);
        return SceneDigest.of(scene, Assets.none(), more);
    }

    @Test
    void allThatAFrameCanShowMakesADifference() throws Exception {
        String one = digest("{size}", INCLUDED);
        assertThat(one).matches("[0-9a-f]{64}").isEqualTo(digest("{size}", INCLUDED));
        assertThat(digest("{size*2}", INCLUDED)).isNotEqualTo(one);
        // Not at the beginning, when the scene is the same.
        assertThat(digest("{size}", INCLUDED.replace("\"1\"", "\"{1+t}\""))).isNotEqualTo(one);
        assertThat(digest("{size}", INCLUDED, "ab", "c")).isNotEqualTo(one).isNotEqualTo(digest("{size}", INCLUDED, "a", "bc"));
    }
}
