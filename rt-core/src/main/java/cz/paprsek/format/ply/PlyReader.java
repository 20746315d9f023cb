package cz.paprsek.format.ply;

import cz.paprsek.format.model.Convention;
import cz.paprsek.format.model.Doubles;
import cz.paprsek.format.model.Floats;
import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Ints;
import cz.paprsek.format.model.Model;
import cz.paprsek.format.model.Notes;
import cz.paprsek.format.model.Pairs;
import cz.paprsek.format.model.Polygon;
import cz.paprsek.format.model.TextLines;
import cz.paprsek.material.Rgb;
import cz.paprsek.shape.mesh.Triangles;
import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.stream.IntStream;

/**
 * Reads PLY: vertices with normals, places in pictures and colours, faces of any number of corners, strips of triangles. Properties may come in any order; those that are not
 * known, and elements that are not, are passed over.
 *
 * @source Turk, The PLY Polygon File Format, 1994
 */
public final class PlyReader {
    private static final Convention CONVENTION = new Convention("", false);
    private static final int MOST_CORNERS = 1_000_000;
    private static final int WHITE = 0xFFFFFF;
    private static final double[] LIGHT = IntStream.range(0, 256).mapToDouble(Rgb::linear).toArray();

    private final Notes notes = new Notes();
    private final Header header;
    private final Values values;
    private final Doubles places = new Doubles();
    private final Doubles normals = new Doubles();
    private final Doubles map = new Doubles();
    /** Linear light, three for each vertex. */
    private final Floats vertexColors = new Floats();
    /** sRGB, a byte for each of the three channels. */
    private final Ints faceColors = new Ints();
    /** How many corners each face has, and which. */
    private final Ints sizes = new Ints();
    private final Ints corners = new Ints();

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
        return Model.of(build(), CONVENTION, notes);
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
            take(row, place, places);
            take(row, normal, normals);
            take(row, uv, map);
            if (isAll(color)) {
                for (int index : color) {
                    vertexColors.add(light(channel(element, row, index)));
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

    /** An sRGB channel, 0–255. Numbers with a fraction go up to 1, others to 255 or 65535. */
    private static double channel(Element element, double[] row, int index) {
        Property.Kind kind = element.properties().get(index).kind();
        double value = kind.isFraction() ? row[index] * 255 : kind.bytes == 2 ? row[index] / 257 : row[index];
        return value > 0 ? Math.min(255, value) : 0;
    }

    private static int whole(Element element, double[] row, int index) {
        return (int) Math.rint(channel(element, row, index));
    }

    private static float light(double channel) {
        return (float) (channel == Math.rint(channel) ? LIGHT[(int) channel] : Rgb.linear(channel));
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
                faceColors.add(whole(element, row, color[0]) << 16 | whole(element, row, color[1]) << 8 | whole(element, row, color[2]));
            }
        }
    }

    private int corners(Property property) throws IOException {
        long count = length(property);
        if (count < 3 || count > MOST_CORNERS) {
            throw values.fault("a face has from 3 to " + MOST_CORNERS + " corners, but this one has " + count);
        }
        sizes.add((int) count);
        for (long i = 0; i < count; i++) {
            corners.add(index(values.next(property.kind())));
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
                sizes.add(3);
                corners.add(known % 2 == 1 ? a : b);
                corners.add(known % 2 == 1 ? b : a);
                corners.add(c);
            }
            a = b;
            b = c;
        }
    }

    private Triangles build() throws IOException {
        int vertexCount = places.size() / 3;
        if (sizes.size() == 0) {
            throw FormatFault.in("the end", "there is no face in this file" + (vertexCount > 0 ? ", only " + vertexCount + " vertices" : ""));
        }
        Triangles.Builder builder = Triangles.builder().expect(vertexCount, sizes.size());
        boolean areFacesColored = faceColors.size() > 0;
        for (int i = 0; i < vertexCount && !areFacesColored; i++) {
            int vertex = vertex(builder, i);
            if (vertexColors.size() > 0) {
                builder.color(vertex, vertexColors.get(3 * i), vertexColors.get(3 * i + 1), vertexColors.get(3 * i + 2));
            }
        }
        Polygon polygon = new Polygon();
        Pairs colored = new Pairs();
        int at = 0;
        for (int f = 0; f < sizes.size(); f++) {
            polygon.clear();
            for (int k = 0; k < sizes.get(f); k++) {
                int vertex = corners.get(at++);
                if (vertex >= vertexCount) {
                    throw FormatFault.in("face " + f, "a corner is vertex " + vertex + ", but vertices have numbers from 0 to " + (vertexCount - 1));
                }
                polygon.add(areFacesColored ? colored(builder, colored, vertex, f) : vertex, places.get(3 * vertex), places.get(3 * vertex + 1), places.get(3 * vertex + 2));
            }
            polygon.cut((a, b, c) -> {
                if (a != b && b != c && a != c) {
                    builder.triangle(a, b, c);
                }
            });
        }
        if (builder.triangleCount() == 0) {
            throw FormatFault.in("the end", "no face of this file has three corners");
        }
        return builder.build();
    }

    /** The vertex that has a vertex's place and the colour of a face. */
    private int colored(Triangles.Builder builder, Pairs known, int vertex, int face) {
        int color = face < faceColors.size() ? faceColors.get(face) : WHITE;
        int number = known.number(vertex, color);
        if (number == builder.vertexCount()) {
            vertex(builder, vertex);
            builder.color(number, LIGHT[color >> 16], LIGHT[color >> 8 & 255], LIGHT[color & 255]);
        }
        return number;
    }

    private int vertex(Triangles.Builder builder, int number) {
        int vertex = builder.vertex(places.get(3 * number), places.get(3 * number + 1), places.get(3 * number + 2));
        if (normals.size() > 0) {
            builder.normal(vertex, normals.get(3 * number), normals.get(3 * number + 1), normals.get(3 * number + 2));
        }
        if (map.size() > 0) {
            builder.map(vertex, map.get(2 * number), map.get(2 * number + 1));
        }
        return vertex;
    }
}
