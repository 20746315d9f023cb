package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.asset.Assets;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import cz.paprsek.shape.mesh.Triangles;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** OpenSCAD's dumps as bodies of ours, against closed forms and what the words mean. */
class OpenScadTest {
    private static ForeignScene read(String text) throws IOException {
        return ForeignScene.read("a.csg", ForeignFormat.OPENSCAD,
                Assets.of(Map.of("a.csg", text.getBytes(StandardCharsets.UTF_8), "part.stl", Solids.stlBytes(Solids.block(1, 2, 3), "part"),
                        "part.off", Solids.off(Solids.block(1, 2, 3)).getBytes(StandardCharsets.UTF_8))));
    }

    /** Without the floor. */
    private static List<SceneObject> bodies(String text) throws IOException {
        List<SceneObject> all = read(text).scene().objects();
        return all.subList(0, all.size() - 1);
    }

    private static SceneObject body(String text) throws IOException {
        assertThat(bodies(text)).hasSize(1);
        return bodies(text).get(0);
    }

    private static Triangles mesh(String text) throws IOException {
        Triangles mesh = ((Mesh) body(text).shape()).triangles();
        assertThat(mesh.openEdges()).isZero();
        return mesh;
    }

    /** Around a body, where z is up as in the file. */
    private static void assertBounds(SceneObject object, double... expected) {
        Bounds up = object.shape().bounds().transformed(object.placement().toParent());
        double[] found = {up.minX(), -up.maxZ(), up.minY(), up.maxX(), -up.minZ(), up.maxY()};
        for (int i = 0; i < 6; i++) {
            assertThat(found[i]).as("number %d", i).isCloseTo(expected[i], within(1e-5));
        }
    }

    @Test
    void operationsAndBodiesAreOurs() throws IOException {
        String sphere = "sphere($fn = 0, $fa = 12, $fs = 2, r = 10);";
        List<SceneObject> bodies = bodies("multmatrix([[1, 0, 0, -24], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {\n\tunion() {\n\t\tcube(size = [15, 15, 15], center = true);\n\t\t" + sphere
                + "\n\t}\n}\nintersection() {\n\tcube(size = [15, 15, 15], center = true);\n\t" + sphere + "\n}\ndifference() {\n\tcube(size = 15, center = true);\n\t" + sphere + "\n}\n");
        assertThat(bodies).extracting(object -> object.shape().kind()).containsExactly("block", "sphere", "intersection", "difference");
        assertThat(bodies.get(1).shape()).isEqualTo(new Sphere(10));
        assertBounds(bodies.get(0), -31.5, -7.5, -7.5, -16.5, 7.5, 7.5);
        assertThat(bodies.get(3).shape()).isInstanceOfSatisfying(Csg.class, csg -> assertThat(csg.operands()).hasSize(2));
    }

    @Test
    void roundBodiesStandUprightAsTheyDoThere() throws IOException {
        assertThat(body("cylinder($fn=0,$fa=12,$fs=2,h=4,r1=2,r2=2,center=true);").shape()).isEqualTo(new Cylinder(2, 4));
        assertBounds(body("cylinder($fn=0,$fa=12,$fs=2,h=4,r1=2,r2=2,center=true);"), -2, -2, -2, 2, 2, 2);
        SceneObject tip = body("cylinder(h=4,r1=0,r2=2,center=false);");
        assertThat(tip.shape()).isEqualTo(new Cone(2, 0, 4));
        assertBounds(tip, -2, -2, 0, 2, 2, 4);
        assertThat(tip.placement().toParent().point(new Vec3(0, 4, 0)).y()).as("the tip is at the foot").isCloseTo(0, within(1e-12));
        assertThat(body("rotate_extrude(angle=360,$fn=0,$fa=12,$fs=2) { multmatrix([[1,0,0,5],[0,1,0,1],[0,0,1,0],[0,0,0,1]]) { circle($fn=0,$fa=12,$fs=2,r=2); } }").shape())
                .isEqualTo(new Torus(5, 2));
        assertThat(body("linear_extrude(height=3) { circle(r=2); }").shape()).isEqualTo(new Cylinder(2, 3));
        assertThat(body("linear_extrude(height=3) { square(size=[2,4],center=false); }").shape()).isInstanceOf(Block.class);
    }

