package cz.paprsek.shape.mesh;

import cz.paprsek.math.Bounds;
import java.util.Arrays;

/**
 * Makes few triangles of many: all vertices in a cell of a grid become one, in their middle.
 *
 * @source Rossignac, Borrel, Multi-resolution 3D approximations for rendering complex scenes, Modeling in Computer Graphics, 1993
 */
final class Coarse {
    private static final int CELLS = 40;

    private Coarse() {}

    /** Which are left if there are any that reach through three cells; else the same. */
    static Triangles of(Triangles mesh) {
        Bounds box = mesh.bounds();
        double size = Math.max(box.maxX() - box.minX(), Math.max(box.maxY() - box.minY(), box.maxZ() - box.minZ()));
        double perCell = size / CELLS * (1 + 1e-9);
        int[] numbers = new int[CELLS * CELLS * CELLS];
        double[] sums = new double[3 * mesh.vertexCount()];
        int[] counts = new int[mesh.vertexCount()];
        long[] found = new long[mesh.count()];
        int[] cell = new int[3];
        int cells = 0;
        int triangles = 0;
        for (int t = 0; t < mesh.count(); t++) {
            for (int k = 0; k < 3; k++) {
                int v = mesh.corner(t, k);
                int at = (cell(mesh.x(v), box.minX(), perCell) * CELLS + cell(mesh.y(v), box.minY(), perCell)) * CELLS + cell(mesh.z(v), box.minZ(), perCell);
                cells += numbers[at] == 0 ? 1 : 0;
                numbers[at] = numbers[at] == 0 ? cells : numbers[at];
                cell[k] = numbers[at] - 1;
                sums[3 * cell[k]] += mesh.x(v);
                sums[3 * cell[k] + 1] += mesh.y(v);
                sums[3 * cell[k] + 2] += mesh.z(v);
                counts[cell[k]]++;
            }
            if (cell[0] != cell[1] && cell[1] != cell[2] && cell[2] != cell[0]) {
                found[triangles++] = name(cell);
            }
        }
        long[] distinct = Arrays.stream(found, 0, triangles).sorted().distinct().toArray();
        if (distinct.length == 0) {
            return mesh;
        }
        for (int i = 0; i < 3 * cells; i++) {
            sums[i] /= counts[i / 3];
        }
        int[] corners = new int[3 * distinct.length];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = (int) (distinct[i / 3] >> (20 * (2 - i % 3))) & 0xFFFFF;
        }
        return Triangles.of(Arrays.copyOf(sums, 3 * cells), corners);
    }

    private static int cell(double at, double from, double perCell) {
        return (int) ((at - from) / perCell);
    }

    /** The same for the same three cells in the same direction. There are fewer than 2²⁰. */
    private static long name(int[] cell) {
        int first = cell[0] < cell[1] ? cell[0] < cell[2] ? 0 : 2 : cell[1] < cell[2] ? 1 : 2;
        return ((long) cell[first] << 20 | cell[(first + 1) % 3]) << 20 | cell[(first + 2) % 3];
    }
}
