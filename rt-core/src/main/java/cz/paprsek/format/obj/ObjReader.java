package cz.paprsek.format.obj;

import cz.paprsek.format.model.Companions;
import cz.paprsek.format.model.Convention;
import cz.paprsek.format.model.Doubles;
import cz.paprsek.format.model.Floats;
import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Model;
import cz.paprsek.format.model.Notes;
import cz.paprsek.format.model.Polygon;
import cz.paprsek.format.model.TextLines;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads OBJ: vertices, normals, places in pictures, faces of any number of corners, groups and objects as parts, smoothing groups, materials.
 *
 * @source Wavefront Technologies, Advanced Visualizer Manual, Appendix B1, Object Files, version 3.0
 */
public final class ObjReader {
    private static final Convention CONVENTION = new Convention("", false);
    /** How many numbers a corner has, by its form. */
    private static final int[] WIDTHS = {1, 2, 2, 3};

    private final Companions companions;
    private final Blocks blocks;
    /** Of the lines that are read word by word, the one that is looked at. */
    private final TextLines lines = TextLines.ofOthers();
    private final Notes notes = new Notes();
    private final Doubles places = new Doubles();
    private final Doubles normals = new Doubles();
    private final Doubles map = new Doubles();
    private final Floats colors = new Floats();
    private final Corners corners = new Corners(places, normals, map, colors);
    private final Polygon polygon = new Polygon();
    private final Parts parts = new Parts();
    private final Map<String, Material> materials = new LinkedHashMap<>();
    /** Whether the part of the next face is still to be said. */
    private boolean isPartNew = true;
    private int smoothing;

    private final Polygon.Sink toCorners = corners::triangle;

    private ObjReader(InputStream input, Companions companions) throws IOException {
        this.companions = companions;
        this.blocks = new Blocks(input);
    }

    public static Model read(InputStream input, Companions companions) throws IOException {
        return new ObjReader(input, companions).read();
    }

    private Model read() throws IOException {
        long before = 0;
        for (Optional<Block> block = blocks.next(); block.isPresent(); block = blocks.next()) {
            take(block.get(), before);
            before += block.get().lines();
        }
        if (corners.isEmpty()) {
            throw FormatFault.in("the end", "there is no face in this file" + (places.size() > 0 ? ", only " + places.size() / 3 + " vertices" : ""));
        }
        if (polygon.isHurried()) {
            notes.add("", Polygon.HURRIED);
        }
        return new Model(corners.build(), parts.materials(), materials, Map.of(), List.of(), List.of(),
                CONVENTION, notes.toList(), notes.missing());
    }

    private void take(Block block, long before) throws IOException {
        int[] codes = block.codes();
        int count = block.codeCount();
        int number = 0;
        int face = 0;
        for (int at = 0; at < count;) {
            int code = codes[at++];
            if (code > 0) {
                int next = at + (code >> 2) * WIDTHS[code & 3];
                if (!plainFace(codes, at, code)) {
                    int begin = block.beginOf(face);
                    other(block, before + face, begin, LineEnds.next(block.bytes(), begin));
                }
                at = next;
                face++;
            } else if (code == Block.FACES) {
                face = codes[at++];
            } else if (code == Block.OTHER) {
                other(block, before + codes[at], codes[at + 1], codes[at + 2]);
                at += 3;
            } else if (code == Block.COLORED) {
                for (int i = 0; i < codes[at]; i++, number += 6) {
                    double[] numbers = block.numbers();
                    colored(numbers[number + 3], numbers[number + 4], numbers[number + 5]);
                    places.add(numbers, number, 3);
                }
                at++;
            } else {
                int size = (code == Block.MAP ? 2 : 3) * codes[at++];
                (code == Block.VERTICES ? places : code == Block.NORMALS ? normals : map).add(block.numbers(), number, size);
                number += size;
            }
        }
    }

    /** One that is not quite in order, or nothing that there are millions of. */
    private void other(Block block, long before, int begin, int end) throws IOException {
        lines.lookAt(Arrays.copyOfRange(block.bytes(), begin, end), before);
        while (lines.next()) {
            if (lines.word()) {
                switch (lines.letter(0)) {
                    case 'v' -> vertex();
                    case 'f' -> face();
                    case '#' -> { }
                    default -> other();
                }
            }
        }
    }

    /** A face whose corners are numbers; false if one of them names nothing that there is. */
    private boolean plainFace(int[] codes, int from, int code) {
        int width = WIDTHS[code & 3];
        int count = code >> 2;
        if (count == 3) {
            int a = plainCorner(codes, from, code);
            int b = plainCorner(codes, from + width, code);
            int c = plainCorner(codes, from + 2 * width, code);
            if (a < 0 || b < 0 || c < 0) {
                return false;
            }
            beginPart();
            corners.triangle(a, b, c);
            return true;
        }
        polygon.clear();
        for (int i = 0, at = from; i < count; i++, at += width) {
            int vertex = plainCorner(codes, at, code);
            if (vertex < 0) {
                return false;
            }
            int place = corners.placeOf(vertex);
            polygon.add(vertex, places.get(3 * place), places.get(3 * place + 1), places.get(3 * place + 2));
        }
        beginPart();
        polygon.cut(toCorners);
        return true;
    }

