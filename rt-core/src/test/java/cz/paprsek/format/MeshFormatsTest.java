package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.model.Model;
import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.mesh.Triangles;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** What is in files of triangles: against volumes, areas and counts that are known. */
class MeshFormatsTest {
    private static final Triangles BLOCK = Solids.block(2, 3, 4);
    private static final String HEAD = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    static Stream<Arguments> ways() {
        return Stream.of(Arguments.of(ForeignFormat.STL, "text", Solids.stlText(BLOCK).getBytes(StandardCharsets.US_ASCII)),
                Arguments.of(ForeignFormat.STL, "bytes", Solids.stlBytes(BLOCK, "made by a test")),
                Arguments.of(ForeignFormat.STL, "bytes that begin as text does", Solids.stlBytes(BLOCK, "solid made by a test")),
                Arguments.of(ForeignFormat.OBJ, "text", Solids.obj(BLOCK).getBytes(StandardCharsets.US_ASCII)),
                Arguments.of(ForeignFormat.OFF, "text", Solids.off(BLOCK).getBytes(StandardCharsets.US_ASCII)),
                Arguments.of(ForeignFormat.PLY, "text", Solids.ply(BLOCK, null)),
                Arguments.of(ForeignFormat.PLY, "high bytes first", Solids.ply(BLOCK, ByteOrder.BIG_ENDIAN)),
                Arguments.of(ForeignFormat.PLY, "low bytes first", Solids.ply(BLOCK, ByteOrder.LITTLE_ENDIAN)));
    }

    @ParameterizedTest(name = "{0}, {1}")
    @MethodSource("ways")
    void aBlockIsTheSameInEveryFormat(ForeignFormat format, String how, byte[] file) throws IOException {
        Triangles read = Read.bytes(format, file).triangles();
        assertThat(read.count()).isEqualTo(12);
        assertThat(read.vertexCount()).as("corners in one place are one").isEqualTo(8);
        assertThat(read.openEdges()).isZero();
        assertThat(read.volume()).isEqualTo(24);
        assertThat(read.area()).isEqualTo(52);
        assertThat(read.bounds()).isEqualTo(BLOCK.bounds());
        assertThat(ForeignFormat.of("x." + format.endings().get(0), Read.part(file, 0, Math.min(file.length, 1024)))).contains(format);
    }

    /** Pappus: 2π²Rr² and 4π²Rr, less what the chords cut off. */
    @Test
    void aRingHasTheSpaceAndSurfaceOfOne() throws IOException {
        Triangles ring = Read.bytes(ForeignFormat.STL, Solids.stlBytes(Solids.torus(3, 1, 600, 300), "ring")).triangles();
        assertThat(ring.openEdges()).isZero();
        assertThat(ring.volume() / (6 * Math.PI * Math.PI)).isCloseTo(1, within(1e-4));
        assertThat(ring.area() / (12 * Math.PI * Math.PI)).isCloseTo(1, within(1e-4));
    }

    @ParameterizedTest
    @CsvSource({"\\n", "\\r\\n", "\\r"})
    void linesMayEndAsOnAnySystem(String end) throws IOException {
        String text = (HEAD + "# the next one goes on\nf 1 2 \\\n 3 4\nf 4 3 2 1\n").replace("\n", end.translateEscapes());
        for (byte[] file : List.of(text.getBytes(StandardCharsets.UTF_8), ("\uFEFF" + text).getBytes(StandardCharsets.UTF_8), ("\uFEFF" + text).getBytes(StandardCharsets.UTF_16LE),
                ("\uFEFF" + text).getBytes(StandardCharsets.UTF_16BE), text.getBytes(StandardCharsets.UTF_16LE))) {
            assertThat(Read.bytes(ForeignFormat.OBJ, file).triangles().count()).isEqualTo(4);
        }
        assertThat(Read.fault(ForeignFormat.OBJ, text + "f 1 2 9" + end.translateEscapes())).startsWith("line 9: a corner names vertex 9, but so far there are 4 vertices");
    }

    @Test
    void remarksMayStandBehindWhatALineSays() throws IOException {
        Model model = Read.text(ForeignFormat.OBJ, """
                v 0 0 0 # a
                v 1 0 0 # b 1 2 3
                v 0 1 0\t# c
                v 1 1 1 0.5 #
                vn 0 0 1 # up
                vt 0 0 # corner
                s 1 # smooth
                f 1 2 3 # first
                f 1/1 2/1 3/1 4/1 #4
                f 1//1 2//1 4//1\t# 9
                f 1 3 \\
                 4 # joined
                """);
        assertThat(model.triangles().count()).isEqualTo(5);
        assertThat(model.notes()).isEmpty();
        assertThat(Read.fault(ForeignFormat.OBJ, "v 0 0 0\nv 1 0 0\nf 1 2 # 3")).isEqualTo("line 3: a face needs at least three corners, but this one has 2");
    }

