package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.model.Model;
import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.mesh.Triangles;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Colours that files have for each vertex, or for each triangle. */
class VertexColorsTest {
    private static final String PLY = """
            ply
            format ascii 1.0
            element vertex 4
            property float x
            property float y
            property float z
            property %s red
            property %s green
            property %s blue
            element face 2
            property list uchar uint vertex_index
            end_header
            """;

    private static void assertColor(Vec3 found, double red, double green, double blue) {
        assertThat(found.minus(new Vec3(red, green, blue)).length()).as("%s", found).isLessThan(1e-6);
    }

    @Test
    void thoseOfPlyAndObjAreReadFromSrgb() throws IOException {
        String places = "0 0 0 %s 1 0 0 %s 1 1 0 %s 0 1 0 %s 3 0 1 2 3 0 2 3";
        Triangles bytes = Read.text(ForeignFormat.PLY, PLY.replace("%s", "uchar") + String.format(places, "255 0 0", "0 128 0", "0 0 64", "255 255 255")).triangles();
        Triangles floats = Read.text(ForeignFormat.PLY, PLY.replace("%s", "float") + String.format(places, "1 0 0", "0 0.501960784 0", "0 0 0.250980392", "1 1 1")).triangles();
        Triangles obj = Read.text(ForeignFormat.OBJ, "v 0 0 0 1 0 0\nv 1 0 0 0 0.501960784 0 # green\nv 1 1 0 0 0 \\\n0.250980392\nv 0 1 0\nf 1 2 3\nf 1 3 4\n").triangles();
        for (Triangles mesh : new Triangles[] {bytes, floats, obj}) {
            assertThat(mesh.parts()).containsExactly("");
            assertColor(mesh.color(0), 1, 0, 0);
            assertColor(mesh.color(1), 0, Rgb.linear(128), 0);
            assertColor(mesh.color(2), 0, 0, Rgb.linear(64));
            assertColor(mesh.color(3), 1, 1, 1);
        }
    }

    @Test
    void aFourthNumberOfAVertexIsItsWeightAndNoColour() throws IOException {
        assertThat(Read.text(ForeignFormat.OBJ, "v 0 0 0 1.0\nv 1 0 0 0.5\nv 1 1 0\nf 1 2 3\n").triangles().hasColors()).isFalse();
        assertThat(Read.fault(ForeignFormat.OBJ, "v 0 0 0 1 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n")).isEqualTo("line 1: blue of a vertex is missing");
    }

    /** Red in the lowest bits as Magics has it, in the highest as VisCAM; a neighbour of another colour shares places, and no vertices. */
    @Test
    void thoseOfStlAreReadAsTheHeadSays() throws IOException {
        for (boolean isMagics : new boolean[] {true, false}) {
            ByteBuffer file = ByteBuffer.allocate(84 + 3 * 50).order(ByteOrder.LITTLE_ENDIAN);
            if (isMagics) {
                file.put("COLOR=".getBytes(StandardCharsets.US_ASCII)).put((byte) 255).put((byte) 255).put((byte) 0).put((byte) 255);
            }
            int chosen = isMagics ? 0 : 0x8000;
            int[] bits = {chosen | 31, chosen | 31 << 10, 0x8000 ^ chosen};
            float[][] corners = {{0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 0, 0, 0, 1, 0, 0, 0, 1}};
            file.putInt(80, 3);
            for (int t = 0; t < 3; t++) {
                file.position(84 + 50 * t + 12);
                for (float number : corners[t]) {
                    file.putFloat(number);
                }
                file.putShort((short) bits[t]);
            }
            Triangles mesh = Read.bytes(ForeignFormat.STL, file.array()).triangles();
            assertThat(mesh.vertexCount()).isEqualTo(9);
            assertThat(mesh.openEdges()).isEqualTo(5);
            Vec3 red = new Vec3(1, 0, 0);
            Vec3 blue = new Vec3(0, 0, 1);
            for (int k = 0; k < 3; k++) {
                assertThat(mesh.color(mesh.corner(0, k))).isEqualTo(isMagics ? red : blue);
                assertThat(mesh.color(mesh.corner(1, k))).isEqualTo(isMagics ? blue : red);
                assertThat(mesh.color(mesh.corner(2, k))).as("the colour of all, or none").isEqualTo(isMagics ? new Vec3(1, 1, 0) : Vec3.ONE);
            }
        }
    }