    private int plainCorner(int[] codes, int at, int code) {
        int place = resolved(codes[at], places.size() / 3);
        int uv = Corners.NONE;
        int normal = Corners.NONE;
        if ((code & 3) != 0) {
            boolean hasMap = (code & Block.HAS_MAP) != 0;
            boolean hasNormal = (code & Block.HAS_NORMAL) != 0;
            uv = hasMap ? resolved(codes[at + 1], map.size() / 2) : uv;
            normal = hasNormal ? resolved(codes[at + WIDTHS[code & 3] - 1], normals.size() / 3) : normal;
            place = (hasMap && uv < 0) || (hasNormal && normal < 0) ? -1 : place;
        }
        return place < 0 ? -1 : corners.vertex(place, uv, normal, smoothing);
    }

    /** −1 for what there is none of. */
    private static int resolved(int number, int count) {
        int index = number < 0 ? count + number : number - 1;
        return index < count ? Math.max(-1, index) : -1;
    }

    private void beginPart() {
        if (isPartNew) {
            corners.part(parts.current());
            isPartNew = false;
        }
    }

    /** The colour of the vertex that comes next, sRGB, 0–1. */
    private void colored(double red, double green, double blue) {
        while (colors.size() < places.size()) {
            colors.add(1);
        }
        colors.add(light(red));
        colors.add(light(green));
        colors.add(light(blue));
    }

    private static float light(double channel) {
        return (float) Rgb.linear(255 * Math.max(0, Math.min(1, channel)));
    }

    private void vertex() throws IOException {
        if (lines.length() == 1) {
            double x = coordinate("x of a vertex");
            double y = coordinate("y of a vertex");
            double z = coordinate("z of a vertex");
            // One more number is a weight, which makes no difference to what is flat; three are a colour.
            double red = isNumberNext() ? lines.number("red of a vertex") : 1;
            if (isNumberNext()) {
                colored(red, lines.number("green of a vertex"), lines.nextNumber("blue of a vertex"));
            }
            places.add(x);
            places.add(y);
            places.add(z);
        } else if (lines.is("vn")) {
            normals.add(coordinate("x of a normal"));
            normals.add(coordinate("y of a normal"));
            normals.add(coordinate("z of a normal"));
        } else if (lines.is("vt")) {
            map.add(coordinate("u of a place in a picture"));
            map.add(lines.hasMore() ? coordinate("v of a place in a picture") : 0);
        } else {
            unknown();
        }
    }

    private boolean isNumberNext() {
        if (!lines.word()) {
            return false;
        }
        int letter = lines.letter(0);
        return (letter >= '0' && letter <= '9') || letter == '-' || letter == '+' || letter == '.';
    }

    private double coordinate(String what) throws IOException {
        double value = lines.nextNumber(what);
        if (!(Math.abs(value) <= Float.MAX_VALUE)) {
            throw lines.fault(what + " must be within ±3.4e38, but is " + FormatFault.quoted(lines.text()));
        }
        return value;
    }

    private void face() throws IOException {
        polygon.clear();
        // A remark may stand behind the corners.
        while (lines.beginWord() && lines.ahead(0) != '#') {
            corner();
        }
        if (polygon.count() < 3) {
            throw lines.fault("a face needs at least three corners, but this one has " + polygon.count());
        }
        beginPart();
        polygon.cut(toCorners);
    }

    /** As in {@code 7}, {@code 7/3}, {@code 7//2} or {@code 7/3/2}. */
    private void corner() throws IOException {
        int vertex = index(lines.slashed("the number of a vertex"), places.size() / 3, "vertex", "vertices");
        int uv = Corners.NONE;
        int normal = Corners.NONE;
        if (lines.slash()) {
            long number = lines.slashed("the number of a place in a picture");
            uv = number == Long.MIN_VALUE ? Corners.NONE : index(number, map.size() / 2, "place in a picture", "of them");
            if (lines.slash()) {
                number = lines.slashed("the number of a normal");
                normal = number == Long.MIN_VALUE ? Corners.NONE : index(number, normals.size() / 3, "normal", "normals");
            }
        }
        polygon.add(corners.vertex(vertex, uv, normal, smoothing), places.get(3 * vertex), places.get(3 * vertex + 1), places.get(3 * vertex + 2));
    }

    private int index(long number, int count, String what, String many) throws IOException {
        long index = number < 0 ? count + number : number - 1;
        if (index < 0 || index >= count) {
            throw number == Long.MIN_VALUE ? lines.fault("a corner must begin with the number of a vertex")
                    : lines.fault("a corner names " + what + " " + number + ", but so far there are " + count + " " + many);
        }
        return (int) index;
    }

    private void other() throws IOException {
        if (lines.is("usemtl")) {
            parts.material(lines.rest());
            isPartNew = true;
        } else if (lines.is("g") || lines.is("o")) {
            parts.group(lines.rest());
            isPartNew = true;
        } else if (lines.is("s")) {
            smoothing = !lines.word() || lines.is("off") ? 0 : (int) Math.min(1_000_000, Math.abs(lines.whole("a smoothing group")));
        } else if (lines.is("mtllib")) {
            library(lines.rest());
        } else if (lines.is("l") || lines.is("p")) {
            notes.line(lines.line(), "lines and points are not read");
        } else {
            unknown();
        }
    }

    private void unknown() {
        notes.line(lines.line(), FormatFault.quoted(lines.text()) + " is not understood");
    }

    private void library(String name) throws IOException {
        try {
            materials.putAll(MtlReader.read(name, companions, notes));
        } catch (FormatFault wrong) {
            throw lines.fault("in the materials " + FormatFault.quoted(name) + ", " + wrong.getMessage());
        } catch (IOException unreadable) {
            notes.missing(lines.line(), "its materials cannot be read: " + unreadable.getMessage());
        }
    }
}
