package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.asset.Assets;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.mesh.Triangles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Files that eight other programs wrote, against what a program that did not write them reads. */
class OthersFilesTest {
    private static final Path FOLDER = Path.of("src/test/resources/foreign");
    private static final Assets ASSETS = Assets.in(FOLDER);

    record Expected(String file, int triangles, List<Double> bounds, double volume) {
        static Expected of(String line) {
            List<String> words = Pattern.compile(" \\| ").splitAsStream(line).toList();
            return new Expected(words.get(0), Integer.parseInt(words.get(1)), numbers(words.get(2) + ' ' + words.get(3)), Double.parseDouble(words.get(4)));
        }

        @Override
        public String toString() {
            return file;
        }
    }

    private static List<Double> numbers(String text) {
        return Pattern.compile(" ").splitAsStream(text).map(Double::valueOf).toList();
    }

    static List<Expected> files() throws IOException {
        return Files.readAllLines(FOLDER.resolve("files.txt")).stream().filter(line -> !line.startsWith("#")).map(Expected::of).toList();
    }

    @Test
    void theManualTellsHowManyThereAre() throws IOException {
        assertThat(Files.readString(Path.of("../docs/models.md"))).contains("The " + files().size() + " files of eight programs");
    }

    private static double[] array(Bounds b) {
        return new double[] {b.minX(), b.minY(), b.minZ(), b.maxX(), b.maxY(), b.maxZ()};
    }

    @ParameterizedTest
    @MethodSource("files")
    void whatIsInAFileIsWhatOthersFindInIt(Expected expected) throws IOException {
        Triangles mesh = Mesh.of(expected.file).read(MeshFiles.whole(expected.file, ASSETS)).triangles();
        assertThat(mesh.count()).isEqualTo(expected.triangles);
        double[] found = array(mesh.bounds());
        for (int i = 0; i < 6; i++) {
            assertThat(found[i]).as("bounds %s", Arrays.toString(found)).isCloseTo(expected.bounds.get(i), within(1e-5));
        }
        // The corners that should close a ring of three.js miss the first ones by the sine of what should be 2π, and are welded.
        assertThat(mesh.openEdges()).isZero();
        assertThat(MeshFiles.model(expected.file, ASSETS).triangles().isClosed()).isNotEqualTo(expected.file.startsWith("three-ring"));
        assertThat(mesh.volume()).isCloseTo(expected.volume, within(1e-4 * expected.volume));
    }

    /** The pot's colours are as red, green and blue as its places are right, back and up in Blender; in glTF as light, else as sRGB, for so the programs wrote them. */
    @ParameterizedTest
    @ValueSource(strings = {"assimp-pot.glb", "assimp-pot.obj", "blender-pot.glb", "meshlab-pot.obj", "meshlab-pot.off", "meshlab-pot.ply", "meshlab-pot.stl", "trimesh-pot.glb", "trimesh-pot.obj", "trimesh-pot.ply"})
    void coloursAreWhereTheirProgramsPutThem(String file) throws IOException {
        Triangles mesh = MeshFiles.model(file, ASSETS).triangles();
        boolean isLight = file.endsWith("glb");
        boolean isYUp = file.startsWith("blender");
        for (int t = 0; t < mesh.count(); t++) {
            double[] color = new double[3];
            double[] place = new double[3];
            for (int k = 0; k < 3; k++) {
                Vec3 light = mesh.color(mesh.corner(t, k));
                Vec3 at = mesh.place(mesh.corner(t, k));
                double[] channels = {light.x(), light.y(), light.z()};
                double[] upright = isYUp ? new double[] {at.x(), -at.z(), at.y()} : new double[] {at.x(), at.y(), at.z()};
                for (int axis = 0; axis < 3; axis++) {
                    color[axis] += (isLight ? channels[axis] : Rgb.encoded(channels[axis]) / 255) / 3;
                    place[axis] += (0.5 + 0.5 * upright[axis]) / 3;
                }
            }
            for (int axis = 0; axis < 3; axis++) {
                assertThat(color[axis]).as("triangle %d", t).isCloseTo(place[axis], within(file.endsWith("stl") ? 0.04 : 0.012));
            }
        }
    }

    @Test
    void theyAreOfManyProgramsAndFormats() throws IOException {
        List<String> names = files().stream().map(Expected::file).toList();
        assertThat(names.stream().map(name -> name.substring(0, name.indexOf('-'))).distinct()).containsExactlyInAnyOrder("assimp", "blender", "meshio", "meshlab", "openscad", "three", "trimesh", "vtk");
        assertThat(names.stream().map(name -> name.substring(name.lastIndexOf('.') + 1)).distinct())
                .containsAll(Arrays.stream(ForeignFormat.values()).filter(ForeignFormat::isMesh).flatMap(format -> format.endings().stream()).toList());
    }

    /** With the bounds of the STL that OpenSCAD makes of them; what has fourteen sides there is round here, and so up to 3 % larger. */
    @ParameterizedTest
    @CsvSource({"openscad-ell.csg, 0 0 0 3 2.5 1.25, 1e-9", "openscad-ring.csg, -2.75 -2.68105 -0.75 2.75 2.68105 0.75, 0.07", "openscad-nut.csg, -2 -1.73205 0 2 1.73205 1.5, 1e-5"})
    void dumpsAreBodiesAsLargeAsThose(String file, String bounds, double tolerance) throws IOException {
        ForeignScene scene = ForeignScene.read(file, ForeignFormat.OPENSCAD, ASSETS);
        double[] up = array(scene.scene().objects().get(0).shape().bounds().transformed(scene.scene().objects().get(0).placement().toParent()));
        List<Double> expected = numbers(bounds);
        double[] found = {up[0], -up[5], up[1], up[3], -up[2], up[4]};
        for (int i = 0; i < 6; i++) {
            assertThat(found[i]).as("bounds %s", Arrays.toString(found)).isCloseTo(expected.get(i), within(tolerance));
        }
        assertThat(scene.convention()).satisfies(it -> assertThat(it.unit() + it.isZUp()).isEqualTo("mmtrue"));
    }
}
