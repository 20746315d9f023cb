package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Files of other programs, as users come with them. */
class ModelsTest {
    /** The corner of a cube: a quarter of the pixels and more show it. */
    private static final String OBJ = "v 0 0 0\nv 3 0 0\nv 0 4 0\nv 0 0 5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

    @TempDir
    Path folder;

    private Path obj;

    @BeforeEach
    void writeAModel() throws IOException {
        obj = Files.writeString(folder.resolve("corner.obj"), OBJ);
    }

    @Test
    void aModelIsRenderedAtOnce() throws IOException {
        Path picture = folder.resolve("p.png");
        assertThat(Run.cli("render", obj, "-o", picture, "--size", "48x36", "--samples", "1").code()).isZero();
        Image image = ImageFiles.read(picture);
        assertThat(image.width()).isEqualTo(48);
        assertThat(image.green(24, 18)).as("the body is brighter than its shadow").isGreaterThan(0.1f);
    }

    @Test
    void aFileOfTrianglesIsDescribed() {
        Run run = Run.cli("info", obj);
        assertThat(run.out().lines().map(String::strip).map(line -> line.replaceAll(" +", " "))).containsExactly(obj.toString(), "triangles 4, vertices 4", "closed yes",
                "volume 10", "area 37.36542462386205", "bounds 0 0 0 to 3 4 5", "unit not said, y is up");
        assertThat(Run.cli("info", obj, "--json").out()).contains("\"closed\":true,\"open-edges\":0,\"volume\":10,\"area\":37.36").contains("\"bounds\":{\"min\":[0,0,0],\"max\":[3,4,5]}").hasLineCount(1);
    }

    @Test
    void ofTheMeshesOfASceneTheSameIsSaid() throws IOException {
        Path scene = Files.writeString(folder.resolve("two.xml"),
                "<scene xmlns=\"urn:paprsek:scene:1\"><camera position=\"0 0 9\" target=\"0 0 0\"/><mesh file=\"corner.obj\"/><mesh file=\"corner.obj\" position=\"4 0 0\"/></scene>");
        assertThat(Run.cli("info", scene).out()).containsOnlyOnce("corner.obj   4 triangles, closed, volume 10, area 37.36542462386205");
        assertThat(Run.cli("info", scene, "--json").out()).contains("\"meshes\":[{\"file\":\"corner.obj\"", "\"closed\":true,\"open-edges\":0,\"volume\":10,").hasLineCount(1);
    }

    @ParameterizedTest
    @CsvSource(textBlock = """
            <mesh file='none.stl'/> | there is no such file beside the scene
            <mesh file='none.stl'/><sphere radius='1'/> | there is no such file beside the scene
            <mesh file='corner.obj' part='lid'/><sphere radius='1'/> | there is no part "lid" in "corner.obj"
            <mesh file='open.obj'/><sphere radius='1'/> | "open.obj" has no inside, so <difference> cannot use it: 3 of its edges are open
            """, delimiter = '|', quoteCharacter = '`')
    void aMeshThatIsNotToBeHadIsOneLineFromEveryCommand(String bodies, String sentence) throws IOException {
        Files.writeString(folder.resolve("open.obj"), "v 0 0 0\nv 3 0 0\nv 0 4 0\nf 1 2 3\n");
        String body = bodies.contains("sphere") ? "<difference>" + bodies + "</difference>" : bodies;
        Path scene = Files.writeString(folder.resolve("lacking.xml"), "<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 9' target='0 0 0'/>" + body + "</scene>");
        for (Run run : List.of(Run.cli("validate", scene), Run.cli("validate", scene, "--strict"), Run.cli("info", scene), Run.cli("render", scene, "-o", folder.resolve("n.png")))) {
            assertThat(run.code()).isEqualTo(3);
            assertThat(run.err().lines().filter(line -> line.contains(sentence))).hasSize(1);
            assertThat(run.err()).doesNotContain("fault of the program");
        }
        assertThat(Run.cli("validate", scene, "--json").out()).contains("\"valid\":false").hasLineCount(1);
    }

    /** Nobody writes into it: whoever opened it would wait for ever. */
    @Test
    void aPipeIsRefusedAtOnce() throws Exception {
        Path pipe = folder.resolve("part.stl");
        assumeTrue(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() == 0);
        for (Run run : List.of(Run.cli("validate", pipe), Run.cli("info", pipe), Run.cli("convert", pipe, folder.resolve("part.obj")), Run.cli("render", pipe, "-o", folder.resolve("n.png")))) {
            assertThat(run.code()).isEqualTo(3);
            assertThat(run.err().lines()).containsExactly(pipe + ": this is a pipe or a device, and files of other programs cannot come through a pipe; write it to a file first");
        }
    }

