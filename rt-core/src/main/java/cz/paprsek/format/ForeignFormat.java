package cz.paprsek.format;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** The formats of other programs that are read. */
public enum ForeignFormat {
    STL("STL", "STL", "stl"),
    OBJ("OBJ", "Wavefront OBJ", "obj"),
    PLY("PLY", "PLY", "ply"),
    GLTF("glTF", "glTF 2.0", "gltf glb"),
    OFF("OFF", "OFF", "off"),
    NFF("NFF", "NFF", "nff"),
    OPENSCAD("OpenSCAD", "OpenSCAD CSG", "csg");

    /** How many bytes of a file tell what it is. */
    public static final int HEAD = 8192;

    private static final String REMARKS = "(?:\\s++|#[^\r\n]*+(?:[\r\n]|\\z))*+";

    /** What is first in an OFF file, after remarks: two numbers come next, or so much of remarks that one cannot know. */
    private static final Pattern OFF_COUNTS = Pattern.compile(
            REMARKS + "(?:ST)?C?N?C?(?:ST)?OFF(?:[ \t]++BINARY\\s|" + REMARKS + "(?:\\z|\\d++(?:\\z|(?=[\\s#])" + REMARKS + "(?:\\z|\\d))))");

    /** What is first in an OBJ file, after remarks. */
    private static final Pattern OBJ_STATEMENT = Pattern.compile(REMARKS + "(?:mtllib|usemtl|o|g|s|v|vn|vt)[ \t]+[^\\s]");

    /** What is first in an NFF file, after remarks: from where one looks, perhaps after the background and lights. */
    private static final Pattern NFF_VIEW = Pattern.compile(REMARKS + "(?:[bl][ \t]++[-+.\\d][^\r\n]*+" + REMARKS + ")*+v\\s++from\\s++[-+.\\d]");
    private static final String CSG_GROUP = "(?:group|union|difference|intersection|hull|minkowski)";
    private static final String CSG_OTHER = "(?:multmatrix|color|render|linear_extrude|rotate_extrude|offset|projection|resize|cube|sphere|cylinder|polyhedron|square|circle|polygon|text|surface)";
    /** What is first in what OpenSCAD writes: a body with named values or a list, or what bodies are in. */
    private static final Pattern CSG_NODE = Pattern.compile("\\s*+[#%!*]?(?:" + CSG_GROUP + "\\s*+\\(\\s*+\\)\\s*+(?:;|\\{\\s*+(?:\\z|\\}|[#%!*]?(?:import|" + CSG_GROUP + '|' + CSG_OTHER + ")\\s*+\\())|"
            + CSG_OTHER + "\\s*+\\(\\s*+(?:\\[|\\$?\\w++\\s*+=[^=])|import\\s*+\\(\\s*+file\\s*+=)");

    private final String word;
    private final String label;
    /** With a blank between them. */
    private final String endings;

    ForeignFormat(String word, String label, String endings) {
        this.word = word;
        this.label = label;
        this.endings = endings;
    }

    /** What people call it where several are listed. */
    public String word() {
        return word;
    }

    /** What people call it. */
    public String label() {
        return label;
    }

    /** The endings of its files, in lower case; the usual one first. */
    public List<String> endings() {
        return List.of(endings.split(" "));
    }

    /** Whether its files hold triangles, and not bodies of other kinds. */
    public boolean isMesh() {
        return this != NFF && this != OPENSCAD;
    }

    /** Those that hold triangles, as they are listed in a sentence. */
    public static String meshes() {
        return Arrays.stream(values()).filter(ForeignFormat::isMesh).map(ForeignFormat::word).collect(Collectors.joining(", "));
    }

    /** By the ending of a file's name. */
    public static Optional<ForeignFormat> ofName(String fileName) {
        String ending = fileName.substring(fileName.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        return Arrays.stream(values()).filter(format -> format.endings().contains(ending)).findFirst();
    }

    /**
     * By what a file begins with, if that tells, else by its name: whoever calls a PLY file {@code part.stl} meets with no surprise.
     *
     * @param head the first {@value #HEAD} bytes, or all there are
     */
    public static Optional<ForeignFormat> of(String fileName, byte[] head) {
        Objects.requireNonNull(fileName, "fileName");
        String text = new String(head, StandardCharsets.ISO_8859_1);
        if (text.startsWith("glTF")) {
            return Optional.of(GLTF);
        }
        if (text.matches("(?s)ply[\r\n].*")) {
            return Optional.of(PLY);
        }
        if (OFF_COUNTS.matcher(text).lookingAt()) {
            return Optional.of(OFF);
        }
        Optional<ForeignFormat> named = ofName(fileName);
        boolean isJson = text.replaceFirst("^\u00EF\u00BB\u00BF", "").stripLeading().startsWith("{");
        if (named.filter(format -> format == OBJ || !format.isMesh() || (format == GLTF && isJson)).isPresent()) {
            return named;
        }
        if (text.regionMatches(true, 0, "solid", 0, 5)) {
            return Optional.of(STL);
        }
        return text.indexOf('\0') >= 0 ? named : NFF_VIEW.matcher(text).lookingAt() ? Optional.of(NFF)
                : OBJ_STATEMENT.matcher(text).lookingAt() ? Optional.of(OBJ) : CSG_NODE.matcher(text).lookingAt() && !isProgram(fileName) ? Optional.of(OPENSCAD) : named;
    }

    /** OpenSCAD's own programs may begin as what it makes of them. */
    private static boolean isProgram(String fileName) {
        return fileName.toLowerCase(Locale.ROOT).endsWith(".scad");
    }
}
