package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.format.model.Model;
import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.PointLight;
import cz.paprsek.shape.mesh.Triangles;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** glTF files made here, and what comes of them. */
class GltfTest {
    private static final Triangles BLOCK = Solids.block(2, 3, 4);
    private static final String ACCESSORS = "'bufferViews':[{'buffer':0,'byteLength':96},{'buffer':0,'byteOffset':96,'byteLength':72}],"
            + "'accessors':[{'bufferView':0,'componentType':5126,'count':8,'type':'VEC3'},{'bufferView':1,'componentType':5123,'count':36,'type':'SCALAR'}],";
    private static final String MESH = "'meshes':[{'name':'block','primitives':[{'attributes':{'POSITION':0},'indices':1}]}]";
    static final String HEAD = "{'asset':{'version':'2.0'},'buffers':[{'byteLength':168,'uri':'%s'}]," + ACCESSORS;

    /** The places and the corners of the block. */
    static byte[] bytes() {
        ByteBuffer bytes = ByteBuffer.allocate(168).order(ByteOrder.LITTLE_ENDIAN);
        for (int v = 0; v < 8; v++) {
            bytes.putFloat((float) BLOCK.x(v)).putFloat((float) BLOCK.y(v)).putFloat((float) BLOCK.z(v));
        }
        for (int t = 0; t < 12; t++) {
            for (int k = 0; k < 3; k++) {
                bytes.putShort((short) BLOCK.corner(t, k));
            }
        }
        return bytes.array();
    }

    static String embedded(String rest) {
        return (String.format(HEAD, "data:application/octet-stream;base64," + Base64.getEncoder().encodeToString(bytes())) + rest + "}").replace('\'', '"');
    }

    static byte[] inOnePiece(String json) {
        byte[] text = json.replace('\'', '"').getBytes(StandardCharsets.UTF_8);
        byte[] bytes = bytes();
        int padded = (text.length + 3) / 4 * 4;
        ByteBuffer file = ByteBuffer.allocate(28 + padded + bytes.length).order(ByteOrder.LITTLE_ENDIAN);
        file.putInt(0x46546C67).putInt(2).putInt(file.capacity()).putInt(padded).putInt(0x4E4F534A).put(text);
        while (file.position() < 20 + padded) {
            file.put((byte) ' ');
        }
        return file.putInt(bytes.length).putInt(0x004E4942).put(bytes).array();
    }

    @Test
    void aBlockIsTheSameEmbeddedBesideAndInOnePiece() throws IOException {
        String rest = "'nodes':[{'mesh':0}],'scenes':[{'nodes':[0]}]," + MESH;
        String beside = (String.format(HEAD, "a%20b.bin") + rest + "}").replace('\'', '"');
        String chunk = (HEAD.replace(",'uri':'%s'", "") + rest + "}").replace('\'', '"');
        for (Model model : new Model[] {Read.text(ForeignFormat.GLTF, embedded(rest)), Read.bytes(ForeignFormat.GLTF, inOnePiece(chunk)),
            Read.bytes(ForeignFormat.GLTF, beside.getBytes(StandardCharsets.UTF_8), Map.of("a b.bin", bytes()))}) {
            assertThat(model.triangles().volume()).isEqualTo(24);
            assertThat(model.triangles().openEdges()).isZero();
            assertThat(model.triangles().parts()).containsExactly("block");
        }
        assertThat(ForeignFormat.of("what.ever", inOnePiece(chunk))).contains(ForeignFormat.GLTF);
    }