    /** Whoever saved it gave it the ending of another. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            a.stl, '# made by hand\n\nv 0 0 0\nv 3 0 0\nv 0 4 0\nf 1 2 3\n', OBJ
            b.ply, 'o corner\nv 0 0 0\nv 3 0 0\nv 0 4 0\nf 1 2 3\n', OBJ
            c.glb, 'solid corner\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 3 0 0\nvertex 0 4 0\nendloop\nendfacet\nendsolid\n', STL
            """)
    void aFileIsReadByWhatItHolds(String name, String text, String format) throws IOException {
        String content = text.translateEscapes();
        Run run = Run.cli("info", Files.writeString(folder.resolve(name), content));
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(run.out()).containsPattern("triangles +1, ");
        Run fed = IncomingTest.fed(content.getBytes(StandardCharsets.UTF_8), "info", "-");
        assertThat(fed.code()).isEqualTo(3);
        assertThat(fed.err().lines()).singleElement().asString().startsWith("-: this looks like ").contains(format, "; files of other programs cannot come through a pipe; write it to a file first");
    }

    /** Neither has a signature. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            '# two balls\n\nb 0.1 0.2 0.3\nv\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 32 24\nl 5 5 5\nf 1 0 0 1 0 0 0 1\ns 0 0 0 1\n', NFF
            'v \r\nfrom 0 0 9\r\nat 0 0 0\r\nup 0 1 0\r\nangle 40\r\nhither 1\r\nresolution 32 24\r\nf 1 0 0 1 0 0 0 1\r\ns 0 0 0 1\r\n', NFF
            'group() {\n\tsphere($fn = 0, $fa = 12, $fs = 2, r = 1);\n}\n', OpenSCAD CSG
            'multmatrix([[1, 0, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {\n\tcube(size = [1, 1, 1], center = true);\n}\n', OpenSCAD CSG
            """)
    void whatIsNoMeshIsKnownByHowItBegins(String text, String format) throws IOException {
        String content = text.translateEscapes();
        Run run = Run.cli("info", Files.writeString(folder.resolve("unnamed.txt"), content));
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(IncomingTest.fed(content.getBytes(StandardCharsets.UTF_8), "render", "-").err())
                .isEqualTo("-: this looks like " + format + "; files of other programs cannot come through a pipe; write it to a file first\n");
    }

    /** A scene begins with it; the lengths and titles of binary files may hold it as any other byte. */
    @Test
    void anAngleBracketFurtherOnMakesNoSceneOfAFile() throws IOException {
        ByteBuffer solid = ByteBuffer.allocate(134).order(ByteOrder.LITTLE_ENDIAN).put("part <1>".getBytes(StandardCharsets.US_ASCII)).putInt(80, 1);
        for (int i = 0; i < 12; i++) {
            solid.putFloat(84 + 4 * i, "001000300040".charAt(i) - '0');
        }
        Run read = Run.cli("info", Files.write(folder.resolve("titled.stl"), solid.array()));
        assertThat(read.code()).as(read.err()).isZero();
        assertThat(read.out()).containsPattern("triangles +1, ");
        ByteBuffer glb = ByteBuffer.allocate(80).order(ByteOrder.LITTLE_ENDIAN).put("glTF".getBytes(StandardCharsets.US_ASCII)).putInt(2).putInt(80).putInt('<')
                .put(String.format("JSON%-60s", "{\"asset\":{\"version\":\"2.0\"}}").getBytes(StandardCharsets.US_ASCII));
        Run empty = Run.cli("info", Files.write(folder.resolve("sixty.glb"), glb.array()));
        assertThat(empty.code()).isEqualTo(3);
        assertThat(empty.err().lines()).singleElement().asString().endsWith("there is no triangle in the scene of this file");
    }

