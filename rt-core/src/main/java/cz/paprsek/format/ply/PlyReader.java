package cz.paprsek.format.ply;

import cz.paprsek.format.model.Convention;
import cz.paprsek.format.model.Doubles;
import cz.paprsek.format.model.Faces;
import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Model;
import cz.paprsek.format.model.Notes;
import cz.paprsek.format.model.TextLines;
import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;

/**
 * Reads PLY: vertices with normals, places in pictures and colours, faces of any number of corners, strips of triangles. Properties may come in any order; those that are not
 * known, and elements that are not, are passed over.
 *
 * @source Turk, The PLY Polygon File Format, 1994
 */
public final class PlyReader {
    private static final Convention CONVENTION = new Convention("", false);
    private static final int MOST_CORNERS = 1_000_000;

    private final Notes notes = new Notes();
    private final Header header;
    private final Values values;
    private final Faces faces = new Faces();

    private PlyReader(Header header, Values values) {
        this.header = header;
        this.values = values;
    }

    /** @param size how many bytes there are; {@link Long#MAX_VALUE} if nobody knows */
    public static Model read(InputStream input, long size) throws IOException {
        InputStream buffered = new BufferedInputStream(input, 1 << 16);
        Header header = Header.read(buffered);
        for (Element element : header.elements()) {
            long least = header.isLittle().isPresent() ? element.leastBytes() : element.properties().isEmpty() ? 0 : 2;
            if (size != Long.MAX_VALUE && least > 0 && element.count() > (size - header.bytes()) / least + 1) {
                throw FormatFault.line(header.lines(), "the file says it has " + element.count() + " times " + FormatFault.quoted(element.name())
                        + ", but is only " + size + " bytes long");
            }
        }
        Values values = header.isLittle().isPresent() ? Values.bytes(buffered, header.isLittle().get(), header.bytes())
                : Values.text(new TextLines(buffered, false).after(header.lines()));
        return new PlyReader(header, values).read();
    }

    private Model read() throws IOException {
        for (Element element : header.elements()) {
            try {
                switch (element.name()) {
                    case "vertex" -> vertices(element);
                    case "face" -> faces(element);
                    case "tristrips" -> strips(element);
                    default -> passOver(element);
                }
            } catch (EOFException e) {
                throw values.ended("the file ends before all of its " + element.count() + " times " + FormatFault.quoted(element.name()));
            }
        }
        return Model.of(faces.build(notes), CONVENTION, notes);
    }

    private void passOver(Element element) throws IOException {
        notes.add("", "elements " + FormatFault.quoted(element.name()) + " are not read");
        for (long i = 0; i < element.count() && !element.properties().isEmpty(); i++) {
            for (Property property : element.properties()) {
                value(property);
            }
        }
    }

    /** A single number; the first of a list, which is passed over, or 0 if it is empty. */
    private double value(Property property) throws IOException {
        if (!property.isList()) {
            return values.next(property.kind());
        }
        double first = 0;
        long count = length(property);
        for (long i = 0; i < count; i++) {
            double value = values.next(property.kind());
            first = i == 0 ? value : first;
        }
        return first;
    }

    private long length(Property property) throws IOException {
        double count = values.next(property.count().orElseThrow());
        if (!(count >= 0 && count < 1L << 32) || count != Math.rint(count)) {
            throw values.fault("a list has a length of 0 or more, but here is " + count);
        }
        return (long) count;
    }

    private void vertices(Element element) throws IOException {
        int[] place = {element.indexOf("x"), element.indexOf("y"), element.indexOf("z")};
        int[] normal = {element.indexOf("nx"), element.indexOf("ny"), element.indexOf("nz")};
        int[] uv = {element.indexOf("u", "s", "texture_u", "texture_s"), element.indexOf("v", "t", "texture_v", "texture_t")};
        int[] color = colors(element);
        if (!isAll(place)) {
            throw FormatFault.line(header.lines(), "vertices must have x, y and z");
        }
        double[] row = new double[element.properties().size()];
        for (long i = 0; i < element.count(); i++) {
            for (int k = 0; k < row.length; k++) {
                row[k] = value(element.properties().get(k));
            }
            for (int index : place) {
                if (!(Math.abs(row[index]) <= Float.MAX_VALUE)) {
                    throw values.fault("vertex " + i + " must have three numbers within ±3.4e38, but has " + row[place[0]] + " " + row[place[1]] + " " + row[place[2]]);
                }
            }
            take(row, place, faces.places());
            take(row, normal, faces.normals());
            take(row, uv, faces.map());
            if (isAll(color)) {
                for (int index : color) {
                    faces.vertexColor(channel(element, row, index));
                }
            }
        }
    }

