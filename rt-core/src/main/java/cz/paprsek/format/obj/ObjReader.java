package cz.paprsek.format.obj;

import cz.paprsek.format.model.Companions;
import cz.paprsek.format.model.Convention;
import cz.paprsek.format.model.Doubles;
import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Model;
import cz.paprsek.format.model.Notes;
import cz.paprsek.format.model.Polygon;
import cz.paprsek.format.model.TextLines;
import cz.paprsek.material.Material;
import java.io.IOException;
import java.io.InputStream;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads OBJ: vertices, normals, places in pictures, faces of any number of corners, groups and objects as parts, smoothing groups, materials.
 *
 * @source Wavefront Technologies, Advanced Visualizer Manual, Appendix B1, Object Files, version 3.0
 */
public final class ObjReader {
    private static final Convention CONVENTION = new Convention("", false);

    private final Companions companions;
    private final TextLines lines;
    private final Notes notes = new Notes();
    private final Doubles places = new Doubles();
    private final Doubles normals = new Doubles();
    private final Doubles map = new Doubles();
    private final Corners corners = new Corners(places, normals, map);
    private final Polygon polygon = new Polygon();
    private final Parts parts = new Parts();
    private final Map<String, Material> materials = new LinkedHashMap<>();
    /** Whether the part of the next face is still to be said. */
    private boolean isPartNew = true;
    private int smoothing;

    private final Polygon.Sink toCorners = corners::triangle;

    private ObjReader(InputStream input, Companions companions) throws IOException {
        this.companions = companions;
        this.lines = new TextLines(input, true);
    }

    public static Model read(InputStream input, Companions companions) throws IOException {
        return new ObjReader(input, companions).read();
    }

    private Model read() throws IOException {
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
        if (corners.isEmpty()) {
            throw FormatFault.in("the end", "there is no face in this file" + (places.size() > 0 ? ", only " + places.size() / 3 + " vertices" : ""));
        }
        return new Model(corners.build(), parts.materials(), materials, Map.of(), List.of(), List.of(),
                CONVENTION, notes.toList());
    }

    private void vertex() throws IOException {
        if (lines.length() == 1) {
            places.add(coordinate("x of a vertex"));
            places.add(coordinate("y of a vertex"));
            places.add(coordinate("z of a vertex"));
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

    private double coordinate(String what) throws IOException {
        double value = lines.nextNumber(what);
        if (!(Math.abs(value) <= Float.MAX_VALUE)) {
            throw lines.fault(what + " must be within ±3.4e38, but is " + FormatFault.quoted(lines.text()));
        }
        return value;
    }

    private void face() throws IOException {
        polygon.clear();
        while (lines.beginWord()) {
            corner();
        }
        if (polygon.count() < 3) {
            throw lines.fault("a face needs at least three corners, but this one has " + polygon.count());
        }
        if (isPartNew) {
            corners.part(parts.current());
            isPartNew = false;
        }
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
            notes.line(lines.line(), "its materials cannot be read: " + unreadable.getMessage());
        }
    }
}