    /** Scaled by 2, 1, 1, turned by 90° about z, moved by 10; and once more within a mirror. */
    @Test
    void nodesPutMeshesWhereTheyAreToBe() throws IOException {
        Model model = Read.text(ForeignFormat.GLTF, embedded("'nodes':[{'children':[1,2]},"
                + "{'mesh':0,'name':'here','translation':[10,0,0],'rotation':[0,0,0.7071067811865476,0.7071067811865476],'scale':[2,1,1]},"
                + "{'mesh':0,'matrix':[-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}],'scene':0,'scenes':[{'nodes':[0]}]," + MESH));
        assertThat(model.triangles().parts()).containsExactly("here", "block");
        Triangles here = model.triangles().onlyPart(0);
        assertThat(here.bounds().minX()).isCloseTo(7, within(1e-6));
        assertThat(here.bounds().maxY()).isCloseTo(4, within(1e-6));
        assertThat(here.volume()).isCloseTo(48, within(1e-4));
        assertThat(model.triangles().onlyPart(1).volume()).as("a mirror turns the corners round").isCloseTo(24, within(1e-6));
    }

    @Test
    void someElementsMayBeSaidApart() throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(12 + 36).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put((byte) 0).put((byte) 1).put((byte) 2).position(12);
        for (float f : new float[] {0, 0, 0, 4, 0, 0, 0, 5, 0}) {
            bytes.putFloat(f);
        }
        String json = ("{'asset':{'version':'2.0'},'buffers':[{'byteLength':48,'uri':'data:;base64," + Base64.getEncoder().encodeToString(bytes.array()) + "'}],"
                + "'bufferViews':[{'buffer':0,'byteLength':3},{'buffer':0,'byteOffset':12,'byteLength':36}],'accessors':[{'componentType':5126,'count':3,'type':'VEC3',"
                + "'sparse':{'count':3,'indices':{'bufferView':0,'componentType':5121},'values':{'bufferView':1}}}],"
                + "'nodes':[{'mesh':0}],'meshes':[{'primitives':[{'attributes':{'POSITION':0}}]}]}").replace('\'', '"');
        assertThat(Read.text(ForeignFormat.GLTF, json).triangles().area()).isEqualTo(10);
    }

    @Test
    void materialsLightsAndCamerasComeAlong() throws IOException {
        Model model = Read.text(ForeignFormat.GLTF, embedded("'nodes':[{'mesh':0},{'camera':0,'name':'eye','translation':[0,0,9]},{'translation':[1,2,3],'extensions':{'KHR_lights_punctual':{'light':0}}}],"
                + "'cameras':[{'type':'perspective','perspective':{'yfov':0.5,'znear':0.1}}],'extensionsUsed':['KHR_lights_punctual','X_other'],"
                + "'extensions':{'KHR_lights_punctual':{'lights':[{'type':'point','intensity':31.41592653589793,'color':[1,0.5,0]}]}},"
                + "'materials':[{'name':'glass','pbrMetallicRoughness':{'metallicFactor':0,'roughnessFactor':0.1},'extensions':{'KHR_materials_transmission':{'transmissionFactor':1},"
                + "'KHR_materials_ior':{'ior':1.4},'KHR_materials_volume':{'thicknessFactor':1,'attenuationDistance':2,'attenuationColor':[0.5,1,0.01]}}}],"
                + "'meshes':[{'primitives':[{'attributes':{'POSITION':0},'indices':1,'material':0}]}]"));
        Material glass = Optional.ofNullable(model.materials().get("glass")).orElseThrow();
        assertThat(glass.transparency()).isEqualTo(1);
        assertThat(glass.refractiveIndex()).isEqualTo(1.4);
        assertThat(glass.roughness()).isEqualTo(0.1);
        // After d, light is 0.5^(d/2), 1 and 0.01^(d/2) of what it was; ours is exp(−(1 − c)·d/D).
        double[] linear = {glass.attenuationColor().linearRed(), glass.attenuationColor().linearGreen(), glass.attenuationColor().linearBlue()};
        double[] expected = {0.5, 1, 0.01};
        for (int i = 0; i < 3; i++) {
            assertThat(Math.exp(-(1 - linear[i]) * 3 / glass.attenuationDistance())).isCloseTo(Math.pow(expected[i], 1.5), within(1e-9));
        }
        assertThat(model.cameras()).singleElement().satisfies(eye -> assertThat(eye.position()).isEqualTo(new Vec3(0, 0, 9)));
        assertThat(model.lights()).singleElement().isInstanceOfSatisfying(PointLight.class, light -> {
            assertThat(light.intensity()).isCloseTo(10, within(1e-9));
            assertThat(light.referenceDistance()).isEqualTo(1);
        });
        assertThat(model.notes()).containsExactly("extensionsUsed: \"X_other\" is not understood");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "{'asset':{'version':'2.0'} | byte 26: here must be \"}\", but is the end",
        "{'asset':{'version':'1.0'}} | asset.version: version 2.0 is read, but this is \"1.0\"",
        "{'asset':{'version':'2.0'},'extensionsRequired':['KHR_draco_mesh_compression']} | extensionsRequired: \"KHR_draco_mesh_compression\" is not understood",
        "{'a':1,'a':2} | byte 7: \"a\" is here for the second time",
        "{} | the document: here must be \"asset\" with the version of the format",
        "[] | the document: this must be an object in { }",
        "{'asset':{'version':'2.0'},'nodes':[{'children':[1]},{'children':[0]}],'scenes':[{'nodes':[0]}]} | nodes[0]: this node is within itself, or has two parents",
        "{'asset':{'version':'2.0'},'scenes':[{'nodes':[0]}]} | scenes[0].nodes: these are numbers of things of which there are none",
        "{'asset':{'version':'2.0'},'nodes':[{'children':[7]}]} | nodes[0].children: these must be whole numbers from 0 to 0",
        "{'asset':{'version':'2.0'},'nodes':[{'mesh':3}]} | the document: there is no meshes[3], but 0 of them",
        "{'asset':{'version':'2.0'}} | the document: there is no triangle in the scene of this file",
        "{'asset':{'version':'2.0'},'nodes':[{'mesh':0}],'accessors':[{'componentType':5126,'count':4000000000,'type':'VEC3'}],'meshes':[{'primitives':[{'attributes':{'POSITION':0}}]}]} "
            + "| accessors[0].count: this must be a whole number from 0 to 2147483647",
        "{'asset':{'version':'2.0'},'nodes':[{'mesh':0}],'accessors':[{'componentType':5126,'count':400000000,'type':'VEC3'}],'meshes':[{'primitives':[{'attributes':{'POSITION':0}}]}]} "
            + "| accessors[0].count: these are 400000000 elements without bytes",
        "{'asset':{'version':'2.0'},'nodes':[{'mesh':0}],'buffers':[{'byteLength':4,'uri':'../x'}],'bufferViews':[{'buffer':0,'byteLength':4}],"
            + "'accessors':[{'bufferView':0,'componentType':5126,'count':1,'type':'VEC3'}],'meshes':[{'primitives':[{'attributes':{'POSITION':0}}]}]} | buffers[0].uri: \"../x\": there is no such file",
    })
    void whatIsWrongIsSaidWithItsPlace(String json, String sentence) {
        assertThat(Read.fault(ForeignFormat.GLTF, json.replace('\'', '"'))).startsWith(sentence);
    }

    @Test
    void numbersThatLeadAstrayAreRefused() {
        String rest = "'nodes':[{'mesh':0}]," + MESH;
        assertThat(Read.fault(ForeignFormat.GLTF, embedded(rest).replace("\"count\":8", "\"count\":9"))).isEqualTo("accessors[0]: these 9 elements reach to byte 108 of a view of 96, 12 bytes apart");
        assertThat(Read.fault(ForeignFormat.GLTF, embedded(rest).replace("\"count\":8", "\"count\":7"))).isEqualTo("accessors[1]: element 8 is vertex 7, but there are 7 vertices");
        byte[] cut = inOnePiece(HEAD.replace(",'uri':'%s'", "") + rest + "}");
        assertThat(Read.fault(ForeignFormat.GLTF, Arrays.copyOf(cut, 200))).startsWith("byte 8: the file says it has ");
        assertThat(Read.fault(ForeignFormat.GLTF, "[".repeat(100_000))).isEqualTo("byte 101: this is nested deeper than 100");
    }
}
