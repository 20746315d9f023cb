package cz.paprsek.shape.mesh;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Require;
import java.util.HashSet;
import java.util.List;

/** What the numbers of triangles must be. */
final class TriangleCheck {
    /** What a colour may be multiplied by. */
    private static final int BRIGHTEST = 1000;

    private TriangleCheck() {}

    /**
     * Checks all of them.
     *
     * @return the box around the vertices that triangles have
     * @throws IllegalArgumentException with a sentence that says which vertex or triangle is wrong
     */
    static Bounds check(double[] places, int[] corners, float[] normals, float[] map, float[] colors, List<String> partNames, int[] partNumbers) {
        int vertices = places.length / 3;
        int count = corners.length / 3;
        Require.that(corners.length > 0, "a mesh needs at least one triangle, but has none");
        Require.that(places.length % 3 == 0, "a mesh has three coordinates for each vertex, but there are " + places.length);
        Require.that(corners.length % 3 == 0, "a mesh has three corners for each triangle, but there are " + corners.length);
        Require.that(normals.length == 0 || normals.length == places.length,
                "a mesh has a normal of three numbers for each of its " + vertices + " vertices, or none at all, but there are " + normals.length + " numbers");
        Require.that(map.length == 0 || map.length == vertices * 2,
                "a mesh has u and v for each of its " + vertices + " vertices, or none at all, but there are " + map.length + " numbers");
        Require.that(colors.length == 0 || colors.length == places.length,
                "a mesh has a colour of three numbers for each of its " + vertices + " vertices, or none at all, but there are " + colors.length + " numbers");
        Require.that(partNumbers.length == 0 || partNumbers.length == count,
                "a mesh has a part for each of its " + count + " triangles, or none at all, but there are " + partNumbers.length);
        Require.that(!partNames.isEmpty(), "a mesh has at least one part");
        Require.that(new HashSet<>(partNames).size() == partNames.size(), "the parts of a mesh have different names");
        checkPlaces(places);
        checkFloats(normals, map);
        checkColors(colors);
        checkParts(partNumbers, partNames.size());
        return bounds(places, corners);
    }

    private static void checkPlaces(double[] places) {
        for (int i = 0; i < places.length; i++) {
            if (!(Math.abs(places[i]) <= Require.LARGEST)) {
                Require.coordinate("coordinate " + "xyz".charAt(i % 3) + " of vertex " + i / 3, places[i]);
            }
        }
    }

    private static void checkFloats(float[] normals, float[] map) {
        for (int i = 0; i < normals.length; i++) {
            if (!(Math.abs(normals[i]) <= Float.MAX_VALUE)) {
                Require.finite("normal of vertex " + i / 3, normals[i]);
            }
        }
        for (int i = 0; i < map.length; i++) {
            if (!(Math.abs(map[i]) <= Float.MAX_VALUE)) {
                Require.finite((i % 2 == 0 ? "u" : "v") + " of vertex " + i / 2, map[i]);
            }
        }
    }

    private static void checkColors(float[] colors) {
        for (int i = 0; i < colors.length; i++) {
            if (!(colors[i] >= 0 && colors[i] <= BRIGHTEST)) {
                throw new IllegalArgumentException("the colour of vertex " + i / 3 + " must be of numbers from 0 to " + BRIGHTEST + ", but one is " + colors[i]);
            }
        }
    }

    private static void checkParts(int[] partNumbers, int parts) {
        for (int i = 0; i < partNumbers.length; i++) {
            if (partNumbers[i] < 0 || partNumbers[i] >= parts) {
                throw new IllegalArgumentException("triangle " + i + " belongs to part " + partNumbers[i] + ", but parts have numbers from 0 to " + (parts - 1));
            }
        }
    }

    private static Bounds bounds(double[] places, int[] corners) {
        int vertices = places.length / 3;
        boolean[] isCorner = new boolean[vertices];
        for (int i = 0; i < corners.length; i++) {
            int vertex = corners[i];
            if (vertex < 0 || vertex >= vertices) {
                throw new IllegalArgumentException("a corner of triangle " + i / 3 + " is vertex " + vertex + ", but vertices have numbers from 0 to " + (vertices - 1));
            }
            isCorner[vertex] = true;
        }
        double minX = Double.POSITIVE_INFINITY;
        double minY = minX;
        double minZ = minX;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxY = maxX;
        double maxZ = maxX;
        for (int vertex = 0; vertex < vertices; vertex++) {
            if (!isCorner[vertex]) {
                continue;
            }
            double x = places[3 * vertex];
            double y = places[3 * vertex + 1];
            double z = places[3 * vertex + 2];
            minX = x < minX ? x : minX;
            minY = y < minY ? y : minY;
            minZ = z < minZ ? z : minZ;
            maxX = x > maxX ? x : maxX;
            maxY = y > maxY ? y : maxY;
            maxZ = z > maxZ ? z : maxZ;
        }
        return new Bounds(minX, minY, minZ, maxX, maxY, maxZ);
    }
}