    private static int[] colors(Element element) {
        return new int[] {element.indexOf("red", "diffuse_red", "r"), element.indexOf("green", "diffuse_green", "g"), element.indexOf("blue", "diffuse_blue", "b")};
    }

    private static boolean isAll(int... indexes) {
        for (int index : indexes) {
            if (index < 0) {
                return false;
            }
        }
        return true;
    }

    private static void take(double[] row, int[] indexes, Doubles into) {
        if (isAll(indexes)) {
            for (int index : indexes) {
                into.add(Math.abs(row[index]) <= Float.MAX_VALUE ? row[index] : 0);
            }
        }
    }

    /** An sRGB channel, of which 0–255 counts. Numbers with a fraction go up to 1, others to 255 or 65535. */
    private static double channel(Element element, double[] row, int index) {
        Property.Kind kind = element.properties().get(index).kind();
        return kind.isFraction() ? row[index] * 255 : kind.bytes == 2 ? row[index] / 257 : row[index];
    }

    private void faces(Element element) throws IOException {
        int list = element.indexOf("vertex_indices", "vertex_index");
        if (list < 0 || !element.properties().get(list).isList()) {
            throw FormatFault.line(header.lines(), "faces must have a list \"vertex_indices\"");
        }
        int[] color = colors(element);
        double[] row = new double[element.properties().size()];
        for (long i = 0; i < element.count(); i++) {
            for (int k = 0; k < row.length; k++) {
                Property property = element.properties().get(k);
                row[k] = k == list ? corners(property) : value(property);
            }
            if (isAll(color)) {
                faces.faceColor(channel(element, row, color[0]), channel(element, row, color[1]), channel(element, row, color[2]));
            }
        }
    }

    private int corners(Property property) throws IOException {
        long count = length(property);
        if (count < 3 || count > MOST_CORNERS) {
            throw values.fault("a face has from 3 to " + MOST_CORNERS + " corners, but this one has " + count);
        }
        faces.face((int) count);
        for (long i = 0; i < count; i++) {
            faces.corner(index(values.next(property.kind())));
        }
        return 0;
    }

    private int index(double value) throws IOException {
        if (!(value >= 0 && value <= Integer.MAX_VALUE && value == Math.rint(value))) {
            throw values.fault("a corner must be the number of a vertex, but is " + value);
        }
        return (int) value;
    }

    /** Each vertex makes a triangle with the two before it, turned round every second time; −1 begins anew. */
    private void strips(Element element) throws IOException {
        int list = element.indexOf("vertex_indices", "vertex_index");
        if (list < 0 || !element.properties().get(list).isList()) {
            passOver(element);
            return;
        }
        for (long i = 0; i < element.count(); i++) {
            for (int k = 0; k < element.properties().size(); k++) {
                if (k == list) {
                    strip(element.properties().get(k));
                } else {
                    value(element.properties().get(k));
                }
            }
        }
    }

    private void strip(Property property) throws IOException {
        long count = length(property);
        int a = 0;
        int b = 0;
        int known = 0;
        for (long i = 0; i < count; i++) {
            double value = values.next(property.kind());
            if (value == -1) {
                known = 0;
                continue;
            }
            int c = index(value);
            if (++known >= 3) {
                faces.face(3);
                faces.corner(known % 2 == 1 ? a : b);
                faces.corner(known % 2 == 1 ? b : a);
                faces.corner(c);
            }
            a = b;
            b = c;
        }
    }
}