    @Test
    void theFloorCanBeLeftAway() throws IOException {
        assertThat(Run.cli("render", obj, "-o", folder.resolve("f.ppm"), "--size", "32x24", "--samples", "1", "--mode", "objects").code()).isZero();
        assertThat(Run.cli("render", obj, "-o", folder.resolve("n.ppm"), "--size", "32x24", "--samples", "1", "--mode", "objects", "--no-floor").code()).isZero();
        Image with = ImageFiles.read(folder.resolve("f.ppm"));
        Image without = ImageFiles.read(folder.resolve("n.ppm"));
        assertThat(with.red(16, 23)).as("the floor is seen below").isNotEqualTo(without.red(16, 23));
        assertThat(with.red(16, 12)).as("the body stays").isEqualTo(without.red(16, 12));
        assertThat(Run.cli("render", obj, "--where", "objects = 1", "-o", folder.resolve("w.ppm"), "--size", "32x24", "--samples", "1", "--mode", "objects", "--no-floor").code()).isZero();
        assertThat(folder.resolve("w.ppm")).as("a filter sees what is rendered").hasSameBinaryContentAs(folder.resolve("n.ppm"));
        assertThat(Run.cli("render", obj, "--where", "objects = 1", "-o", folder.resolve("x.ppm"), "--size", "32x24").code()).as("with the floor there are two").isEqualTo(2);
        assertThat(Run.cli("convert", obj, folder.resolve("bare.xml"), "--no-floor").code()).isZero();
        assertThat(folder.resolve("bare.xml")).content().contains("<mesh").doesNotContain("<plane");
    }

    @Test
    void coloursOfVerticesAreTold() throws IOException {
        Path plain = Files.writeString(folder.resolve("plain.obj"), OBJ);
        Path colored = Files.writeString(folder.resolve("colored.obj"), OBJ.replaceAll("(?m)^(v .*)$", "$1 1 0.5 0"));
        Path scene = folder.resolve("colored.xml");
        assertThat(Run.cli("convert", colored, scene).code()).isZero();
        assertThat(Run.cli("info", plain).out()).doesNotContain("colour");
        assertThat(Run.cli("info", plain, "--json").out()).contains("\"vertex-colors\":false");
        assertThat(Run.cli("info", colored).out()).contains("  colours     at its vertices");
        assertThat(Run.cli("info", colored, "--json").out()).contains("\"vertex-colors\":true");
        assertThat(Run.cli("info", scene).out()).contains("area 37.36542462386205, coloured at its vertices");
    }

    @Test
    void whatIsOpenIsSaid() throws IOException {
        Path open = Files.writeString(folder.resolve("open.obj"), OBJ.replace("f 2 3 4\n", ""));
        assertThat(Run.cli("info", open).out()).contains("no, 3 edges are open").doesNotContain("volume");
    }

    @Test
    void aModelBecomesASceneThatIsTheSamePicture() throws IOException {
        Path scene = folder.resolve("sub/corner.xml");
        Files.createDirectories(folder.resolve("sub"));
        assertThat(Run.cli("convert", obj, scene).code()).isZero();
        assertThat(folder.resolve("sub/corner.obj")).hasSameBinaryContentAs(obj);
        assertThat(Run.cli("validate", "--strict", scene).code()).isZero();
        assertThat(Run.cli("render", obj, "-o", folder.resolve("a.ppm"), "--size", "32x24").code()).isZero();
        assertThat(Run.cli("render", scene, "-o", folder.resolve("b.ppm"), "--size", "32x24").code()).isZero();
        assertThat(folder.resolve("b.ppm")).hasSameBinaryContentAs(folder.resolve("a.ppm"));
    }

    /** A model with its materials in another file, and a picture in a third. */
    private Path painted() throws IOException {
        Files.createDirectories(folder.resolve("from/pictures"));
        Image picture = new Image(2, 2);
        for (int i = 0; i < 4; i++) {
            picture.set(i % 2, i / 2, i < 2 ? 1 : 0, i % 2, 0.5);
        }
        ImageFiles.write(picture, folder.resolve("from/pictures/p.png"));
        Files.writeString(folder.resolve("from/m.mtl"), "newmtl m\nKd 1 1 1\nmap_Kd pictures/p.png\n");
        return Files.writeString(folder.resolve("from/painted.obj"), "mtllib m.mtl\nusemtl m\n" + OBJ.replace("v 0 0 5\n", "v 0 0 5\nvt 0 0\nvt 1 0\nvt 0 1\n").replaceAll("f (\\d) (\\d) (\\d)", "f $1/1 $2/2 $3/3"));
    }

