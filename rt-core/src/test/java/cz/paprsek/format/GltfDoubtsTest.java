package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Of a document that shows nothing, whatever is wrong is said, in parts that nothing shows, too; if nothing is wrong, that nothing is shown. */
class GltfDoubtsTest {
    private static final String NOTHING = "the document: there is no triangle in the scene of this file";

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "'buffers':[] | buffers: this list must not be empty",
        "'buffers':[{}] | buffers[0]: here must be \"byteLength\"",
        "'buffers':[7] | buffers[0]: this must be an object in { }",
        "'buffers':[{'byteLength':0}] | buffers[0].byteLength: this must be 1 or more, but is 0",
        "'buffers':[{'byteLength':9,'uri':'data:,x'}] | " + NOTHING,
        "'buffers':[{'byteLength':4,'uri':'data:,xxxx'}],'bufferViews':[{'buffer':0,'byteLength':4}],'accessors':[{'bufferView':0,'componentType':5126,'count':1,'type':'SCALAR'}] "
            + "| buffers[0].uri: data must be in base64",
        "'buffers':[{'byteLength':9,'uri':'data:x/y;base64,AAAA'}] | buffers[0].byteLength: these are to be 9 bytes, but are 3",
        "'buffers':[{'byteLength':9}] | " + NOTHING,
        "'buffers':[{'byteLength':9}],'bufferViews':[{'buffer':0,'byteOffset':6,'byteLength':4}] | bufferViews[0]: this reaches to byte 10, but the buffer has 9",
        "'buffers':[{'byteLength':9}],'bufferViews':[{'buffer':0,'byteLength':9}],'accessors':[{'bufferView':0,'byteOffset':2,'componentType':5126,'count':1,'type':'SCALAR'}] "
            + "| accessors[0].byteOffset: numbers of 4 bytes must begin at a multiple of that, but these begin at byte 2",
        "'buffers':[{'byteLength':9}],'bufferViews':[{'buffer':0,'byteLength':9}],'accessors':[{'bufferView':0,'componentType':5126,'count':3,'type':'SCALAR'}] "
            + "| accessors[0]: these 3 elements reach to byte 12 of a view of 9, 4 bytes apart",
        "'bufferViews':[{'buffer':1,'byteLength':4}] | bufferViews[0].buffer: there is no buffers[1], but 0 of them",
        "'accessors':[{'componentType':5124,'count':1,'type':'VEC3'}] | accessors[0].componentType: this must be one of 5120, 5121, 5122, 5123, 5125, 5126, but is \"5124\"",
        "'accessors':[{'componentType':5126,'count':1,'type':'VEC5'}] | accessors[0].type: this must be one of SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4, but is \"VEC5\"",
        "'accessors':[{'componentType':5126,'count':1,'type':'VEC3','byteOffset':4}] | accessors[0].byteOffset: this needs \"bufferView\" beside it",
        "'accessors':[{'componentType':5126,'count':1,'type':'SCALAR','normalized':true}] | accessors[0].normalized: this is for whole numbers of one or two bytes",
        "'accessors':[{'componentType':5126,'count':1,'type':'SCALAR','min':[1]}] | accessors[0]: number 0 of element 0 is 0, which is beyond what \"min\" and \"max\" say",
        "'materials':[{'alphaMode':'GLASS'}] | materials[0].alphaMode: this must be one of OPAQUE, MASK, BLEND, but is \"GLASS\"",
        "'materials':[{'normalTexture':{'index':0}}] | materials[0].normalTexture.index: there is no textures[0], but 0 of them",
        "'materials':[{'extensions':{'KHR_materials_ior':{}}}] | materials[0].extensions.KHR_materials_ior: an extension must be in the list \"extensionsUsed\"",
        "'extensionsUsed':['KHR_materials_ior'],'extensions':{'KHR_materials_ior':{}} | extensions.KHR_materials_ior: this extension has no place here",
        "'extensionsUsed':['X','X'] | extensionsUsed: \"X\" stands here twice",
        "'cameras':[{'type':'perspective'}] | cameras[0]: here must be \"perspective\"",
        "'cameras':[{'type':'orthographic','orthographic':{'xmag':1,'ymag':0,'znear':0,'zfar':1}}] | cameras[0].orthographic.ymag: this must not be 0",
        "'cameras':[{'type':'orthographic','orthographic':{'xmag':-1,'ymag':1,'znear':0,'zfar':1}}] | " + NOTHING,
        "'scene':-1 | scene: this must be a whole number from 0 to 2147483647, but is -1",
        "'meshes':[{'primitives':[{'mode':0,'attributes':{'X_y:Z':0}}]}],'accessors':[{'componentType':5126,'count':1,'type':'SCALAR'}],'extensionsUsed':['X_y'] | " + NOTHING,
        "'meshes':[{'primitives':[{'mode':0,'attributes':{'X_y:Z':0}}]}],'accessors':[{'componentType':5126,'count':1,'type':'SCALAR'}] "
            + "| meshes[0].primitives[0].attributes: \"X_y:Z\" is no attribute of vertices",
        "'cameras':[{'type':'perspective','perspective':{'yfov':1,'znear':2,'zfar':1}}] | cameras[0].perspective.zfar: this must be above znear",
        "'images':[{}] | images[0]: here must be one of \"uri\" and \"bufferView\"",
        "'scene':0 | scene: there is no scenes[0], but 0 of them",
        "'nodes':[{'skin':0}] | nodes[0].skin: this needs \"mesh\" beside it",
        "'nodes':[{'matrix':[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],'scale':[1,1,1]}] | nodes[0].matrix: this must not stand beside translation, rotation and scale",
        "'nodes':[{'rotation':[1,1,1,1]}] | nodes[0].rotation: the four numbers of a rotation must have the length 1 together",
        "'nodes':[{'children':[1]},{'children':[0]}] | nodes[0]: this node is within itself",
        "'nodes':[{'children':[1]},{}],'scenes':[{'nodes':[1]}] | scenes[0].nodes: nodes[1] is within nodes[0]",
        "'meshes':[{}] | meshes[0]: here must be \"primitives\"",
        "'meshes':[{'primitives':[{'attributes':{'POSITION':0}}]}] | meshes[0].primitives[0].attributes.POSITION: there is no accessors[0], but 0 of them",
        "'animations':[{'channels':[{'sampler':3,'target':{'path':'scale'}}],'samplers':[{'input':0,'output':0}]}],'accessors':[{'componentType':5126,'count':1,'type':'SCALAR'}] "
            + "| animations[0]: there is no samplers[3], but 1 of them",
        "'materials':[{'name':'red'}],'nodes':[{'children':[1]},{'camera':0}],'cameras':[{'type':'perspective','perspective':{'yfov':1,'znear':1}}] | " + NOTHING,
    })
    void whatNothingShowsIsLookedInto(String json, String sentence) {
        assertThat(fault(json)).isEqualTo(sentence);
    }

    @Test
    @Timeout(30)
    void littleIsLookedIntoOfWhatIsSaidVeryOften() {
        String many = "{'componentType':5126,'count':1000000,'type':'MAT4'},".repeat(5000);
        assertThat(fault("'accessors':[" + many + "{'componentType':5126,'count':1000000,'type':'SCALAR','min':[1]}]"))
                .isEqualTo("accessors[5000]: number 0 of element 0 is 0, which is beyond what \"min\" and \"max\" say");
        String mesh = "{'primitives':[{'attributes':{'POSITION':0}}],'name':'%d'},";
        String meshes = IntStream.range(0, 300).mapToObj(mesh::formatted).collect(Collectors.joining());
        assertThat(fault("'meshes':[" + meshes + mesh.replace("},", "}") + "],'accessors':[{'componentType':5126,'count':999999,'type':'VEC3','min':[0,0,0],'max':[0,0,0]}]"))
                .isEqualTo(NOTHING);
        String views = "{'bufferView':0,'componentType':5121,'count':1000000,'type':'SCALAR'},".repeat(3000);
        String bytes = "'buffers':[{'byteLength':1000000,'uri':'data:;base64," + "AAAA".repeat(333_334) + "'}],'bufferViews':[{'buffer':0,'byteLength':1000000}]";
        assertThat(fault(bytes + ",'accessors':[" + views.substring(0, views.length() - 1) + "]")).isEqualTo(NOTHING);
    }

    private static String fault(String json) {
        return Read.fault(ForeignFormat.GLTF, ("{'asset':{'version':'2.0'}," + json + "}").replace('\'', '"'));
    }

    @Test
    void soAreThePiecesOfAFileInBytes() {
        String json = "{\"asset\":{\"version\":\"2.0\"}} ";
        assertThat(Read.fault(ForeignFormat.GLTF, chunks(0, json, "JSON"))).isEqualTo(NOTHING);
        assertThat(Read.fault(ForeignFormat.GLTF, chunks(4, json, "JSON"))).as("bytes behind the last chunk").isEqualTo(NOTHING);
        assertThat(Read.fault(ForeignFormat.GLTF, chunks(0, json, "JSON", json, "JSON"))).isEqualTo("byte 52: there must be one chunk of JSON only");
        assertThat(Read.fault(ForeignFormat.GLTF, chunks(0, json + " ", "JSON"))).isEqualTo("byte 12: the length of a chunk must be a multiple of 4, but is 29");
        assertThat(Read.fault(ForeignFormat.GLTF, chunks(0, json, "JSON", "....", "REST", "....", "BIN\0"))).isEqualTo("byte 64: bytes must be in the second chunk");
        assertThat(Read.fault(ForeignFormat.GLTF, chunks(0, "....", "REST", json, "JSON"))).isEqualTo("byte 16: the first chunk must be JSON");
    }

    /** @param more how many bytes follow */
    private static byte[] chunks(int more, String... contentsAndTypes) {
        ByteBuffer file = ByteBuffer.allocate(1000).order(ByteOrder.LITTLE_ENDIAN).put(ascii("glTF")).putInt(2).putInt(0);
        for (int i = 0; i < contentsAndTypes.length; i += 2) {
            file.putInt(contentsAndTypes[i].length()).put(ascii(contentsAndTypes[i + 1])).put(ascii(contentsAndTypes[i]));
        }
        file.putInt(8, file.position());
        byte[] all = new byte[file.position() + more];
        file.get(0, all, 0, all.length);
        return all;
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }
}
