package cz.paprsek.format.gltf;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Notes;
import cz.paprsek.math.Affine;
import java.io.IOException;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Looks into everything that a document has, whether it is shown or not: for whoever sees nothing of a file wants to know what is wrong with it. A document of which something is
 * to be seen is read without that.
 *
 * @source Khronos Group, glTF 2.0 Specification, 2021
 */
final class Doubts {
    private static final Map<String, String> TYPES = Map.of("POSITION", "VEC3", "NORMAL", "VEC3", "TANGENT", "VEC4", "TEXCOORD_0", "VEC2", "JOINTS_0", "VEC4", "WEIGHTS_0", "VEC4");

    /** How many numbers are read to look at them: a small file may name the same ones very often. */
    private static final long MOST = 10_000_000;

    private final Tree document;
    private final Buffers buffers;
    private final Accessors accessors;
    /** The primitives and weights of meshes that have been looked at. */
    private final Set<List<List<?>>> seen = new HashSet<>();
    private long left = MOST;

    Doubts(Tree document, Buffers buffers, Accessors accessors) {
        this.document = document;
        this.buffers = buffers;
        this.accessors = accessors;
    }

    /** @throws IOException the first thing that is found to be wrong */
    void look(Materials materials) throws IOException {
        Rules.check(document);
        Tree asset = document.childOrNothing("asset");
        if (asset.text("minVersion", "2.0").compareTo(asset.text("version", "2.0")) > 0) {
            throw asset.fault("minVersion", "this must not be above the version");
        }
        for (int i = 0; i < document.count("buffers"); i++) {
            buffers.check(i);
        }
        for (int i = 0; i < document.count("bufferViews"); i++) {
            buffers.isKnown(i);
        }
        for (int i = 0; i < document.count("accessors"); i++) {
            left -= accessors.check(i, left);
        }
        for (int i = 0; i < document.count("cameras"); i++) {
            camera(document.item("cameras", i));
        }
        for (int i = 0; i < document.count("images"); i++) {
            image(document.item("images", i));
        }
        nodes();
        for (int i = 0; i < document.count("meshes"); i++) {
            Tree mesh = document.item("meshes", i);
            mesh(mesh);
            long size = size(mesh);
            if (size <= left && seen.add(List.of(mesh.list("primitives"), mesh.list("weights")))) {
                left -= size;
                new Meshes(document, accessors, materials, new Notes()).show(i, "", new Meshes.Pose(Affine.IDENTITY, Optional.empty()), new double[0]);
            }
        }
        for (int i = 0; i < document.count("animations"); i++) {
            animation(document.item("animations", i));
        }
    }

    private static void camera(Tree camera) throws FormatFault {
        String type = camera.text("type", "");
        Tree lens = camera.child(type).orElseThrow(() -> camera.fault("here must be " + FormatFault.quoted(type)));
        if (camera.has("perspective") && camera.has("orthographic")) {
            throw camera.fault("this must be perspective or orthographic, not both");
        }
        if (lens.number("zfar", Double.MAX_VALUE) <= lens.number("znear", 0)) {
            throw lens.fault("zfar", "this must be above znear");
        }
        for (String size : lens.names()) {
            if ((size.equals("xmag") || size.equals("ymag")) && lens.number(size, 1) == 0) {
                throw lens.fault(size, "this must not be 0");
            }
        }
    }

    private void image(Tree image) throws IOException {
        if (image.has("uri") == image.has("bufferView")) {
            throw image.fault("here must be one of \"uri\" and \"bufferView\"");
        }
        if (image.has("uri")) {
            buffers.data(image, image.text("uri", ""));
        } else if (buffers.stride(image.needed("bufferView")) > 0) {
            throw image.fault("bufferView", "the bytes of a picture must be side by side");
        }
    }