    /** Of its own materials; one that the scene gives it stands for them all. */
    @Test
    void aPictureThatAModelLacksIsToldWhereTheSceneNamesTheModel() throws IOException {
        Path painted = painted();
        Path scene = Scenes.scene(folder.resolve("s.xml"), "\n<mesh file='from/painted.obj'/>");
        assertThat(Run.cli("validate", scene).code()).isZero();
        Files.delete(folder.resolve("from/pictures/p.png"));
        String sentence = "\"from/pictures/p.png\": there is no such file beside the scene\n";
        for (String command : new String[] {"validate", "render"}) {
            Run run = Run.cli(command, scene);
            assertThat(run.code()).isEqualTo(3);
            assertThat(run.err()).endsWith("s.xml:2:7: " + sentence);
        }
        assertThat(Run.cli("validate", painted).err()).isEqualTo(painted + ": " + sentence.replace("from/", ""));
        Path gilt = Scenes.scene(folder.resolve("gilt.xml"), "<mesh file='from/painted.obj' material='gold'/>");
        assertThat(Run.cli("validate", gilt).code()).isZero();
        assertThat(Run.cli("render", gilt, "-o", folder.resolve("gilt.png"), "--size", "8x6").code()).isZero();
    }

    /** It is rendered all the same, as the model by itself is; not without a word. */
    @Test
    void materialsThatAModelLacksAreToldWhereTheSceneNamesTheModel() throws IOException {
        painted();
        Files.delete(folder.resolve("from/m.mtl"));
        Path scene = Scenes.scene(folder.resolve("s.xml"), "\n<mesh name='pot' file='from/painted.obj'/>");
        String sentence = "mesh \"pot\": its materials cannot be read: \"from/m.mtl\": there is no such file beside the scene";
        assertThat(Run.cli("validate", scene).out()).contains("s.xml:2:", ": warning: " + sentence);
        assertThat(Run.cli("validate", "--strict", scene).code()).isEqualTo(3);
        Run run = Run.cli("render", scene, "-o", folder.resolve("pot.png"), "--size", "8x6");
        assertThat(run.code()).isZero();
        assertThat(run.err()).containsOnlyOnce(scene + ": note: " + sentence);
        assertThat(Run.cli("render", scene, "-o", folder.resolve("p{frame}.png"), "--frames", "1-2", "--size", "8x6").err()).containsOnlyOnce(": note: " + sentence);
        Path many = Scenes.scene(folder.resolve("many.xml"), "<repeat count='3'><mesh file='from/painted.obj' position='{i} 0 0'/></repeat><union><mesh file='from/painted.obj'/><sphere radius='1'/></union>");
        assertThat(Run.cli("render", many, "-o", folder.resolve("many.png"), "--size", "8x6").err()).as("once of a file").containsOnlyOnce(": note: mesh ");
        Path gilt = Scenes.scene(folder.resolve("gilt.xml"), "<mesh file='from/painted.obj' material='gold'/>");
        assertThat(Run.cli("render", gilt, "-o", folder.resolve("gilt.png"), "--size", "8x6").err()).doesNotContain("note");
    }

    @Test
    void aPartWithoutANameIsListedAsOne() throws IOException {
        Path parts = Files.writeString(folder.resolve("parts.obj"), OBJ + "g lid\nf 1 2 3\n");
        assertThat(Run.cli("info", parts).out()).contains("parts       2: \"\", lid\n");
    }

    /** Whatever it is called. */
    @Test
    void aPackedModelIsToldToBeUnpacked() throws IOException {
        for (String name : new String[] {"packed.obj", "packed.ply", "packed.obj.gz"}) {
            try (OutputStream packed = new GZIPOutputStream(Files.newOutputStream(folder.resolve(name)))) {
                packed.write(OBJ.getBytes(StandardCharsets.UTF_8));
            }
            assertThat(Run.cli("info", folder.resolve(name)).err()).isEqualTo(folder.resolve(name) + ": this is a packed file; unpack it first\n");
            Path scene = Scenes.scene(folder.resolve("s.xml"), "<mesh file='" + name + "'/>");
            assertThat(Run.cli("validate", scene).err()).endsWith("\"" + name + "\": this is a packed file; unpack it first\n");
        }
    }