    @Test
    void thoseOfGltfAreLinear() throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(36 + 12).order(ByteOrder.LITTLE_ENDIAN);
        for (float number : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}) {
            bytes.putFloat(number);
        }
        bytes.put(new byte[] {51, 102, (byte) 255, (byte) 255, 0, 0, 0, (byte) 128, 1, 2, 3, (byte) 255});
        Model model = Read.text(ForeignFormat.GLTF, ("{'asset':{'version':'2.0'},'buffers':[{'byteLength':48,'uri':'data:;base64," + Base64.getEncoder().encodeToString(bytes.array()) + "'}],"
                + "'bufferViews':[{'buffer':0,'byteLength':36},{'buffer':0,'byteOffset':36,'byteLength':12}],'accessors':[{'bufferView':0,'componentType':5126,'count':3,'type':'VEC3'},"
                + "{'bufferView':1,'componentType':5121,'normalized':true,'count':3,'type':'VEC4'}],'nodes':[{'mesh':0}],'meshes':[{'primitives':[{'attributes':{'POSITION':0,'COLOR_0':1}}]}]}").replace('\'', '"'));
        assertColor(model.triangles().color(0), 0.2, 0.4, 1);
        assertThat(model.notes()).containsExactly("meshes[0].primitives[0].attributes: the opacity of vertices is not read");
    }

    /** Under ambient light of 1, what is seen is the colour: mixed linearly between three corners. */
    @Test
    void betweenCornersTheyAreMixedInLinearLight() throws IOException {
        Assets assets = Assets.of(Map.of("t.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0\nf 1 2 3\n".getBytes(StandardCharsets.US_ASCII)));
        Mesh mesh = Mesh.of("t.obj").read(MeshFiles.whole("t.obj", assets));
        Image own = picture(SceneObject.of(mesh).madeOf(Inherited.INHERITED));
        for (int i = 0; i < 8; i++) {
            for (int j = 0; j < 7 - i; j++) {
                double x = (i + 0.5) / 8;
                double y = (j + 0.5) / 8;
                assertThat((double) own.red(i, 7 - j)).isCloseTo(1 - x - y, within(1e-6));
                assertThat((double) own.green(i, 7 - j)).isCloseTo(x, within(1e-6));
                assertThat((double) own.blue(i, 7 - j)).isZero();
            }
        }
        assertThat(picture(SceneObject.of(mesh).madeOf(Material.color(Rgb.WHITE))).blue(2, 5)).as("a material of the scene takes their place").isEqualTo(1);
    }

    private static Image picture(SceneObject object) {
        Scene scene = Scene.EMPTY.withSettings(new RenderSettings(8, 8, 1, 1)).withAmbient(Rgb.WHITE)
                .withCamera(Camera.lookingAt(new Vec3(0.5, 0.5, 3), new Vec3(0.5, 0.5, 0)).withLens(new Lens.Orthographic(1))).withObjects(List.of(object));
        return Renderer.render(RenderScene.of(scene), RenderOptions.of(scene), RenderMonitor.NONE).image();
    }

    /** Of three corners three textures, which POV-Ray mixes as light; over a pattern they are not told, and that is. */
    @Test
    void povRayIsToldThemOrItIsSaid() throws IOException {
        Triangles triangle = Triangles.of(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2}).withColors(new float[] {1, 0, 0, 0, 1, 0, 0, 0, 1});
        Scene scene = Scene.EMPTY.withObjects(List.of(SceneObject.of(Mesh.of("t.obj").read(new Mesh.Whole("t.obj", triangle, Map.of()))).madeOf(Inherited.INHERITED)));
        StringBuilder text = new StringBuilder();
        assertThat(PovFiles.write(scene, text)).noneMatch(sentence -> sentence.contains("corners"));
        assertThat(text).contains("texture_list { 3,", "pigment { rgb <0, 1, 0> }", "<0, 1, 2>, 0, 1, 2");
        Material striped = Material.DEFAULT.withPattern(new Pattern.Stripes(1, Rgb.WHITE, Rgb.BLACK, Pattern.Lay.NONE));
        Scene over = scene.withObjects(List.of(SceneObject.of(Mesh.of("t.obj").read(new Mesh.Whole("t.obj", triangle, Map.of("", striped)))).madeOf(Inherited.INHERITED)));
        assertThat(PovFiles.write(over, new StringBuilder())).contains("object #1: POV-Ray is told the colours of corners only over one colour, and up to white");
    }

    @Test
    void objIsWrittenWithThem() throws IOException {
        Triangles mesh = Triangles.of(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2}).withColors(new float[] {1, 0, 0, 0.25f, 0.5f, 0.75f, 0, 0, 0.001f});
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        MeshWriter.obj(mesh, text);
        Triangles again = Read.bytes(ForeignFormat.OBJ, text.toByteArray()).triangles();
        for (int v = 0; v < 3; v++) {
            assertColor(again.color(v), mesh.color(v).x(), mesh.color(v).y(), mesh.color(v).z());
        }
    }
}