    /** Each has at most one parent, and none is within itself; the roots of a scene have none. */
    private void nodes() throws FormatFault {
        int count = document.count("nodes");
        int[] parents = new int[count];
        BitSet skinned = new BitSet();
        for (int i = 0; i < document.count("meshes"); i++) {
            skinned.set(i, isSkinned(document.item("meshes", i)));
        }
        for (int i = 0; i < count; i++) {
            Tree node = document.item("nodes", i);
            if (node.has("matrix") && (node.has("translation") || node.has("rotation") || node.has("scale"))) {
                throw node.fault("matrix", "this must not stand beside translation, rotation and scale");
            }
            double[] q = node.numbers("rotation", 0, 0, 0, 1);
            if (Math.abs(Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]) - 1) > 0.005) {
                throw node.fault("rotation", "the four numbers of a rotation must have the length 1 together");
            }
            if (node.has("skin") && !skinned.get(node.needed("mesh"))) {
                throw node.fault("skin", "no primitive of the mesh has JOINTS_0 and WEIGHTS_0");
            }
            for (int child : node.indexes("children", count)) {
                if (parents[child] > 0) {
                    throw node.fault("children", "nodes[" + child + "] has another parent, nodes[" + (parents[child] - 1) + "]");
                }
                parents[child] = i + 1;
            }
        }
        int[] known = new int[count];
        for (int i = 0; i < count; i++) {
            int at = i;
            while (at >= 0 && known[at] == 0) {
                known[at] = i + 1;
                at = parents[at] - 1;
            }
            if (at >= 0 && known[at] == i + 1) {
                throw document.item("nodes", at).fault("this node is within itself");
            }
        }
        for (int i = 0; i < document.count("scenes"); i++) {
            Tree scene = document.item("scenes", i);
            for (int root : scene.indexes("nodes", count)) {
                if (parents[root] > 0) {
                    throw scene.fault("nodes", "nodes[" + root + "] is within nodes[" + (parents[root] - 1) + "]");
                }
            }
        }
    }

    private static boolean isSkinned(Tree mesh) throws FormatFault {
        for (int i = 0; i < mesh.count("primitives"); i++) {
            Tree attributes = mesh.item("primitives", i).childOrNothing("attributes");
            if (attributes.has("JOINTS_0") && attributes.has("WEIGHTS_0")) {
                return true;
            }
        }
        return false;
    }

    private void mesh(Tree mesh) throws FormatFault {
        int targets = mesh.item("primitives", 0).count("targets");
        if (mesh.has("weights") && mesh.count("weights") != targets) {
            throw mesh.fault("weights", "there must be as many as morph targets, " + targets + ", but are " + mesh.count("weights"));
        }
        for (int i = 0; i < mesh.count("primitives"); i++) {
            Tree primitive = mesh.item("primitives", i);
            Tree attributes = primitive.childOrNothing("attributes");
            if (primitive.count("targets") != targets) {
                throw primitive.fault("targets", "all primitives of a mesh must have as many morph targets");
            }
            int count = attributes(attributes, -1);
            for (int k = 0; k < targets; k++) {
                Tree target = primitive.item("targets", k);
                for (String name : target.names()) {
                    if (!attributes.has(name)) {
                        throw target.fault(name, "the primitive has no " + name + " to be moved");
                    }
                }
                attributes(target, count);
            }
        }
    }

    /** How many elements they have, which is the same of all. */
    private int attributes(Tree attributes, int wanted) throws FormatFault {
        int count = wanted;
        for (String name : attributes.names()) {
            Tree accessor = document.item("accessors", attributes.needed(name));
            String type = TYPES.get(name);
            boolean isKnown = name.startsWith("_") || isOfExtension(name) || name.matches("POSITION|NORMAL|TANGENT|(TEXCOORD|COLOR|JOINTS|WEIGHTS)_(0|[1-9]\\d*)");
            if (!isKnown) {
                throw attributes.fault(FormatFault.quoted(name) + " is no attribute of vertices");
            }
            if (type != null && wanted < 0 && !accessor.text("type", "").equals(type)) {
                throw attributes.fault(name, "this must be " + type + ", but is " + FormatFault.quoted(accessor.text("type", "")));
            }
            if (name.equals("POSITION") && !(accessor.has("min") && accessor.has("max"))) {
                throw accessor.fault("the places of vertices must have \"min\" and \"max\"");
            }
            if (name.equals("JOINTS_0") != name.equals("WEIGHTS_0") && wanted < 0 && !(attributes.has("JOINTS_0") && attributes.has("WEIGHTS_0"))) {
                throw attributes.fault("JOINTS_0 and WEIGHTS_0 must stand beside each other");
            }
            if (count >= 0 && accessor.needed("count") != count) {
                throw attributes.fault(name, "there must be as many elements as in the others, " + count + ", but are " + accessor.needed("count"));
            }
            count = accessor.needed("count");
        }
        return count;
    }

    /** Extensions give their attributes names that begin with their own. */
    private boolean isOfExtension(String attribute) throws FormatFault {
        int end = attribute.indexOf(':');
        return end > 0 && document.list("extensionsUsed").contains(attribute.substring(0, end));
    }

    /** How many numbers showing a mesh takes. */
    private long size(Tree mesh) throws FormatFault {
        long size = 0;
        for (int i = 0; i < mesh.count("primitives"); i++) {
            Tree primitive = mesh.item("primitives", i);
            size += size(primitive, "indices") + sizes(primitive.childOrNothing("attributes"));
            for (int k = 0; k < primitive.count("targets"); k++) {
                size += sizes(primitive.item("targets", k));
            }
        }
        return size;
    }

    private long sizes(Tree attributes) throws FormatFault {
        long size = 0;
        for (String name : attributes.names()) {
            size += size(attributes, name);
        }
        return size;
    }

    private long size(Tree owner, String name) throws FormatFault {
        return owner.has(name) ? accessors.size(owner.needed(name)) : 0;
    }

    private static void animation(Tree animation) throws FormatFault {
        for (int i = 0; i < animation.count("channels"); i++) {
            animation.item("samplers", animation.item("channels", i).needed("sampler"));
        }
    }
}
