package cz.paprsek.cli.input;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.Scenes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ForeignTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "m.fbx   | Kaydara       | this is an FBX model, which is not read; export it as glTF, OBJ, STL or PLY",
        "m.scad  | cube(1);      | this is an OpenSCAD program; what it makes is read: openscad -o model.csg model.scad",
        "m.pov   | #include \"x\" | this is a scene of POV-Ray's, which is written here (paprsek convert) but not read",
        "m.blend | BLENDER-v279   | this is a file of Blender's",
        "m.dae   | <COLLADA/>     | this is a COLLADA model",
        "m.svg   | <svg/>         | this is a drawing, not a scene",
        "m.gz    | packed         | this is a packed file; unpack it first",
    })
    void filesOfOthersAreCalledWhatTheyAre(String name, String content, String sentence) throws IOException {
        Path file = Files.writeString(folder.resolve(name), content);
        for (Run run : new Run[] {Run.cli("render", file, "-o", folder + "/"), Run.cli("validate", file), Run.cli("info", file),
                Run.cli("convert", file, folder.resolve("x.xml")), Run.cli("explain", file, "1,1"), Run.cli("db", "list", file)}) {
            assertThat(run.code()).isEqualTo(3);
            assertThat(run.err()).startsWith(file + ": " + sentence).hasLineCount(1);
        }
    }

    @Test
    void aPictureAmongTheScenesIsAskedAbout() throws IOException {
        Path scene = Scenes.ball(folder.resolve("s.xml"));
        Path picture = Files.writeString(folder.resolve("out.png"), "\u0089PNG");
        Run run = Run.cli("render", scene, picture);
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains("is " + picture + " meant as the output? say -o " + picture);
        assertThat(picture).hasContent("\u0089PNG");
    }

    @Test
    void aSceneMayHaveAnyName() throws IOException {
        Path scene = Scenes.ball(folder.resolve("s.txt"));
        assertThat(Run.cli("render", scene, "-o", folder.resolve("s.png")).code()).isZero();
    }
}