    @Test
    void aConcaveFaceIsCutWithoutLeavingIt() throws IOException {
        // An arrow: a fan from its first corner would cover more than it.
        Triangles arrow = Read.text(ForeignFormat.OBJ, "v 0 0 5\nv 2 1 5\nv 0 2 5\nv 0.5 1 5\nf 2 3 4 1\nf -4 -1 -2 -3\n").triangles();
        assertThat(arrow.count()).isEqualTo(4);
        assertThat(arrow.area()).isCloseTo(2 * 1.5, within(1e-12));
        assertThat(arrow.openEdges()).isZero();
    }

    /** A spiral of two arms, of which a fan covers far more than it. */
    @Test
    void aLongSpiralIsCutIntoItsOwnArea() throws IOException {
        StringBuilder text = new StringBuilder();
        int steps = 3000;
        double expected = 0;
        double[][] places = new double[2 * steps][];
        for (int i = 0; i < 2 * steps; i++) {
            boolean isOut = i < steps;
            double turn = (isOut ? i : 2 * steps - 1 - i) * 0.01;
            double radius = turn + (isOut ? 0 : 1);
            places[i] = new double[] {radius * Math.cos(turn), radius * Math.sin(turn)};
            text.append("v ").append(places[i][0]).append(" 7 ").append(-places[i][1]).append('\n');
        }
        for (int i = 0; i < places.length; i++) {
            double[] next = places[(i + 1) % places.length];
            expected += (places[i][0] * next[1] - places[i][1] * next[0]) / 2;
        }
        text.append('f');
        for (int i = 1; i <= places.length; i++) {
            text.append(' ').append(i);
        }
        Triangles spiral = Read.text(ForeignFormat.OBJ, text.append('\n').toString()).triangles();
        assertThat(spiral.count()).isEqualTo(2 * steps - 2);
        assertThat(spiral.area()).isCloseTo(Math.abs(expected), within(1e-6));
    }

    @Test
    void groupsAndMaterialsAreParts() throws IOException {
        Model model = Read.bytes(ForeignFormat.OBJ, (HEAD + "mtllib sub/a b.mtl\no lid\nusemtl red\nf 1 2 3\nusemtl glass\nf 1 3 4\no pot\nf 4 3 1\no lid\nusemtl red\nf 3 2 1\n").getBytes(StandardCharsets.UTF_8),
                Map.of("sub/a b.mtl", "newmtl red\nKd 1 0 0\nmap_Kd .\\tex\\red.png\nnewmtl glass\nd 0.25\nNi 1.5\nNs 200\nKs .5 .5 .5\nillum 7\n".getBytes(StandardCharsets.UTF_8)));
        assertThat(model.triangles().parts()).containsExactly("lid", "lid glass", "pot");
        assertThat(model.materialOf()).containsOnly(Map.entry("lid", "red"), Map.entry("lid glass", "glass"), Map.entry("pot", "glass"));
        assertThat(model.triangles().part(3)).isZero();
        assertThat(material(model, "red").files()).containsExactly("tex/red.png");
        assertThat(material(model, "glass").transparency()).isEqualTo(0.75);
        assertThat(material(model, "glass").refractiveIndex()).isEqualTo(1.5);
    }

    /** Where it lay on another machine says nothing here; what lies where it should counts first. */
    @ParameterizedTest
    @CsvSource({"C:\\tex\\red.png, red.png, red.png", "../maps/red.png, red.png, red.png", "maps/red.png, red.png maps/red.png, maps/red.png", "maps/red.png, blue.png, maps/red.png"})
    void aPictureIsLookedForBesideTheModelToo(String written, String there, String found) throws IOException {
        Map<String, byte[]> beside = new HashMap<>(Map.of("m.mtl", ("newmtl red\nmap_Kd " + written + "\n").getBytes(StandardCharsets.UTF_8)));
        Stream.of(there.split(" ")).forEach(name -> beside.put(name, new byte[0]));
        Model model = Read.bytes(ForeignFormat.OBJ, (HEAD + "mtllib m.mtl\nusemtl red\nf 1 2 3\n").getBytes(StandardCharsets.UTF_8), beside);
        assertThat(material(model, "red").files()).containsExactly(found);
    }

