package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.format.model.Model;
import cz.paprsek.math.Vec3;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Base64;
import org.junit.jupiter.api.Test;

/** What hangs on bones, or is a mixture of targets, as a glTF file has it before anything moves. */
class GltfPosesTest {
    /** A triangle; how far it goes in a target; for each vertex two bones and their weights; and how bones are undone: by one to the left, and not at all. */
    private static String file(String nodes, String primitive, String rest) {
        ByteBuffer bytes = ByteBuffer.allocate(36 + 36 + 12 + 48 + 128).order(ByteOrder.LITTLE_ENDIAN);
        put(bytes, 0, 0, 0, 1, 0, 0, 0, 1, 0);
        put(bytes, 0, 0, 8, 0, 2, 0, 0, 0, 0);
        bytes.put(new byte[] {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
        put(bytes, 1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0);
        put(bytes, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1);
        put(bytes, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
        return ("{'asset':{'version':'2.0'},'buffers':[{'byteLength':260,'uri':'data:;base64," + Base64.getEncoder().encodeToString(bytes.array()) + "'}],"
                + "'bufferViews':[{'buffer':0,'byteLength':36},{'buffer':0,'byteOffset':36,'byteLength':36},{'buffer':0,'byteOffset':72,'byteLength':12},"
                + "{'buffer':0,'byteOffset':84,'byteLength':48},{'buffer':0,'byteOffset':132,'byteLength':128}],"
                + "'accessors':[{'bufferView':0,'componentType':5126,'count':3,'type':'VEC3'},{'bufferView':1,'componentType':5126,'count':3,'type':'VEC3'},"
                + "{'bufferView':2,'componentType':5121,'count':3,'type':'VEC4'},{'bufferView':3,'componentType':5126,'count':3,'type':'VEC4'},"
                + "{'bufferView':4,'componentType':5126,'count':2,'type':'MAT4'}],'nodes':[" + nodes + "],'meshes':[{'primitives':[{" + primitive + "}]" + rest + "}").replace('\'', '"');
    }

    private static void put(ByteBuffer bytes, float... numbers) {
        for (float number : numbers) {
            bytes.putFloat(number);
        }
    }

    /** The first bone is 5 to the right of where it was bound, less one; the second 3 up, below a parent that is 7 to the front. The node's own placement does not count. */
    @Test
    void aSkinIsWhereItsBonesAre() throws IOException {
        Model model = Read.text(ForeignFormat.GLTF, file(
                "{'mesh':0,'skin':0,'translation':[100,0,0]},{'children':[2,3]},{'translation':[5,0,0]},{'translation':[0,3,7]}",
                "'attributes':{'POSITION':0,'JOINTS_0':2,'WEIGHTS_0':3}", "}],'skins':[{'joints':[2,3],'inverseBindMatrices':4}]"));
        assertThat(model.triangles().place(0)).isEqualTo(new Vec3(4, 0, 0));
        assertThat(model.triangles().place(1)).isEqualTo(new Vec3(1, 3, 7));
        assertThat(model.triangles().place(2)).as("half of each").isEqualTo(new Vec3(2, 2.5, 3.5));
        assertThat(model.notes()).containsExactly("nodes[0]: a skin is shown as its bones are at first");
    }

    @Test
    void aBoneThatIsNotThereIsSaid() {
        assertThat(Read.fault(ForeignFormat.GLTF, file("{'mesh':0,'skin':0},{}", "'attributes':{'POSITION':0,'JOINTS_0':2,'WEIGHTS_0':3}", "}],'skins':[{'joints':[1]}]")))
                .isEqualTo("meshes[0].primitives[0].attributes.JOINTS_0: vertex 1 hangs on joint 1, but there are 1");
    }

    /** A node's weights go before those of the mesh. */
    @Test
    void targetsCountAsTheirWeightsSay() throws IOException {
        String primitive = "'attributes':{'POSITION':0},'targets':[{'POSITION':1}]";
        Model byMesh = Read.text(ForeignFormat.GLTF, file("{'mesh':0}", primitive, ",'weights':[0.5]}]"));
        assertThat(byMesh.triangles().place(0)).isEqualTo(new Vec3(0, 0, 4));
        assertThat(byMesh.triangles().place(1)).isEqualTo(new Vec3(1, 1, 0));
        assertThat(byMesh.notes()).containsExactly("meshes[0].primitives[0]: morph targets have the weights that they have at first");
        assertThat(Read.text(ForeignFormat.GLTF, file("{'mesh':0,'weights':[0.25]}", primitive, ",'weights':[0.5]}]")).triangles().place(0)).isEqualTo(new Vec3(0, 0, 2));
        assertThat(Read.text(ForeignFormat.GLTF, file("{'mesh':0}", primitive, "}]")).triangles().place(0)).isEqualTo(Vec3.ZERO);
    }
}
