package cz.paprsek.pov;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Pattern.Lay;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Examples;
import cz.paprsek.shape.Lathe;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Text;
import cz.paprsek.shape.mesh.Meshes;
import cz.paprsek.shape.mesh.Triangles;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** That the words mean the same to POV-Ray is the cross-check's to show. */
class PovFilesTest {
    private static final Path FOLDER = Path.of("src/test/resources/pov");

    @Test
    void whatIsToldOfManyIsToldOnce() throws Exception {
        for (int count : new int[] {8, 9, 500}) {
            List<String> warnings = PovFiles.write(SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 9' target='0 0 0'/><repeat name='lamp' count='" + count
                    + "' position='2 0 0'><rectangle min='0 0' max='1 1'><material color='black' emission='white'/></rectangle></repeat></scene>"), new StringBuilder());
            assertThat(warnings).hasSize(count == 8 ? 8 : 1).first().asString().startsWith("\"lamp[0]\"" + (count == 8 ? "" : " (and " + (count - 1) + " more)") + ": POV-Ray multiplies the emission");
        }
    }

    @Test
    void everythingIsWrittenInTheWordsOfPovRay(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("everything.pov");
        PovFiles.write(SceneFiles.read(FOLDER.resolve("everything.xml")), file);
        assertThat(Files.readString(file)).isEqualTo(Files.readString(FOLDER.resolve("everything.pov"), StandardCharsets.UTF_8));
    }

    @Test
    void whatIsNotExactIsSaid() throws Exception {
        Scene scene = SceneFiles.read(FOLDER.resolve("everything.xml"));
        assertThat(PovFiles.write(scene, new StringBuilder())).containsExactly(
                "POV-Ray does not sample pixels on a grid; for the same picture render it 2 times as wide and high, and average",
                "object #9: POV-Ray does not count rays that go straight through as a level of max-depth",
                "object #10 has surfaces of several refractive indices; POV-Ray knows one inside only and is told 1.5");
    }

    /** To render it larger and average would be the box filter. */
    @ParameterizedTest
    @CsvSource({"3, 0, MITCHELL, on a grid", "2, 8, GAUSS, 'at random, by error and confidence'", "2, 2, TENT, 'at random, by error and confidence'"})
    void aFilterThatPovRayHasNotIsSaid(int least, int most, PixelFilter filter, String how) throws Exception {
        Scene scene = Scene.EMPTY.withSettings(Scene.EMPTY.settings().withSamples(least, most).withFilter(filter));
        assertThat(PovFiles.write(scene, new StringBuilder())).containsExactly("POV-Ray does not sample pixels " + how + ", nor weighs their rays by the filter "
                + filter + "; it is given one ray through the centre of each");
        Scene oneRay = scene.withSettings(scene.settings().withSamples(1));
        assertThat(PovFiles.write(oneRay, new StringBuilder())).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 1})
    void totalReflectionIsExactOnlyIfNoLightIsLost(double transparency) throws Exception {
        String xml = "<scene xmlns='" + SceneFiles.NAMESPACE + "'>"
                + "<camera position='0 0 5' direction='0 0 -1'/><sphere radius='1'><material transparency='" + transparency
                + "' refractive-index='1.5'/></sphere></scene>";
        List<String> warnings = PovFiles.write(SceneFiles.parse(xml), new StringBuilder());
        if (transparency == 1) {
            assertThat(warnings).isEmpty();
        } else {
            assertThat(warnings).singleElement().asString().contains("we give back reflection + transparency = 0.5");
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-4, 1e6})
    void aSceneOfASizeThatPovRayCannotHandleIsSaidToBeSo(double size) throws Exception {
        Scene scene = Scene.EMPTY.withCamera(Camera.looking(new Vec3(0, 0, size), new Vec3(0, 0, -1))).plus(SceneObject.of(new Sphere(size / 9)));
        assertThat(PovFiles.write(scene, new StringBuilder())).singleElement().asString().contains("scale it to about 1 to 100");
    }

    static List<Shape> shapes() {
        return List.copyOf(Examples.ALL.values());
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void thereAreWordsForEveryShape(Shape shape) throws IOException {
        StringBuilder text = new StringBuilder();
        PovFiles.write(Scene.EMPTY.plus(SceneObject.of(shape)), text);
        assertThat(text.chars().filter(c -> c == '{').count()).isEqualTo(text.chars().filter(c -> c == '}').count());
    }

    @ParameterizedTest
    @CsvSource({"samples=\"2..8\", at random", "samples=\"3\" filter=\"tent\", nor weighs their rays by the filter tent", "samples=\"3\", on a grid"})
    void howManyRaysAPixelTakesIsTold(String attributes, String told) throws Exception {
        String xml = "<scene xmlns=\"urn:paprsek:scene:1\"><render " + attributes + "/><camera position=\"0 0 9\" direction=\"0 0 -1\"/><point-light position=\"1 2 3\"/><sphere radius=\"1\"/></scene>";
        List<String> warnings = PovFiles.write(SceneFiles.parse(xml), new StringBuilder());
        assertThat(warnings).singleElement().asString().contains(told);
    }

    /** Cross-checked with a rectangle from behind and a ball of glass: its normals are turned to the eye before they are bent, ours after. */
    @ParameterizedTest
    @CsvSource({"rectangle min='-1 -1' max='1 1', 0, behind", "sphere radius='1', 0.5, within", "sphere radius='1', 0, ''"})
    void bumpsThatPovRayTurnsRoundAreSaid(String shape, double transparency, String from) throws Exception {
        String xml = "<scene xmlns='" + SceneFiles.NAMESPACE + "'><camera position='0 0 5' direction='0 0 -1'/><" + shape + "><material transparency='" + transparency
                + "'><bump><noise/></bump></material></" + shape.substring(0, shape.indexOf(' ')) + "></scene>";
        List<String> turned = PovFiles.write(SceneFiles.parse(xml), new StringBuilder()).stream().filter(one -> one.contains("turns its bumps round")).toList();
        assertThat(turned).isEqualTo(from.isEmpty() ? List.of() : List.of("object #1: POV-Ray turns its bumps round where they are met from " + from));
    }

    /** As its corners have it: POV-Ray, told so, showed the picture on the wall of the room from glTF where we do. */
    @Test
    void aPictureLiesOnAMeshAsItsCornersHaveIt() throws Exception {
        Triangles.Builder square = Triangles.builder().part("wall");
        for (int v = 0; v < 4; v++) {
            square.vertex(v & 1, v >> 1, 0);
            square.map(v, v & 1, v >> 1);
        }
        square.triangle(0, 1, 3);
        square.triangle(0, 3, 2);
        Material picture = Material.DEFAULT.withPattern(new Pattern.Picture("hill.png", Pattern.Filter.NEAREST, Pattern.Mapping.UV, Lay.NONE));
        Mesh wall = Mesh.of("wall.obj").read(new Mesh.Whole("wall.obj", square.build(), Map.of("wall", picture)));
        StringBuilder said = new StringBuilder();
        assertThat(PovFiles.write(Scene.EMPTY.plus(SceneObject.of(wall)), said)).isEmpty();
        assertThat(said).contains("pigment { uv_mapping image_map { png \"hill.png\" gamma srgb map_type 0 } }", "uv_vectors { 4,");
    }

    /** Also where the object is part of another, and where a body's picture is laid over what it is made of. */
    @Test
    void picturesOfAFilesPartsAreSaidToLieOtherwise() throws Exception {
        Material lid = Material.color(200, 200, 200).withPattern(new Pattern.Picture("lid.png", Pattern.Filter.BILINEAR, Pattern.Mapping.BOX, Lay.NONE));
        Triangles.Builder two = Triangles.builder().part("pot");
        Triangles cube = Meshes.cube(1);
        for (int v = 0; v < cube.vertexCount(); v++) {
            two.vertex(cube.x(v), cube.y(v), cube.z(v));
        }
        for (int t = 0; t < cube.count(); t++) {
            two.part(t < 6 ? "pot" : "lid").triangle(cube.corner(t, 0), cube.corner(t, 1), cube.corner(t, 2));
        }
        Mesh pot = Mesh.of("pot.obj").read(new Mesh.Whole("pot.obj", two.build(), Map.of("lid", lid)));
        String lies = "POV-Ray does not know how lid.png lies on it, and is told that it lies on a plane";
        assertThat(warnings(SceneObject.of(pot).named("pot"))).containsExactly("\"pot\": " + lies);
        assertThat(warnings(SceneObject.of(Csg.difference(pot, new Sphere(1))).named("bowl"))).containsExactly("\"bowl\": " + lies);
        assertThat(warnings(SceneObject.of(pot).named("red").madeOf(Material.color(255, 0, 0)))).isEmpty();
        assertThat(warnings(SceneObject.of(Csg.union(new Sphere(1), new Sphere(2))).named("balls").madeOf(lid))).containsExactly("\"balls\": " + lies);
    }

    /** A cedilla reaches into its letter, where the font has two outlines. */
    @Test
    void lettersWhosePartsLieOverEachOtherAreSaid() throws Exception {
        assertThat(warnings(SceneObject.of(Text.of("ça", 1, 0.2)).named("sign"))).containsExactly("\"sign\" has letters, or parts of them, that lie over each other; POV-Ray has holes there");
        assertThat(warnings(SceneObject.of(Csg.union(Text.of("ça", 1, 0.2), new Sphere(1))))).hasSize(1);
        assertThat(warnings(SceneObject.of(Text.of("Příliš žluťoučký kůň B8%", 1, 0.2)))).isEmpty();
    }

    private static List<String> warnings(SceneObject object) throws IOException {
        return PovFiles.write(Scene.EMPTY.plus(object), new StringBuilder());
    }

    @Test
    void curvesOnTheLatheAreTold() throws IOException {
        StringBuilder text = new StringBuilder();
        PovFiles.write(Scene.EMPTY.plus(SceneObject.of(new Lathe("M 0 0 L 0.6 0 Q 0.2 0.5 0.4 1 L 0 1 Z", "", 360)), SceneObject.of(new Lathe("", "0 0 0.5 0 0.5 1", 360))), text);
        assertThat(text.toString()).contains("lathe { bezier_spline 16, <0, 0>").contains("lathe { linear_spline 4, ");
    }
}
