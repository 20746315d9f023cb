package cz.paprsek.cli.input;

import cz.paprsek.format.ForeignFormat;
import cz.paprsek.image.ImageFormat;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Files that are no scenes but look as if somebody hoped they were, by the ending of their names. */
public final class Foreign {
    private static final String MESH = ", which is not read; export it as glTF, OBJ, STL or PLY";
    private static final String PICTURE = ", not a scene; if render is to write it, put -o before it";
    private static final String POV = ", which is written here (paprsek convert) but not read";
    private static final String PACKED = "; unpack it first";
    /** What to do with one that comes in as it is read. */
    static final String NOT_THROUGH = "files of other programs cannot come through a pipe; write it to a file first";
    /** What may come before the first letter: the bytes of byte-order marks, zeros of wide letters, and blanks. */
    private static final String BEFORE_MARKUP = "\u00EF\u00BB\u00BF\u00FE\u00FF\0 \t\r\n";
    private static final Map<String, String> KINDS = Map.ofEntries(
            Map.entry("fbx", "an FBX model" + MESH),
            Map.entry("3ds", "a model of 3D Studio's" + MESH), Map.entry("dae", "a COLLADA model" + MESH), Map.entry("x3d", "an X3D model" + MESH),
            Map.entry("usd", "a USD scene" + MESH), Map.entry("usdz", "a USD scene" + MESH), Map.entry("3mf", "a 3MF model" + MESH),
            Map.entry("blend", "a file of Blender's" + MESH), Map.entry("step", "a CAD model (STEP)" + MESH), Map.entry("stp", "a CAD model (STEP)" + MESH),
            Map.entry("scad", "an OpenSCAD program; what it makes is read: openscad -o model.csg model.scad"),
            Map.entry("pov", "a scene of POV-Ray's" + POV), Map.entry("inc", "a part of a POV-Ray scene" + POV),
            Map.entry("png", "a picture" + PICTURE), Map.entry("jpg", "a picture" + PICTURE), Map.entry("jpeg", "a picture" + PICTURE),
            Map.entry("bmp", "a picture" + PICTURE), Map.entry("tif", "a picture" + PICTURE), Map.entry("tiff", "a picture" + PICTURE),
            Map.entry("gif", "a picture" + PICTURE), Map.entry("webp", "a picture" + PICTURE), Map.entry("ppm", "a picture" + PICTURE),
            Map.entry("pgm", "a picture" + PICTURE), Map.entry("pfm", "a picture" + PICTURE), Map.entry("exr", "a picture" + PICTURE), Map.entry("hdr", "a picture" + PICTURE), Map.entry("ppm16", "a picture" + PICTURE),
            Map.entry("svg", "a drawing, not a scene"), Map.entry("xsd", "a schema; it says what scenes may hold, and is none"),
            Map.entry("resume", "what --resume keeps of an interrupted picture; give the scene again, with the same options"),
            Map.entry("zip", "an archive" + PACKED), Map.entry("gz", "a packed file" + PACKED), Map.entry("xz", "a packed file" + PACKED));

    private Foreign() {}

    /** What kind of file it is and what to do, if it is there and is no scene by its name and its first letter. */
    public static Optional<String> kind(Path file) {
        String name = String.valueOf(file.getFileName());
        if (Incoming.isOnce(file) && ForeignFormat.ofName(name).isPresent()) {
            return Optional.of("this is a pipe or a device, and " + NOT_THROUGH);
        }
        String kind = KINDS.get(name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT));
        return kind == null || !Files.isRegularFile(file) || isMarkup(file, name) ? Optional.empty() : Optional.of("this is " + kind);
    }

    /** @throws IOException with the sentence for a foreign file */
    public static void refuse(Path file) throws IOException {
        Optional<String> kind = kind(file);
        if (kind.isPresent()) {
            throw new IOException(file + ": " + kind.get());
        }
    }

    /** Whether it is a picture by its name, and no scene by its first letter. */
    public static boolean isPicture(Path file) {
        String name = String.valueOf(file.getFileName());
        return (ImageFormat.ofFile(name).isPresent() || kind(file).filter(kind -> kind.endsWith(PICTURE)).isPresent()) && Files.isRegularFile(file) && !isMarkup(file, name);
    }

    /** What to do with a scene that stands where a picture should; nothing of others. */
    public static String sceneInPlaceOfPicture(Path file) {
        String name = String.valueOf(file.getFileName());
        return Files.isRegularFile(file) && name.endsWith(".xml") && isMarkup(file, name) ? ", but looks like a scene; render it, and compare the picture" : "";
    }

    /** A scene may have any name; but other markup has a name of its own. */
    private static boolean isMarkup(Path file, String name) {
        if (name.endsWith(".svg") || name.endsWith(".dae") || name.endsWith(".x3d") || name.endsWith(".xsd")) {
            return false;
        }
        try (InputStream input = Files.newInputStream(file)) {
            return isMarkup(input.readNBytes(16));
        } catch (IOException unreadable) {
            // Whoever reads it will say why.
            return true;
        }
    }

    /** Whether the first letter opens an element: past a byte-order mark and blanks, and in any encoding. Binary files may have that byte anywhere else. */
    static boolean isMarkup(byte[] head) {
        for (int i = 0; i < Math.min(16, head.length); i++) {
            if (head[i] == '<') {
                return true;
            }
            if (BEFORE_MARKUP.indexOf(head[i] & 0xFF) < 0) {
                return false;
            }
        }
        return false;
    }
}
