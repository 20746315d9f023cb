package cz.paprsek.format.model;

import cz.paprsek.material.Rgb;
import cz.paprsek.shape.mesh.Triangles;
import java.util.stream.IntStream;

/**
 * Vertices and faces of any number of corners, as a file tells them: cut into triangles when all are known. Normals, places in pictures and colours come with each vertex or with none; where
 * faces have colours, those of vertices do not count.
 */
public final class Faces {
    private static final int WHITE = 0xFFFFFF;
    private static final double[] LIGHT = IntStream.range(0, 256).mapToDouble(Rgb::linear).toArray();

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

    /** Three numbers for each vertex. */
    public Doubles places() {
        return places;
    }

    /** Three numbers for each vertex, of any length. */
    public Doubles normals() {
        return normals;
    }

    /** Two numbers for each vertex. */
    public Doubles map() {
        return map;
    }

    /** A channel of a vertex: sRGB, 0–255; what is beyond is cut off. */
    public void vertexColor(double channel) {
        double value = within(channel);
        vertexColors.add((float) (value == Math.rint(value) ? LIGHT[(int) value] : Rgb.linear(value)));
    }

    /** Of the face that came last, in sRGB, 0–255; others are white. */
    public void faceColor(double red, double green, double blue) {
        faceColor(count() - 1, red, green, blue);
    }

    /** Of a face by its number, after all those of faces before it. */
    public void faceColor(int face, double red, double green, double blue) {
        while (faceColors.size() < face) {
            faceColors.add(WHITE);
        }
        faceColors.add((int) Math.rint(within(red)) << 16 | (int) Math.rint(within(green)) << 8 | (int) Math.rint(within(blue)));
    }

    /** How many faces were begun. */
    public int count() {
        return sizes.size();
    }

    private static double within(double channel) {
        return channel > 0 ? Math.min(255, channel) : 0;
    }

    /** Begins a face. */
    public void face(int cornerCount) {
        sizes.add(cornerCount);
    }

    /** One of the corners of the face that was begun: the number of a vertex, from 0. */
    public void corner(int vertex) {
        corners.add(vertex);
    }

    /**
     * The mesh of them.
     *
     * @param notes takes what was not done as it should
     * @throws FormatFault if there is no face, or one has a corner that is no vertex
     */
    public Triangles build(Notes notes) throws FormatFault {
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
        boolean isHurried = false;
        Pairs colored = new Pairs();
        int at = 0;
        for (int f = 0; f < sizes.size(); f++) {
            if (sizes.get(f) == 3 && !areFacesColored) {
                triangle(builder, f, at);
                at += 3;
                continue;
            }
            polygon.clear();
            for (int k = 0; k < sizes.get(f); k++) {
                int vertex = corner(f, at++);
                polygon.add(areFacesColored ? colored(builder, colored, vertex, f) : vertex, places.get(3 * vertex), places.get(3 * vertex + 1), places.get(3 * vertex + 2));
            }
            polygon.cut((a, b, c) -> {
                if (a != b && b != c && a != c) {
                    builder.triangle(a, b, c);
                }
            });
            if (polygon.isHurried() && !isHurried) {
                isHurried = true;
                notes.add("face " + f, Polygon.HURRIED);
            }
        }
        if (builder.triangleCount() == 0) {
            throw FormatFault.in("the end", "no face of this file has three corners");
        }
        return builder.build();
    }

    private void triangle(Triangles.Builder builder, int face, int at) throws FormatFault {
        int a = corner(face, at);
        int b = corner(face, at + 1);
        int c = corner(face, at + 2);
        if (a != b && b != c && a != c) {
            builder.triangle(a, b, c);
        }
    }

    /** A corner of a face, by its place among those of all. */
    private int corner(int face, int at) throws FormatFault {
        int vertex = corners.get(at);
        if (vertex >= places.size() / 3) {
            throw FormatFault.in("face " + face, "a corner is vertex " + vertex + ", but vertices have numbers from 0 to " + (places.size() / 3 - 1));
        }
        return vertex;
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
