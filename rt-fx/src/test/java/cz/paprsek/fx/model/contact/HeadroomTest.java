package cz.paprsek.fx.model.contact;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is dropped on a floor 10 wide, 2 below something: it is no larger than 2, and below it. */
class HeadroomTest {
    private static final String FLOOR = "<block min=\"-5 -0.1 -5\" max=\"5 0 5\"/>";
    private static final String ROOM = "<difference><block min=\"-5 -0.1 -5\" max=\"5 2.1 5\"/><block min=\"-4.9 0 -4.9\" max=\"4.9 2 5.1\"/></difference>";

    @TempDir
    private Path folder;

    private EditorState scene(String objects) throws Exception {
        Path file = folder.resolve("scene.xml");
        Files.writeString(file, "<scene xmlns=\"urn:paprsek:scene:1\" name=\"a\"><camera position=\"0 1 30\" target=\"0 0 0\"/>" + objects + "</scene>");
        return EditorState.of(SceneFiles.read(file));
    }

    private static Bounds dropped(EditorState state, Sight fit) {
        Scene after = Dropping.body(state, new Sphere(fit.size() / 2), "ball", fit, Vec3.Y).scene();
        return ScenePath.body(after.objects().size() - 1).placed(after).bounds();
    }

    private void staysBelow(String objects, double x, double z, double roof) throws Exception {
        EditorState state = scene(objects);
        Sight fit = Dropping.fitting(state, new Sight(new Vec3(x, 0, z), 5), Vec3.Y);
        assertThat(dropped(state, fit).maxY()).as("%s at %s", objects, fit).isLessThan(roof + 1e-9);
        assertThat(dropped(state, fit).minY()).as("%s at %s", objects, fit).isBetween(-1e-5, roof / 2);
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "4, 0", "4.7, -4.7", "-3, 4", "0, -4.88"})
    void inARoomOfOnePieceNothingComesOntoTheRoof(double x, double z) throws Exception {
        staysBelow(ROOM, x, z, 2);
        staysBelow(FLOOR + "<plane rotation=\"180 0 0\" position=\"0 2 0\"/>", x, z, 2);
        staysBelow(FLOOR + "<block min=\"-5 2 -5\" max=\"5 2.1 5\"/>", x, z, 2);
        staysBelow(FLOOR + "<plane rotation=\"180 0 0\" position=\"0 2 0\"/><plane rotation=\"0 0 90\" position=\"5 0 0\"/>", x, z, 2);
    }

    @Test
    void itIsAsLargeAsItFits() throws Exception {
        assertThat(size(ROOM, 0, 0, 0)).isEqualTo(1);
        assertThat(size(FLOOR + "<plane rotation=\"180 0 0\" position=\"0 2 0\"/>", 0, 0, 0)).isEqualTo(1);
        assertThat(size(FLOOR + "<torus major-radius=\"3\" minor-radius=\"0.2\" rotation=\"90 0 0\"/>", 0, 0, 0)).as("below an arch, which is 2.36 high at the sides of what is 2 high").isEqualTo(1);
        assertThat(size("<plane/>", 0, 0, 0)).as("on a floor without an end").isEqualTo(5);
        assertThat(size(ROOM, 0, 2.1, 0)).as("on the roof, of which it is asked").isEqualTo(5);
        assertThat(size("<union><block min=\"-2 0 -2\" max=\"2 1 2\"/><block min=\"2 0 -2\" max=\"4 3 2\"/></union>", 0, 1, 0)).as("beside a step").isEqualTo(5);
        assertThat(size("<rectangle min=\"-8 -8\" max=\"8 8\" position=\"0 0.02 0\" rotation=\"-90 0 0\"/>", 0, 0, 0)).as("a little beneath a floor without an inside").isEqualTo(5);
    }

    /** However high the floor is. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 100, 1000, 3000, -10, -1000, -3000})
    void roomCountsNotTheHeightOfTheFloor(double y) throws Exception {
        String objects = "<block min=\"-5 %s -5\" max=\"5 %s 5\"/><block min=\"-5 %s -5\" max=\"5 %s 5\"/>".formatted(y - 0.1, y, y + 2, y + 2.1);
        assertThat(size(objects, 0, y, 0)).isEqualTo(1);
    }

    private double size(String objects, double x, double y, double z) throws Exception {
        return Dropping.fitting(scene(objects), new Sight(new Vec3(x, y, z), 5), Vec3.Y).size();
    }
}
