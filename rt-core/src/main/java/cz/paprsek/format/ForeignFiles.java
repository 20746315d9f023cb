package cz.paprsek.format;

import cz.paprsek.format.gltf.GltfReader;
import cz.paprsek.format.model.Companions;
import cz.paprsek.format.model.Model;
import cz.paprsek.format.obj.ObjReader;
import cz.paprsek.format.off.OffReader;
import cz.paprsek.format.ply.PlyReader;
import cz.paprsek.format.stl.StlReader;
import java.io.IOException;
import java.io.InputStream;
import java.util.Objects;

/** Reads files of other programs. Every fault is an {@link IOException} of one line that begins with the place in the file. */
public final class ForeignFiles {
    /** How many bytes a file may have that is looked at here and there, rather than from beginning to end: 1 GiB. */
    private static final long LARGEST_IN_MEMORY = 1L << 30;

    private ForeignFiles() {}

    /**
     * Reads triangles.
     *
     * @param name of the file, as materials are to have it of pictures that are within it: such a picture is called after it, with {@code #} and a number
     * @param format one of those that hold {@linkplain ForeignFormat#isMesh triangles}
     * @param input is read as far as it is needed, and not closed
     * @param size how many bytes there are; {@link Long#MAX_VALUE} if nobody knows
     * @param companions the files beside it
     * @throws IOException if it cannot be read, or something is wrong with it: in one line that does not name the file
     */
    public static Model model(String name, ForeignFormat format, InputStream input, long size, Companions companions) throws IOException {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(input, "input");
        Objects.requireNonNull(companions, "companions");
        try {
            return switch (format) {
                case STL -> StlReader.read(input, size);
                case OBJ -> ObjReader.read(input, companions);
                case PLY -> PlyReader.read(input, size);
                case GLTF -> GltfReader.read(all(input), name + "#", companions);
                case OFF -> OffReader.read(input, size);
                case NFF, OPENSCAD -> throw new IOException("files of " + format.label() + " hold other things than triangles");
            };
        } catch (IllegalArgumentException impossible) {
            // What no place in the file can be given for.
            throw new IOException(impossible.getMessage(), impossible);
        }
    }

    private static byte[] all(InputStream input) throws IOException {
        byte[] bytes = input.readNBytes((int) LARGEST_IN_MEMORY + 1);
        if (bytes.length > LARGEST_IN_MEMORY) {
            throw new IOException("files of this format are read up to " + LARGEST_IN_MEMORY + " bytes");
        }
        return bytes;
    }
}
