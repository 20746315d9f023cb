package cz.paprsek.cli.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.cli.input.SceneSource;
import cz.paprsek.cli.process.WrongUsage;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TargetsTest {
    @TempDir
    Path folder;

    private static List<String> shown(Optional<String> output, String... scenes) {
        return new Targets(output, Optional.empty(), false).of(Arrays.stream(scenes).map(Path::of).map(SceneSource::of).toList())
                .stream().map(target -> target.shown().replace('\\', '/')).toList();
    }

    @Test
    void withoutOutputThePictureIsInTheWorkingDirectory() {
        assertThat(shown(Optional.empty(), "scenes/a.xml", "b.scene.xml")).containsExactly("a.png", "b.scene.png");
    }

    @Test
    void anExistingDirectoryTakesOneFileForEachScene() {
        assertThat(shown(Optional.of(folder.toString()), "x/a.xml", "y/b.xml"))
                .allMatch(file -> file.startsWith(folder.toString().replace('\\', '/')))
                .extracting(file -> Path.of(file).getFileName().toString()).containsExactly("a.png", "b.png");
    }

    @Test
    void directoriesOfAPatternAreMade() {
        shown(Optional.of(folder + "/new/{name}/small.jpg"), "a.xml");
        assertThat(folder.resolve("new/a")).isDirectory();
    }

    @Test
    void twoScenesNeverShareAFile() {
        assertThatThrownBy(() -> shown(Optional.of(folder + "/a.png"), "a.xml", "b.xml"))
                .isInstanceOf(WrongUsage.class).hasMessageContaining("2 scenes do not fit into");
        assertThatThrownBy(() -> shown(Optional.of(folder + "/"), "x/a.xml", "y/a.xml"))
                .isInstanceOf(WrongUsage.class).hasMessageContaining("would both be rendered to");
        assertThatThrownBy(() -> shown(Optional.of("-"), "x/a.xml", "y/b.xml")).isInstanceOf(WrongUsage.class);
    }

    @Test
    void aSceneIsNeverOverwrittenByItsPicture() {
        assertThatThrownBy(() -> shown(Optional.of(folder + "/a.txt"), folder + "/a.txt"))
                .isInstanceOf(WrongUsage.class).hasMessageContaining("would overwrite the scene");
    }

    @Test
    void aFileWithoutKnownEndingOrDirectoryIsRefusedBeforeRendering() {
        assertThatThrownBy(() -> shown(Optional.of(folder + "/a.gif"), "a.xml")).hasMessageContaining("png, jpg");
        assertThatThrownBy(() -> shown(Optional.of(folder + "/none/a.png"), "a.xml")).hasMessageContaining("there is no directory");
    }
}
