package cz.paprsek.format.gltf;

import cz.paprsek.math.Affine;
import java.io.IOException;

/**
 * The bones of a mesh where their nodes have them at first, and how much each vertex hangs on each: a vertex goes where the mean of its bones, weighted, takes it; the node of
 * the mesh itself makes no difference.
 *
 * @source Khronos Group, glTF 2.0 Specification, 2021, §3.7.3
 */
final class Skin {
    private static final int AT_ONCE = 4;
    private static final int NUMBERS = 16;

    private final Affine[] bones;

    private Skin(Affine[] bones) {
        this.bones = bones;
    }

    /** @param worlds where each node is; that of one that is not in the scene is the identity */
    static Skin of(Tree skin, Accessors accessors, Affine[] worlds) throws IOException {
        int[] joints = skin.indexes("joints", worlds.length);
        if (joints.length == 0) {
            throw skin.fault("joints", "a skin must have at least one");
        }
        float[] back = skin.has("inverseBindMatrices") ? accessors.floats(skin.needed("inverseBindMatrices"), "MAT4") : new float[0];
        if (back.length > 0 && back.length < NUMBERS * joints.length) {
            throw skin.fault("inverseBindMatrices", "there must be one for each of " + joints.length + " joints");
        }
        Affine[] bones = new Affine[joints.length];
        for (int i = 0; i < joints.length; i++) {
            bones[i] = back.length == 0 ? worlds[joints[i]] : worlds[joints[i]].after(matrix(back, NUMBERS * i));
        }
        return new Skin(bones);
    }

    /** Of columns. */
    private static Affine matrix(float[] m, int at) {
        return new Affine(m[at], m[at + 4], m[at + 8], m[at + 12], m[at + 1], m[at + 5], m[at + 9], m[at + 13], m[at + 2], m[at + 6], m[at + 10], m[at + 14]);
    }

    /** Where each of so many vertices is put. */
    Affine[] placements(Tree attributes, Accessors accessors, int count) throws IOException {
        double[][] sums = new double[count][13];
        for (int set = 0; attributes.has("JOINTS_" + set); set++) {
            float[] joints = accessors.floats(attributes.needed("JOINTS_" + set), "VEC4");
            float[] weights = accessors.floats(attributes.needed("WEIGHTS_" + set), "VEC4");
            if (joints.length != AT_ONCE * count || weights.length != joints.length) {
                throw attributes.fault("JOINTS_" + set, "there must be as many joints and weights as vertices");
            }
            for (int i = 0; i < joints.length; i++) {
                if (weights[i] > 0) {
                    if (!(joints[i] >= 0 && joints[i] < bones.length)) {
                        throw attributes.fault("JOINTS_" + set, "vertex " + i / AT_ONCE + " hangs on joint " + (long) joints[i] + ", but there are " + bones.length);
                    }
                    add(bones[(int) joints[i]], weights[i], sums[i / AT_ONCE]);
                }
            }
        }
        Affine[] placements = new Affine[count];
        for (int i = 0; i < count; i++) {
            double[] s = sums[i];
            double k = 1 / s[12];
            placements[i] = s[12] > 0 ? new Affine(k * s[0], k * s[1], k * s[2], k * s[3], k * s[4], k * s[5], k * s[6], k * s[7], k * s[8], k * s[9], k * s[10], k * s[11]) : bones[0];
        }
        return placements;
    }

    private static void add(Affine bone, double weight, double[] to) {
        double[] numbers = {bone.xx(), bone.xy(), bone.xz(), bone.xt(), bone.yx(), bone.yy(), bone.yz(), bone.yt(), bone.zx(), bone.zy(), bone.zz(), bone.zt(), 1};
        for (int i = 0; i < numbers.length; i++) {
            to[i] += weight * numbers[i];
        }
    }

    /** Of a vertex that hangs on the first bone alone. */
    Affine first() {
        return bones[0];
    }
}
