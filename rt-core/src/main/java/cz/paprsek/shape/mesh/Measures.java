package cz.paprsek.shape.mesh;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;

/** How large meshes are: area and space within. */
final class Measures {
    private Measures() {}

    /** Of all triangles together, in square scene units. */
    static double area(double[] places, int[] corners) {
        double sum = 0;
        for (int i = 0; i < corners.length; i += 3) {
            Vec3 product = product(places, 3 * corners[i], 3 * corners[i + 1], 3 * corners[i + 2]);
            sum += Math.sqrt(product.dot(product));
        }
        return sum / 2;
    }

    /** The product (b − a) × (c − a) of two sides of a triangle, of which the corners' places begin there: its normal, twice as long as it is large. */
    static Vec3 product(double[] places, int a, int b, int c) {
        return product(places[b] - places[a], places[b + 1] - places[a + 1], places[b + 2] - places[a + 2],
                places[c] - places[a], places[c + 1] - places[a + 1], places[c + 2] - places[a + 2]);
    }

    /** The same of corners that are floats, one after the other. */
    static Vec3 product(float[] at, int a) {
        double x = at[a];
        double y = at[a + 3];
        double z = at[a + 6];
        return product(at[a + 1] - x, at[a + 4] - y, at[a + 7] - z, at[a + 2] - x, at[a + 5] - y, at[a + 8] - z);
    }

    private static Vec3 product(double ux, double uy, double uz, double vx, double vy, double vz) {
        return new Vec3(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
    }

    /** Six times the space within. Told from the middle, so that far away no digits are lost. */
    static double sixfoldVolume(double[] places, int[] corners, Bounds bounds) {
        double x = (bounds.minX() + bounds.maxX()) / 2;
        double y = (bounds.minY() + bounds.maxY()) / 2;
        double z = (bounds.minZ() + bounds.maxZ()) / 2;
        double sum = 0;
        for (int t = 0; t < corners.length / 3; t++) {
            sum += sixfoldVolume(places, corners, t, x, y, z);
        }
        return sum;
    }

    /** a·(b × c) of the corners of a triangle, from a point. */
    static double sixfoldVolume(double[] places, int[] corners, int triangle, double x, double y, double z) {
        int a = 3 * corners[3 * triangle];
        int b = 3 * corners[3 * triangle + 1];
        int c = 3 * corners[3 * triangle + 2];
        double bx = places[b] - x;
        double by = places[b + 1] - y;
        double bz = places[b + 2] - z;
        double cx = places[c] - x;
        double cy = places[c + 1] - y;
        double cz = places[c + 2] - z;
        return (places[a] - x) * (by * cz - bz * cy) + (places[a + 1] - y) * (bz * cx - bx * cz) + (places[a + 2] - z) * (bx * cy - by * cx);
    }
}
