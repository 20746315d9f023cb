package cz.paprsek.shape.mesh;

import cz.paprsek.math.Affine;
import java.util.BitSet;

/** Triangles in another space, or turned round. */
final class Moved {
    private Moved() {}

    /** Places and normals moved, turned and stretched; corners turned round if the map mirrors. */
    static Triangles into(Affine toOther, Triangles from) {
        Triangles moved = new Triangles(places(toOther, from.places()), from.corners(), normals(toOther.inverse(), from.normals()), from.map(), from.colors(), from.parts(), from.partNumbers());
        if (!toOther.mirrors()) {
            return moved;
        }
        BitSet all = new BitSet();
        all.set(0, from.count());
        return turned(moved, all);
    }

    private static double[] places(Affine toOther, double[] places) {
        double[] moved = new double[places.length];
        for (int i = 0; i < moved.length; i += 3) {
            moved[i] = toOther.pointX(places[i], places[i + 1], places[i + 2]);
            moved[i + 1] = toOther.pointY(places[i], places[i + 1], places[i + 2]);
            moved[i + 2] = toOther.pointZ(places[i], places[i + 1], places[i + 2]);
        }
        return moved;
    }

    /** By the transpose of the map that leads back, and of length 1; 0 stays 0. */
    private static float[] normals(Affine back, float[] normals) {
        float[] moved = new float[normals.length];
        for (int i = 0; i < moved.length; i += 3) {
            double x = back.xx() * normals[i] + back.yx() * normals[i + 1] + back.zx() * normals[i + 2];
            double y = back.xy() * normals[i] + back.yy() * normals[i + 1] + back.zy() * normals[i + 2];
            double z = back.xz() * normals[i] + back.yz() * normals[i + 1] + back.zz() * normals[i + 2];
            double length = Math.sqrt(x * x + y * y + z * z);
            double k = length > 0 ? 1 / length : 0;
            moved[i] = (float) (x * k);
            moved[i + 1] = (float) (y * k);
            moved[i + 2] = (float) (z * k);
        }
        return moved;
    }

    /** With some triangles turned round. Their normals stay: of a vertex they are right for its neighbours, or wrong for all. */
    static Triangles turned(Triangles mesh, BitSet those) {
        int[] corners = mesh.corners();
        int[] round = corners.clone();
        for (int t = those.nextSetBit(0); t >= 0; t = those.nextSetBit(t + 1)) {
            round[3 * t + 1] = corners[3 * t + 2];
            round[3 * t + 2] = corners[3 * t + 1];
        }
        return new Triangles(mesh.places(), round, mesh.normals(), mesh.map(), mesh.colors(), mesh.parts(), mesh.partNumbers());
    }
}
