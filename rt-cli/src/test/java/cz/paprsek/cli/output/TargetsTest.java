package cz.paprsek.cli.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import cz.paprsek.cli.input.SceneSource;
import cz.paprsek.cli.process.WrongUsage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TargetsTest {
    @TempDir
    Path folder;

    private static List<String> shown(Optional<String> output, String... scenes) {
        return new Targets(output, Optional.empty(), false).of(Arrays.stream(scenes).map(Path::of).map(file -> SceneSource.of(file, true)).toList())
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
                .isInstanceOf(WrongUsage.class).hasMessageContaining("would both be rendered to").hasMessageEndingWith("; -o '" + folder + "/{dir}/{name}.png' keeps them apart");
        assertThatThrownBy(() -> shown(Optional.empty(), "x/a.xml", "y/a.xml")).hasMessageEndingWith(" to a.png; -o '{dir}/{name}.png' keeps them apart");
        assertThatThrownBy(() -> shown(Optional.of(folder + "/{name}.exr"), "x/a.xml", "y/a.xml"))
                .hasMessageEndingWith("; put {dir} into the output, which stands for the scene's folder");
        assertThatThrownBy(() -> shown(Optional.of(folder + "/{dir}.png"), "x/a.xml", "x/b.xml"))
                .hasMessageEndingWith("; put {name} into the output, which stands for the scene's name");
        assertThatThrownBy(() -> shown(Optional.empty(), "x/a.xml", "x/a.scene")).hasMessageEndingWith("; render them one by one");
        assertThatThrownBy(() -> shown(Optional.of("-"), "x/a.xml", "y/b.xml")).isInstanceOf(WrongUsage.class);
    }

    @Test
    void aSceneIsNeverOverwrittenByItsPicture() {
        assertThatThrownBy(() -> shown(Optional.of(folder + "/a.txt"), folder + "/a.txt"))
                .isInstanceOf(WrongUsage.class).hasMessageContaining("would overwrite the scene");
    }

    @Test
    void aFileWithoutKnownEndingIsRefusedBeforeRendering() {
        assertThatThrownBy(() -> shown(Optional.of(folder + "/a.gif"), "a.xml")).hasMessageContaining("png, jpg");
    }

    @Test
    void theDirectoryOfAFileIsMadeToo() {
        shown(Optional.of(folder + "/o/p/x.png"), "a.xml");
        assertThat(folder.resolve("o/p")).isEmptyDirectory();
    }

    @Test
    void aFileInTheWayOfADirectoryIsTold() throws IOException {
        Files.writeString(folder.resolve("o"), "");
        assertThatThrownBy(() -> shown(Optional.of(folder + "/o/x.png"), "a.xml"))
                .isInstanceOf(WrongUsage.class).hasMessageContaining("is not a directory");
    }

    @Test
    void aDirectoryThatTakesNoFilesIsToldBeforeRendering() {
        assumeTrue(Files.isDirectory(Path.of("/proc/self")), "a directory that nobody may write to");
        assertThatThrownBy(() -> shown(Optional.of("/proc/self/x.png"), "a.xml"))
                .isInstanceOf(WrongUsage.class).hasMessageContaining("cannot write the picture: /proc/self/x.png");
        assertThatThrownBy(() -> shown(Optional.of("/proc/o/x.png"), "a.xml"))
                .isInstanceOf(WrongUsage.class).hasMessageContaining("cannot make the directory /proc/o");
    }

    @Test
    void theDirectoryOfTheSceneMayStandInAPattern() {
        assertThat(shown(Optional.of(folder + "/{dir}/{name}-small.png"), "scenes/a.xml", "b.xml"))
                .containsExactly(slashed(folder) + "/scenes/a-small.png", slashed(folder) + "/./b-small.png");
    }

    @ParameterizedTest
    @CsvSource({"{nme}.png, {nme}; did you mean \"{name}\"?", "o/{scene}.png, there is no {scene}; there are {name} and {dir}"})
    void anUnknownWordInBracesIsATypo(String output, String sentence) {
        assertThatThrownBy(() -> shown(Optional.of(output), "a.xml")).isInstanceOf(WrongUsage.class).hasMessageContaining(sentence);
    }

    @Test
    void bracesAroundOtherThingsAreLetters() {
        assertThat(shown(Optional.of(folder + "/{a b}{}.png"), "a.xml")).singleElement().asString().endsWith("{a b}{}.png");
    }

    @Test
    void aNameMayHave255BytesAndNoMore() {
        assertThat(shown(Optional.of(folder + "/" + "x".repeat(251) + ".png"), "a.xml")).hasSize(1);
        assertThatThrownBy(() -> shown(Optional.of(folder + "/" + "x".repeat(252) + ".png"), "a.xml"))
                .isInstanceOf(WrongUsage.class).hasMessageContaining("too long");
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void twoNamesOfOneFileAreOneFile() throws IOException {
        Path scene = Files.writeString(folder.resolve("a.png"), "<scene/>");
        Path link = Files.createSymbolicLink(folder.resolve("b.png"), scene);
        assertThatThrownBy(() -> shown(Optional.of(link.toString()), scene.toString())).hasMessageContaining("would overwrite the scene");
    }

    @Test
    void anEmptyNameIsRefused() {
        assertThatThrownBy(() -> shown(Optional.of(""), "a.xml")).isInstanceOf(WrongUsage.class).hasMessageContaining("empty name");
    }

    private static String slashed(Path path) {
        return path.toString().replace('\\', '/');
    }
}
