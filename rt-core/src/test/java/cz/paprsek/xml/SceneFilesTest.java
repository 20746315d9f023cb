package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class SceneFilesTest {
    @TempDir
    Path folder;

    static Stream<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("../scenes"))) {
            return files.filter(file -> file.toString().endsWith(".xml")).sorted().toList().stream();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everyShippedFileIsWrittenAsItWasRead(Path file) throws Exception {
        List<Scene> scenes = SceneFiles.readAll(file);
        String text = SceneFiles.isDatabase(file) ? SceneFiles.formatAll(scenes) : SceneFiles.format(scenes.get(0));
        assertThat(text).isEqualTo(Files.readString(file));
        assertThat(WayIn.all(text).contents().orElseThrow().scenes()).isEqualTo(scenes);
        assertThat(SceneFiles.readAll(Files.writeString(folder.resolve("again.xml"), text))).isEqualTo(scenes);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void whatIsWrittenReadsBackEqual(long seed) throws Exception {
        Scene scene = RandomScenes.of(seed);
        String text = SceneFiles.format(scene);
        Scene read = WayIn.all(text).scene();
        assertThat(read).isEqualTo(scene);
        assertThat(SceneFiles.format(read)).isEqualTo(text);
    }

    /** Of neighbours with the same material its text is kept. */
    @Test
    void aMaterialIsWrittenAsWellBehindTheSameAsByItself() throws Exception {
        Material plain = new Material(new Pattern.Plain(new Rgb(1, 2, 3)), 0.5, 0, 30, 0.25, 0, 1);
        Material patterned = new Material(new Pattern.Checker(new Vec3(1, 2, 3), Vec3.ZERO, Rgb.WHITE, Rgb.BLACK, Pattern.Lay.NONE), 0.5, 0, 30, 0.25, 0, 1);
        for (Material material : List.of(plain, patterned)) {
            SceneObject ball = SceneObject.of(new Sphere(1)).madeOf(material);
            SceneObject both = SceneObject.of(Csg.union(Operand.of(new Sphere(1)).madeOf(material), Operand.of(new Sphere(2)).madeOf(material))).madeOf(material);
            List<SceneObject> all = List.of(ball, ball, both, ball, both, SceneObject.of(new Sphere(1)).madeOf(plain), ball);
            Scene scene = Scene.EMPTY;
            StringBuilder apart = new StringBuilder();
            for (SceneObject one : all) {
                scene = scene.plus(one);
                apart.append(SceneFiles.format(Scene.EMPTY.plus(one)).lines().skip(3).filter(line -> !line.equals("</scene>")).collect(Collectors.joining("\n", "", "\n")));
            }
            assertThat(SceneFiles.format(scene)).contains(apart);
            assertThat(WayIn.all(SceneFiles.format(scene)).scene()).isEqualTo(scene);
        }
    }

    @Test
    void aDatabaseKeepsItsScenesInOrder(@TempDir Path folder) throws Exception {
        List<Scene> scenes = List.of(RandomScenes.of(1), RandomScenes.of(2).withName("two"), RandomScenes.of(3).withName("three"));
        Path file = folder.resolve("database.xml");
        SceneFiles.writeAll(scenes, file);
        assertThat(WayIn.all(Files.readString(file)).contents()).contains(new SceneFiles.Contents(scenes, true));
        assertThat(folder.toFile().list()).as("no temporary file is left").containsExactly("database.xml");
    }

    @Test
    void writingKeepsTheOldFilesPermissions(@TempDir Path folder) throws Exception {
        Path file = Files.writeString(folder.resolve("a.xml"), "old");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-rw-r--"));
        SceneFiles.write(RandomScenes.of(1), file);
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file))).isEqualTo("rw-rw-r--");
        assertThat(SceneFiles.read(file)).isEqualTo(RandomScenes.of(1));
    }

    /** In an attribute a line break as it is would be read as a blank; in a description it stays one. */
    @Test
    void linesOfATextStayLines(@TempDir Path folder) throws Exception {
        Scene scene = SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><description>one\ntwo</description><camera position='0 0 5' target='0 0 0'/><text value='a&#10;b&#9;c'/></scene>");
        assertThat(SceneFiles.format(scene)).contains("<description>one\ntwo</description>", "value=\"a&#10;b&#9;c\"");
        assertThat(SceneFiles.parse(SceneFiles.format(scene))).isEqualTo(scene);
        SceneFile open = SceneFiles.open(Files.writeString(folder.resolve("a.xml"), "<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 5' target='0 0 0'/>\n  <text value='old'/>\n</scene>"));
        Scene changed = open.scene().withObjects(List.of(open.scene().objects().get(0).withShape(scene.objects().get(0).shape()), scene.objects().get(0)));
        open.save(changed);
        assertThat(SceneFiles.read(folder.resolve("a.xml")).objects()).isEqualTo(changed.objects()).hasSize(2);
    }

    @Test
    void elementsMayComeInAnyOrder() throws Exception {
        Scene scene = WayIn.all("""
                <scene xmlns="urn:paprsek:scene:1">
                  <sphere radius="1" material="later"/>
                  <material name="later" color="1 2 3"/>
                  <camera position="0 0 5" target="0 0 0"/>
                  <render width="10"/>
                </scene>""").scene();
        assertThat(scene.objects().get(0).material()).isEqualTo(new MaterialName("later"));
        assertThat(scene.settings()).isEqualTo(RenderSettings.DEFAULT.withSize(10, 600));
    }
}
