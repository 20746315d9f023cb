package cz.paprsek.format.gltf;

import cz.paprsek.format.model.Companions;
import cz.paprsek.format.model.Convention;
import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Model;
import cz.paprsek.format.model.Notes;
import cz.paprsek.math.Affine;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import java.util.Set;

/**
 * Reads glTF 2.0: the scene's nodes, each mesh where its node puts it, materials, cameras and lights. Skins and morph targets are shown as the file has them at first, without its animations.
 *
 * @source Khronos Group, glTF 2.0 Specification, 2021
 */
public final class GltfReader {
    private static final Convention CONVENTION = new Convention("m", false);
    private static final int MAGIC = 0x46546C67;
    private static final int JSON = 0x4E4F534A;
    private static final int BIN = 0x004E4942;
    private static final Set<String> UNDERSTOOD = Set.of("KHR_lights_punctual", "KHR_materials_ior", "KHR_materials_transmission", "KHR_materials_volume",
            "KHR_materials_emissive_strength", "KHR_materials_unlit", "KHR_texture_transform", "KHR_mesh_quantization", "KHR_node_visibility");

    private GltfReader() {}

    /** @param prefix of the names of pictures that are within the file */
    public static Model read(byte[] file, String prefix, Companions companions) throws IOException {
        ByteBuffer bytes = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
        boolean isBinary = file.length >= 4 && bytes.getInt(0) == MAGIC;
        Chunks chunks = isBinary ? Chunks.of(bytes) : new Chunks(bytes, Optional.empty(), Optional.empty());
        Tree document = Tree.of(chunks.json);
        Notes notes = new Notes();
        check(document, notes);
        Buffers buffers = new Buffers(document, chunks.bytes, companions);
        Images images = new Images(document, buffers, prefix, notes);
        Materials materials = new Materials(document, images, notes);
        Accessors accessors = new Accessors(document, buffers);
        Nodes nodes = new Nodes(document, accessors, new Meshes(document, accessors, materials, notes), notes);
        nodes.scene(Affine.IDENTITY);
        if (nodes.isEmpty()) {
            if (chunks.odd.isPresent()) {
                throw chunks.odd.get();
            }
            new Doubts(document, buffers, accessors).look(materials);
            throw FormatFault.in("the document", "there is no triangle in the scene of this file");
        }
        return nodes.model(materials, images, CONVENTION);
    }

    /**
     * The text and the bytes of a file in one piece.
     *
     * @param odd what is wrong, though both can be read
     */
    private record Chunks(ByteBuffer json, Optional<ByteBuffer> bytes, Optional<FormatFault> odd) {
        static Chunks of(ByteBuffer file) throws FormatFault {
            if (file.capacity() < 20) {
                throw FormatFault.at(file.capacity(), "the file ends within its head");
            }
            if (file.getInt(4) != 2) {
                throw FormatFault.at(4, "this is version " + (file.getInt(4) & 0xFFFFFFFFL) + " of the format; version 2 is read");
            }
            long length = file.getInt(8) & 0xFFFFFFFFL;
            if (length > file.capacity()) {
                throw FormatFault.at(8, "the file says it has " + length + " bytes, but has " + file.capacity());
            }
            Optional<FormatFault> odd = Optional.empty();
            Optional<ByteBuffer> json = Optional.empty();
            Optional<ByteBuffer> bytes = Optional.empty();
            int number = 0;
            for (long at = 12; at + 8 <= length;) {
                long size = file.getInt((int) at) & 0xFFFFFFFFL;
                if (size > length - at - 8) {
                    throw FormatFault.at(at, "a chunk says it has " + size + " bytes, but there are " + (length - at - 8) + " more");
                }
                int type = file.getInt((int) at + 4);
                ByteBuffer content = file.slice((int) at + 8, (int) size);
                if (type == JSON && json.isEmpty()) {
                    json = Optional.of(content);
                } else if (type == BIN && bytes.isEmpty()) {
                    bytes = Optional.of(content);
                }
                if (odd.isEmpty()) {
                    odd = oddity(at, size, type, number);
                }
                number++;
                at += 8 + size;
            }
            return new Chunks(json.orElseThrow(() -> FormatFault.at(12, "there is no chunk of JSON in this file")), bytes, odd);
        }

        /** The first chunk is JSON, the second may have bytes, and each ends where a multiple of four begins. */
        private static Optional<FormatFault> oddity(long at, long size, int type, int number) {
            if (size % 4 != 0) {
                return Optional.of(FormatFault.at(at, "the length of a chunk must be a multiple of 4, but is " + size));
            }
            if ((number == 0) != (type == JSON)) {
                return Optional.of(FormatFault.at(at + 4, number == 0 ? "the first chunk must be JSON" : "there must be one chunk of JSON only"));
            }
            return type == BIN && number != 1 ? Optional.of(FormatFault.at(at + 4, "bytes must be in the second chunk")) : Optional.empty();
        }
    }

    private static void check(Tree document, Notes notes) throws FormatFault {
        Tree asset = document.child("asset").orElseThrow(() -> document.fault("here must be \"asset\" with the version of the format"));
        String version = asset.text("version", "");
        if (!version.startsWith("2.")) {
            throw asset.fault("version", "version 2.0 is read, but this is " + FormatFault.quoted(version));
        }
        for (Object required : document.list("extensionsRequired")) {
            if (!UNDERSTOOD.contains(String.valueOf(required))) {
                throw document.fault("extensionsRequired", FormatFault.quoted(String.valueOf(required)) + " is not understood");
            }
        }
        for (Object used : document.list("extensionsUsed")) {
            if (!UNDERSTOOD.contains(String.valueOf(used))) {
                notes.add("extensionsUsed", FormatFault.quoted(String.valueOf(used)) + " is not understood");
            }
        }
        if (document.count("animations") > 0) {
            notes.add("animations", "these are not read; everything stands as it does at first");
        }
    }

}