    /** What only might have been meant, or no face shows, is none of the files that a scene needs. */
    @Test
    void whereAPictureIsIsFoundOutWithoutReadingIt() throws IOException {
        byte[] materials = """
                newmtl red
                map_Kd maps/red.png
                newmtl blue
                map_Kd maps/blue.png
                """.getBytes(StandardCharsets.UTF_8);
        byte[] any = {};
        Assets assets = Assets.of(Map.of("m.obj", (HEAD + "mtllib m.mtl\nusemtl red\nf 1 2 3\n").getBytes(StandardCharsets.UTF_8), "m.mtl", materials,
                "maps/red.png", any, "red.png", any, "maps/blue.png", any, "blue.png", any));
        assertThat(Mesh.of("m.obj").read(MeshFiles.whole("m.obj", assets)).companions()).containsExactlyInAnyOrder("m.mtl", "maps/red.png");
        assertThat(assets.digests()).containsOnlyKeys("m.obj", "m.mtl");
    }

    private static Material material(Model model, String name) {
        return Optional.ofNullable(model.materials().get(name)).orElseThrow();
    }

    @Test
    void smoothingGroupsShareNormalsWithinThemOnly() throws IOException {
        String roof = "v 0 0 0\nv 0 0 1\nv 1 1 0\nv 1 1 1\nv 2 0 0\nv 2 0 1\n";
        Triangles smooth = Read.text(ForeignFormat.OBJ, roof + "s 1\nf 1 2 4 3\nf 3 4 6 5\n").triangles();
        assertThat(smooth.vertexCount()).isEqualTo(6);
        assertThat(normalsAt(smooth, 1, 1, 0)).singleElement().satisfies(up -> assertThat(up.minus(Vec3.Y).length()).isLessThan(1e-6));
        Triangles two = Read.text(ForeignFormat.OBJ, roof + "s 1\nf 1 2 4 3\ns 2\nf 3 4 6 5\n").triangles();
        assertThat(normalsAt(two, 1, 1, 0)).hasSize(2);
        assertThat(Read.text(ForeignFormat.OBJ, roof + "s off\nf 1 2 4 3\nf 3 4 6 5\n").triangles().hasNormals()).isFalse();
    }

    private static List<Vec3> normalsAt(Triangles mesh, double x, double y, double z) {
        return Stream.iterate(0, v -> v < mesh.vertexCount(), v -> v + 1).filter(v -> mesh.place(v).equals(new Vec3(x, y, z))).map(v -> mesh.normal(v).normalized()).distinct().toList();
    }

    @Test
    void placesInPicturesAndNormalsAreThoseOfTheCorner() throws IOException {
        Triangles mesh = Read.text(ForeignFormat.OBJ, HEAD + "vt 0.25 0.5\nvt 0.75\nvn 0 0 2\nf 1/1/1 2/2/1 3/-2/-1\nf 1//1 3//1 4//1\n").triangles();
        assertThat(mesh.vertexCount()).isEqualTo(6);
        assertThat(mesh.u(mesh.corner(0, 1))).isEqualTo(0.75f);
        assertThat(mesh.v(mesh.corner(0, 2))).isEqualTo(0.5f);
        assertThat(mesh.normal(mesh.corner(1, 2))).isEqualTo(new Vec3(0, 0, 2));
        assertThat(mesh.openEdges()).as("vertices in one place are joined").isEqualTo(4);
    }