    /** Area of a regular polygon: ½·n·r²·sin(2π/n). */
    @Test
    void fewSidesAreMeantAndManyAreRound() throws IOException {
        assertThat(mesh("cylinder($fn=6,h=4,r1=2,r2=2);").volume()).isCloseTo(4 * 0.5 * 6 * 4 * Math.sin(Math.PI / 3), within(1e-9));
        assertThat(mesh("cylinder($fn=4,h=3,r1=2,r2=0);").volume()).as("a pyramid").isCloseTo(8, within(1e-9));
        assertThat(mesh("sphere($fn=8,r=1);").volume()).isBetween(2.9, 4.1);
        assertThat(body("sphere($fn=13,r=1);").shape()).isEqualTo(new Sphere(1));
    }

    /** How much of a body a grid of lines along y, which is z in the file, is in, line by line. */
    private static double[] lengths(String text, Bounds box, int fine) throws IOException {
        SceneObject body = body(text);
        Volume placed = ((Solid) body.shape()).place(body.placement().toParent(), Parts.UNTOLD);
        Spans spans = new Spans();
        Ray ray = new Ray(spans);
        double[] lengths = new double[fine * fine];
        for (int i = 0; i < lengths.length; i++) {
            double x = box.minX() + (box.maxX() - box.minX()) * (i % fine + 0.5) / fine;
            int row = i / fine;
            double z = box.minZ() + (box.maxZ() - box.minZ()) * (row + 0.5) / fine;
            ray.start(x, box.minY() - 1, z, 0, 1, 0);
            placed.spans(ray, spans);
            for (int k = 0; k < spans.size(); k += 2) {
                lengths[i] += spans.t(k + 1) - spans.t(k);
            }
            spans.release(0);
        }
        return lengths;
    }

    /** To about 1/1000. */
    private static double volume(String text) throws IOException {
        SceneObject body = body(text);
        Bounds box = ((Solid) body.shape()).place(body.placement().toParent(), Parts.UNTOLD).bounds();
        return Arrays.stream(lengths(text, box, 300)).average().orElseThrow() * (box.maxX() - box.minX()) * (box.maxZ() - box.minZ());
    }

    private static final String TRIANGLE = "polygon(points=[[0,0],[4,0],[0,3]],paths=undef,convexity=1);";

