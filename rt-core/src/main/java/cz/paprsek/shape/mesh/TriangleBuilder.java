package cz.paprsek.shape.mesh;

import java.util.Arrays;

/** What {@link Triangles.Builder} does, which is the only one of its kind. */
abstract sealed class TriangleBuilder permits Triangles.Builder {
    private double[] places = new double[3 * 64];
    private int vertices;
    private int[] corners = new int[3 * 64];
    private int triangles;
    private float[] normals = {};
    private float[] map = {};
    private float[] colors = {};
    private final GrowingParts parts = new GrowingParts();

    TriangleBuilder() {}

    abstract Triangles.Builder self();

    /** Makes room for so many, if it is known: no array then grows. */
    public Triangles.Builder expect(int vertexCount, int triangleCount) {
        places = Arrays.copyOf(places, Math.max(places.length, Growing.threes(vertexCount)));
        corners = Arrays.copyOf(corners, Math.max(corners.length, Growing.threes(triangleCount)));
        return self();
    }

    /** Adds a vertex and returns its number. */
    public int vertex(double x, double y, double z) {
        if (3 * vertices == places.length) {
            places = Arrays.copyOf(places, Growing.from(places.length));
        }
        places[3 * vertices] = x;
        places[3 * vertices + 1] = y;
        places[3 * vertices + 2] = z;
        return vertices++;
    }

    /** Sets the normal of a vertex that has been added, of any length. Vertices without one take that of their triangle. */
    public Triangles.Builder normal(int vertex, double x, double y, double z) {
        if (normals.length < 3 * vertices) {
            normals = Arrays.copyOf(normals, places.length);
        }
        normals[3 * vertex] = (float) x;
        normals[3 * vertex + 1] = (float) y;
        normals[3 * vertex + 2] = (float) z;
        return self();
    }

    /** Sets the place in a picture of a vertex that has been added. */
    public Triangles.Builder map(int vertex, double u, double v) {
        if (map.length < 2 * vertices) {
            map = Arrays.copyOf(map, places.length / 3 * 2);
        }
        map[2 * vertex] = (float) u;
        map[2 * vertex + 1] = (float) v;
        return self();
    }

    /** Sets what the material's colour is multiplied by at a vertex that has been added, linear light; 1 1 1 for those that are not told. */
    public Triangles.Builder color(int vertex, double red, double green, double blue) {
        if (colors.length < 3 * vertices) {
            int told = colors.length;
            colors = Arrays.copyOf(colors, places.length);
            Arrays.fill(colors, told, colors.length, 1);
        }
        colors[3 * vertex] = (float) red;
        colors[3 * vertex + 1] = (float) green;
        colors[3 * vertex + 2] = (float) blue;
        return self();
    }

    /** Says to which part the triangles belong that come from now on: a new one, or one that was named before. */
    public Triangles.Builder part(String name) {
        parts.begin(name, triangles);
        return self();
    }

    /** Adds a triangle by the numbers of three vertices, counter-clockwise as seen from outside, and returns its number. */
    public int triangle(int a, int b, int c) {
        if (3 * triangles == corners.length) {
            corners = Arrays.copyOf(corners, Growing.from(corners.length));
        }
        parts.add(triangles);
        corners[3 * triangles] = a;
        corners[3 * triangles + 1] = b;
        corners[3 * triangles + 2] = c;
        return triangles++;
    }

    public int vertexCount() {
        return vertices;
    }

    public int triangleCount() {
        return triangles;
    }

    /**
     * The triangles.
     *
     * @throws IllegalArgumentException if there is none, or a number cannot be; in a sentence that says of which vertex or triangle
     */
    public Triangles build() {
        int told = colors.length;
        float[] all = Growing.cut(colors, 3 * vertices);
        if (told > 0 && told < all.length) {
            Arrays.fill(all, told, all.length, 1);
        }
        return new Triangles(Growing.cut(places, 3 * vertices), Growing.cut(corners, 3 * triangles), Growing.cut(normals, 3 * vertices), Growing.cut(map, 2 * vertices), all,
                parts.names(), parts.numbers(triangles));
    }
}