    @Test
    void whatAModelNeedsGoesToTheOtherFolderToo() throws IOException {
        Path painted = painted();
        Path to = Files.createDirectories(folder.resolve("to"));
        for (String name : new String[] {"painted.xml", "painted.pov"}) {
            assertThat(Run.cli("convert", painted, to.resolve(name), "-q")).satisfies(run -> assertThat(run.code()).as(run.err()).isZero());
        }
        for (String name : new String[] {"painted.obj", "m.mtl", "pictures/p.png"}) {
            assertThat(to.resolve(name)).hasSameBinaryContentAs(folder.resolve("from").resolve(name));
        }
        assertThat(Run.cli("render", painted, "-o", folder.resolve("a.ppm"), "--size", "32x24").code()).isZero();
        assertThat(Run.cli("render", to.resolve("painted.xml"), "-o", folder.resolve("b.ppm"), "--size", "32x24").code()).isZero();
        assertThat(folder.resolve("b.ppm")).hasSameBinaryContentAs(folder.resolve("a.ppm"));
    }

    @Test
    void filesOfOthersAreNotOverwritten() throws IOException {
        Path painted = painted();
        Path to = folder.resolve("to");
        Files.createDirectories(to.resolve("pictures"));
        Files.writeString(to.resolve("pictures/p.png"), "somebody's");
        Run run = Run.cli("convert", painted, to.resolve("painted.xml"));
        assertThat(run.code()).isEqualTo(1);
        assertThat(run.err()).isEqualTo(to.resolve("painted.xml") + ": there is another picture pictures/p.png beside it; give one of them another name\n");
        assertThat(to.resolve("pictures/p.png")).hasContent("somebody's");
        assertThat(to.resolve("painted.xml")).doesNotExist();
        Path csg = Files.writeString(folder.resolve("thing.csg"), "linear_extrude(height=1,twist=0,scale=[2,1]) { square(size=[1,1],center=false); }");
        Files.writeString(folder.resolve("thing-1.obj"), OBJ);
        assertThat(Run.cli("convert", csg, folder.resolve("thing.xml")).err()).contains("there is another mesh thing-1.obj beside it").hasLineCount(1);
        assertThat(folder.resolve("thing-1.obj")).hasContent(OBJ);
        assertThat(Run.cli("convert", csg, to.resolve("thing.xml")).code()).isZero();
        assertThat(Run.cli("convert", csg, to.resolve("thing.xml")).code()).as("once more, the same").isZero();
    }

    @Test
    void trianglesGoFromFormatToFormat() {
        Path stl = folder.resolve("corner.stl");
        Path back = folder.resolve("back.obj");
        assertThat(Run.cli("convert", obj, stl).code()).isZero();
        assertThat(Run.cli("convert", stl, back).code()).isZero();
        assertThat(Run.cli("info", back).out()).contains("volume      10").contains("vertices 4");
        assertThat(Run.cli("convert", stl, folder.resolve("a.pov"), "-q").code()).isZero();
        assertThat(folder.resolve("a.pov")).content().contains("mesh2");
    }

    @Test
    void openScadBecomesBodiesOfOurs() throws IOException {
        Path csg = Files.writeString(folder.resolve("thing.csg"), """
                difference() {
                    cube(size = [2, 2, 2], center = true);
                    sphere(r = 1.2);
                }
                hull() { cube(size=1); }
                linear_extrude(height=1,twist=90,slices=9,scale=[1,1]) { square(size=[1,1],center=false); }
                linear_extrude(height=1,twist=0,scale=[2,1]) { square(size=[1,1],center=false); }
                """);
        Path scene = folder.resolve("thing.xml");
        Run run = Run.cli("convert", csg, scene);
        assertThat(run.code()).isZero();
        assertThat(run.err()).isEqualTo(csg + ": note: line 5: hull() is not read, and left out\n");
        assertThat(scene).content().contains("<difference", "<sphere radius=\"1.2\"/>", "twist=\"-90\"", "<mesh file=\"thing-1.obj\"");
        assertThat(Run.cli("validate", "--strict", scene).code()).isZero();
        assertThat(Run.cli("explain", csg, "400,300", "--samples", "1").code()).isZero();
    }

    @Test
    void whatIsWrongIsOneLine() throws IOException {
        Path bad = Files.writeString(folder.resolve("bad.stl"), "solid x\nfacet\nvertex 1 2\n");
        for (Run run : new Run[] {Run.cli("render", bad, "-o", folder.resolve("x.png")), Run.cli("info", bad), Run.cli("validate", bad), Run.cli("convert", bad, folder.resolve("x.xml")),
            Run.cli("explain", bad, "1,1")}) {
            assertThat(run.code()).isEqualTo(3);
            assertThat(run.err()).isEqualTo(bad + ": line 3: z of a corner is missing\n");
        }
    }
}
