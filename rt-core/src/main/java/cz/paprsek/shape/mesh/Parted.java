package cz.paprsek.shape.mesh;

import java.util.Arrays;
import java.util.List;

/** Takes a part out of triangles. */
final class Parted {
    private Parted() {}

    /** The triangles of one part, with the vertices that they have, in the old order. */
    static Triangles only(Triangles all, int part) {
        if (all.parts().size() == 1) {
            return all;
        }
        int[] numbers = new int[all.vertexCount()];
        int count = 0;
        for (int t = 0; t < all.count(); t++) {
            if (all.part(t) == part) {
                count++;
                for (int k = 0; k < 3; k++) {
                    numbers[all.corner(t, k)] = 1;
                }
            }
        }
        double[] places = new double[all.places().length];
        float[] normals = new float[all.normals().length];
        float[] map = new float[all.map().length];
        float[] colors = new float[all.colors().length];
        int kept = 0;
        for (int v = 0; v < numbers.length; v++) {
            if (numbers[v] == 1) {
                System.arraycopy(all.places(), 3 * v, places, 3 * kept, 3);
                if (all.hasNormals()) {
                    System.arraycopy(all.normals(), 3 * v, normals, 3 * kept, 3);
                }
                if (all.hasMap()) {
                    System.arraycopy(all.map(), 2 * v, map, 2 * kept, 2);
                }
                if (all.hasColors()) {
                    System.arraycopy(all.colors(), 3 * v, colors, 3 * kept, 3);
                }
                numbers[v] = kept++;
            }
        }
        int[] corners = new int[3 * count];
        int at = 0;
        for (int t = 0; t < all.count(); t++) {
            if (all.part(t) == part) {
                for (int k = 0; k < 3; k++) {
                    corners[at++] = numbers[all.corner(t, k)];
                }
            }
        }
        return new Triangles(Arrays.copyOf(places, 3 * kept), corners, all.hasNormals() ? Arrays.copyOf(normals, 3 * kept) : normals,
                all.hasMap() ? Arrays.copyOf(map, 2 * kept) : map, all.hasColors() ? Arrays.copyOf(colors, 3 * kept) : colors, List.of(all.parts().get(part)), new int[0]);
    }
}
