package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ConvertCommandTest {
    @TempDir
    Path folder;

    @Test
    void aSceneIsWrittenForPovRay() throws IOException {
        Path target = folder.resolve("ball.pov");
        Run run = Run.cli("convert", Scenes.ball(folder.resolve("ball.xml")), target);
        assertThat(run).isEqualTo(new Run(0, "", "", run.written()));
        assertThat(target).content().contains("#version 3.7;", "sphere { <0, 0, 0>, 1 texture { ", " translate <0, 1, 0> }");
    }

    @Test
    void whatIsNotExactIsAWarning() throws IOException {
        Path scene = Scenes.scene(folder.resolve("glass.xml"), "<sphere radius='1'><material transparency='0.5' refractive-index='1.5'/></sphere>");
        Run run = Run.cli("convert", scene, folder.resolve("glass.pov"));
        assertThat(run.code()).isZero();
        assertThat(run.err()).startsWith(scene + ": warning: object 1: where light is totally reflected").hasLineCount(1);
        assertThat(Run.cli("convert", scene, folder.resolve("glass.pov"), "-q").err()).isEmpty();
    }

    @Test
    void aSceneIsTidiedUp() throws Exception {
        Path scene = Scenes.ball(folder.resolve("ball.xml"));
        assertThat(Run.cli("convert", scene, folder.resolve("tidy.xml")).code()).isZero();
        assertThat(folder.resolve("tidy.xml")).content().isEqualTo(SceneFiles.format(SceneFiles.read(scene)));
    }

    @Test
    void mistakesAreAnsweredInOneLine() throws IOException {
        Path scene = Scenes.ball(folder.resolve("ball.xml"));
        Run unknown = Run.cli("convert", scene, folder.resolve("ball.pog"));
        assertThat(unknown.code()).isEqualTo(2);
        assertThat(unknown.err()).contains("let it end in .pov, .xml, .obj or .stl; did you mean \"pov\"?");
        Run itself = Run.cli("convert", scene, scene);
        assertThat(itself.code()).isEqualTo(2);
        assertThat(itself.err()).contains("would overwrite the scene");
        Run broken = Run.cli("convert", Scenes.broken(folder.resolve("broken.xml")), folder.resolve("b.pov"));
        assertThat(broken.code()).isEqualTo(3);
        assertThat(broken.err()).contains("did you mean \"radius\"?");
        Run nowhere = Run.cli("convert", scene, folder.resolve("no/b.pov"));
        assertThat(nowhere.code()).isEqualTo(1);
        assertThat(nowhere.err()).contains("there is no such folder").hasLineCount(1);
        Files.writeString(folder.resolve("two.xml"), SceneFiles.formatAll(List.of(Scene.EMPTY.withName("a"), Scene.EMPTY.withName("b"))));
        assertThat(Run.cli("convert", folder.resolve("two.xml"), folder.resolve("b.pov")).err()).contains("is a database of 2 scenes");
        assertThat(folder.resolve("b.pov")).doesNotExist();
    }
}
