package cz.paprsek.tree;

import cz.paprsek.math.Bounds;

/** Lets tests elsewhere ask a bundle. */
public final class Bundles {
    private Bundles() {}

    /** Whether a line of the bundle may meet a box. */
    public static boolean mayMeet(Bundle bundle, Bounds box) {
        return enters(bundle, box) < Double.POSITIVE_INFINITY;
    }

    /** A length before which no line of the bundle is in a box, directions being of length 1. */
    public static double enters(Bundle bundle, Bounds box) {
        double unit = bundle.shortest();
        return bundle.enter(box.minX(), box.minY(), box.minZ(), box.maxX(), box.maxY(), box.maxZ()) * unit;
    }
}