    @Test
    void facesOfPlyHaveTheirColoursOnVerticesOfTheirOwn() throws IOException {
        Model model = Read.text(ForeignFormat.PLY, """
                ply
                format ascii 1.0
                element vertex 4
                property float x
                property float y
                property float z
                element face 2
                property list uchar uint vertex_index
                property uchar red
                property uchar green
                property uchar blue
                end_header
                0 0 0
                1 0 0
                1 1 0
                0 1 0
                3 0 1 2 255 0 0
                3 0 2 3 0 0 255
                """);
        Triangles mesh = model.triangles();
        assertThat(mesh.vertexCount()).isEqualTo(6);
        assertThat(mesh.openEdges()).as("two are joined").isEqualTo(4);
        for (int k = 0; k < 3; k++) {
            assertThat(mesh.color(mesh.corner(0, k))).isEqualTo(new Vec3(1, 0, 0));
            assertThat(mesh.color(mesh.corner(1, k))).isEqualTo(new Vec3(0, 0, 1));
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "STL | solid x\\nfacet\\nvertex 1 2 nan | line 3: z of a corner must be a number, but is \"nan\"",
        "STL | solid x\\nfacet\\nvertex 1 2 | line 3: z of a corner is missing",
        "STL | solid x\\nendsolid | the end: there is no triangle in this file",
        "STL | solid x\\nfacet\\nouter loop\\nvertex 1 2 3\\nendloop\\nendfacet | line 6: a triangle has three corners, but this one has 1",
        "STL | solid x\\nfacet\\nvertx 1 2 3 | line 3: here must be one of facet, outer loop, vertex, endloop, endfacet, solid, endsolid, but is \"vertx\"",
        "STL | short | byte 5: the file ends here, but an STL file in bytes has a head of 84; and a text begins with \"solid\"",
        "OBJ | v 1 2 | line 1: z of a vertex is missing",
        "OBJ | v 1 2 1e999 | line 1: z of a vertex must be a number, but is \"1e999\"",
        "OBJ | v 1 2 0x7 | line 1: z of a vertex must be a number, but is \"0x7\"",
        "OBJ | v 1 2 3\\nf 1 1 | line 2: a face needs at least three corners, but this one has 2",
        "OBJ | v 1 2 3\\nf 1 1 99999999999 | line 2: a corner names vertex 99999999999, but so far there are 1 vertices",
        "OBJ | v 1 2 3\\nf 1 1 0 | line 2: a corner names vertex 0, but so far there are 1 vertices",
        "OBJ | v 1 2 3\\nf 1 1 -2 | line 2: a corner names vertex -2, but so far there are 1 vertices",
        "OBJ | v 1 2 3\\nf 1/2 1 1 | line 2: a corner names place in a picture 2, but so far there are 0 of them",
        "OBJ | v 1 2 3 | the end: there is no face in this file, only 1 vertices",
        "PLY | ply\\nformat ascii 1.0\\nelement vertex 4000000000\\nproperty int x\\nend_header\\n | line 5: the file says it has 4000000000 times \"vertex\", but is only",
        "PLY | ply\\nformat ascii 1.0\\nelement vertex 1\\nproperty int x\\nproperty int y\\nproperty int z\\nend_header\\n1 2 3 | the end: there is no face in this file, only 1 vertices",
        "PLY | ply\\nelement vertex 1\\nend_header\\n | line 3: before the end of the head must be a line \"format\"",
        "PLY | ply\\nformat ascii 1.0\\nelement face 1\\nproperty list float int vertex_index\\nend_header\\n | line 4: the length of a list must be a whole number",
        "PLY | ply\\nformat ascii 1.0\\nelement vertex 2\\nproperty int x\\nproperty int y\\nproperty int z\\nend_header\\n1 2 3\\n1 2 | line 9: the file ends before all of its 2 times \"vertex\"",
        "PLY | plx\\n | line 1: a PLY file begins with the line \"ply\"",
        "OFF | OFF BINARY\\n | line 1: an OFF file that is text, and of three dimensions, begins with \"OFF\"",
        "OFF | 4OFF\\n | line 1: an OFF file that is text, and of three dimensions, begins with \"OFF\"",
        "OFF | OFF\\n4000000000 1 0\\n | line 2: the file says it has 4000000000 vertices, but is only",
        "OFF | OFF\\n1 | the end: the number of faces is missing",
        "OFF | OFF 2 1 0\\n0 0 0\\n0 0 | line 3: z of a vertex is missing",
        "OFF | OFF 1 1 0\\n0 0 0\\n | the end: here are 0 of 1 faces",
        "OFF | OFF 1 1 0\\n0 0 0\\n3 0 0 1\\n | line 3: a corner is vertex 1, but vertices have numbers from 0 to 0",
        "OFF | OFF 1 1 0\\n0 0 0\\n3 0 0\\n | line 3: a face of 3 corners needs as many numbers of vertices, but has 2",
        "OFF | NOFF 1 1 0\\n0 0 0 1 0\\n | line 2: a vertex must have 3 numbers after its place, but has 2",
        "OFF | COFF 1 1 0\\n0 0 0 255\\n | line 2: a vertex must have 3 or 4 numbers after its place, but has 1",
        "OFF | OFF 1 0 0\\n0 0 0 | the end: there is no face in this file, only 1 vertices",
    })
    void whatIsWrongIsSaidWithItsPlace(ForeignFormat format, String file, String sentence) {
        assertThat(Read.fault(format, file.translateEscapes())).startsWith(sentence);
    }

    @Test
    void countsOfFourBillionAreRefusedAtOnce() {
        byte[] stl = Solids.stlBytes(BLOCK, "");
        Arrays.fill(stl, 80, 84, (byte) 0xFF);
        assertThat(Read.fault(ForeignFormat.STL, stl)).isEqualTo("byte 80: the file says it has 4294967295 triangles, but there is room for 12");
        byte[] cut = Read.part(Solids.stlBytes(BLOCK, ""), 0, 200);
        assertThat(Read.fault(ForeignFormat.STL, cut)).isEqualTo("byte 80: the file says it has 12 triangles, but there is room for 2");
    }
}