    /** Of an outline of area A: turned A·h, with a scale s at the top A·h·(1 + s + s²)/3, around an axis A·2πr (Pappus). */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "linear_extrude(height=10,center=true,scale=[1,1]) { T } | 60 | extrude",
        "linear_extrude(height=10,twist=90,slices=20,scale=[1,1]) { multmatrix([[1,0,0,-1],[0,1,0,-1],[0,0,1,0],[0,0,0,1]]) { T } } | 60 | extrude",
        "linear_extrude(height=3,scale=[0,0]) { T } | 6 | extrude",
        "linear_extrude(height=3,scale=[2,2]) { circle(r=1); } | 21.99115 | extrude",
        "linear_extrude(height=3,twist=-30,scale=[0.5,0.5]) { multmatrix([[2,0,0,1],[0,2,0,1],[0,0,1,0],[0,0,0,1]]) { square(size=[1,1],center=false); } } | 7 | extrude",
        "linear_extrude(height=3,scale=[1,0]) { square(size=[2,2],center=true); } | 6 | mesh",
        "rotate_extrude(angle=360) { T } | 50.26548 | lathe",
        "rotate_extrude(angle=90) { T } | 12.56637 | lathe",
        "rotate_extrude(angle=-90) { T } | 12.56637 | lathe",
        "rotate_extrude(angle=90) { multmatrix([[-1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { T } } | 12.56637 | lathe",
        "rotate_extrude(angle=180) { multmatrix([[1,0,0,3],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { circle(r=1); } } | 29.60881 | lathe",
    })
    void whatIsExtrudedHasItsVolume(String text, double volume, String kind) throws IOException {
        String file = text.replace("T", TRIANGLE);
        assertThat(body(file).shape().kind()).isEqualTo(kind);
        assertThat(volume(file)).isCloseTo(volume, within(volume * 2e-3));
    }

    /** With few sides it is of triangles, as OpenSCAD makes it: of twelve, which fill 95.5 % of their circle. */
    @ParameterizedTest
    @ValueSource(ints = {360, 90, -60, 200, -360})
    void whatIsTurnedLiesWhereItsTrianglesWould(int angle) throws IOException {
        for (int side : new int[] {1, -1}) {
            String figure = " { multmatrix([[" + side + ",0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { polygon(points=[[1,0],[2,0],[1,3]]); } }";
            Bounds box = new Bounds(-2, 0, -2, 2, 3, 2);
            double[] round = lengths("rotate_extrude(angle=" + angle + ")" + figure, box, 60);
            double[] faceted = lengths("rotate_extrude(angle=" + angle + ",$fn=12)" + figure, box, 60);
            double apart = IntStream.range(0, round.length).mapToDouble(i -> Math.abs(round[i] - faceted[i])).sum();
            assertThat(apart / Arrays.stream(round).sum()).isLessThan(0.2);
        }
    }

    @Test
    void extrusionsOfTrianglesHaveTheirVolumes() throws IOException {
        assertThat(mesh("linear_extrude(height=3,scale=[0.5,1]) { square(size=[2,2],center=true); }").volume()).isCloseTo(4 * 3 * 0.75, within(1e-9));
        assertThat(mesh("rotate_extrude(angle=360,$fn=12) {" + TRIANGLE + "}").volume()).as("Pappus, of 12 sides").isCloseTo(6 * 12 * Math.sin(Math.PI / 6) * 4 / 3, within(1e-9));
        String many = "polygon(points=[" + IntStream.range(0, 101).mapToObj(i -> "[" + StrictMath.cos(2 * Math.PI * i / 101) + "," + StrictMath.sin(2 * Math.PI * i / 101) + "]")
                .collect(Collectors.joining(",")) + "]);";
        assertThat(mesh("linear_extrude(height=2) {" + many + "}").volume()).isCloseTo(101 * Math.sin(2 * Math.PI / 101), within(1e-9));
        Csg frame = (Csg) body("linear_extrude(height=2) { polygon(points=[[0,0],[9,0],[9,9],[0,9],[3,3],[6,3],[6,6],[3,6]],paths=[[0,1,2,3],[4,5,6,7]]); }").shape();
        assertThat(frame.operation()).isEqualTo(Csg.Operation.DIFFERENCE);
        assertThat(frame.operands()).hasSize(2);
    }

    @Test
    void facesOfAPolyhedronLookOutwards() throws IOException {
        assertThat(mesh("polyhedron(points=[[10,10,0],[10,-10,0],[-10,-10,0],[-10,10,0],[0,0,10]],faces=[[0,1,4],[1,2,4],[2,3,4],[3,0,4],[1,0,3],[2,1,3]],convexity=1);").volume())
                .isCloseTo(4000 / 3.0, within(1e-9));
        assertThat(mesh("import(file=\"part.stl\",layer=\"\",origin=[0,0],scale=1);").volume()).isEqualTo(6);
        assertThat(mesh("import(file=\"part.off\",layer=\"\",origin=[0,0],scale=1);").volume()).isEqualTo(6);
    }

    /** A shear is no scale, turn and move; and yet the body is where each of its corners goes. */
    @Test
    void anyMatrixPutsABodyWhereItBelongs() throws IOException {
        SceneObject sheared = body("multmatrix([[1,0.5,0,0],[0,2,0,0],[0.25,0,1,7],[0,0,0,1]]) { sphere(r=1); }");
        Bounds bounds = sheared.shape().place(sheared.placement().toParent(), Parts.UNTOLD).bounds();
        // The half-width of a mapped unit ball is the length of the row.
        assertThat(bounds.maxX()).isCloseTo(Math.sqrt(1 + 0.25), within(1e-4));
        assertThat(bounds.maxZ()).isCloseTo(2, within(1e-4));
        assertThat(bounds.maxY()).isCloseTo(7 + Math.sqrt(1 + 0.0625), within(1e-4));
    }

    @Test
    void theOuterColourCounts() throws IOException {
        SceneObject red = body("color([1, 0, 0, 1]) { color([0, 0, 1, 1]) { cube(size=1); } }");
        assertThat(red.material()).isEqualTo(Material.color(new Rgb(255, 0, 0)));
        assertThat(((Material) body("color([0, 1, 0, 0.25]) { cube(size=1); }").material()).transparency()).isEqualTo(0.75);
    }

    @Test
    void anOnlyChildNeedsNoBraces() throws IOException {
        String moved = "multmatrix([[1, 0, 0, 4], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])";
        assertThat(bodies(moved + " color([1, 0, 0, 1])\n  cube(size = 2); sphere(r = 1);")).isEqualTo(bodies(moved + " { color([1, 0, 0, 1]) { cube(size = 2); } } sphere(r = 1);"));
    }

    @Test
    void whatIsLeftOutIsSaidWithItsLine() throws IOException {
        ForeignScene read = read("cube(size = 1);\n\nhull() {\n\tcube(size=1);\n}\n%cube(size=9);\n*cube(size=9);\nminkowski() { cube(size=1); }");
        assertThat(read.scene().objects()).hasSize(2);
        assertThat(read.notes()).containsExactly("line 3: hull() is not read, and left out", "line 6: what is marked with % is not shown", "line 8: minkowski() is not read, and left out");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "cube(size = | line 1: here must be a number, a list, a text, true, false or undef, but is the end",
        "group() {\\n cube(size=1); | line 2: the file ends before the } of line 1",
        "\\n\\ncube(size=[1,2]); | line 3: cube size must be 3 numbers in [ ]",
        "sphere(r=inf); | line 1: sphere r must be a finite number",
        "cube(size=1 | line 1: here must be , or ), but is the end",
        "cube(size=[1 2]); | line 1: here must be , or ], but is \"2]);\"",
        "color([1,0,0]) ü; | line 1: here must be { or ;, but is \"ü;\"",
        "color([1,0,0]) | line 1: here must be { or ;, but is the end",
        "cube(size=1) cube(size=1); | line 1: here must be { or ;, but is \"cube(size=1);\"",
        "polyhedron(points=[[0,0,0]],faces=[[0,1,2]]); | line 1: polyhedron faces must be numbers of points, from 0 to 0",
        "import(file=\"../../etc/passwd.stl\"); | line 1: \"../../etc/passwd.stl\": only files in the scene's folder and below can be read",
        "hull() { cube(size=1); } | the end: there is no body in this file; line 1: hull() is not read, and left out",
    })
    void whatIsWrongIsSaidWithItsPlace(String text, String sentence) {
        assertThatThrownBy(() -> read(text.translateEscapes())).isInstanceOf(IOException.class).hasMessageStartingWith("\"a.csg\": " + sentence);
    }

    @Test
    void whatIsNestedWithoutEndIsRefused() {
        assertThatThrownBy(() -> read("group() {\n".repeat(100_000))).hasMessage("\"a.csg\": line 202: this is nested deeper than 200");
        assertThatThrownBy(() -> read("cube(size=" + "[".repeat(100_000))).hasMessageContaining("nested deeper than 200");
    }

    @Test
    void aFileOfTrianglesIsASceneToo() throws IOException {
        Assets assets = Assets.of(Map.of("m/part.stl", Solids.stlBytes(Solids.block(1, 2, 3), "part")));
        Scene scene = ForeignScene.read("m/part.stl", ForeignFormat.STL, assets).scene();
        assertThat(scene.objects()).extracting(SceneObject::name).containsExactly("part", "floor");
        assertThat(scene.objects().get(1).placement().position().y()).isZero();
        assertThat(scene.settings().isAdaptive()).isTrue();
        assertBounds(scene.objects().get(0), 0, 0, 0, 1, 2, 3);
    }
}
