package cz.paprsek.material;

import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;

/** What gives a surface its colour at each point. */
public sealed interface Pattern {

    /** One colour everywhere. */
    record Plain(Rgb color) implements Pattern {}

    /**
     * A board of columns × rows squares over a rectangle or disc; the square at the minimum corner is even.
     * Columns run along the surface's x, rows along its y. At most {@value #MOST} each way.
     */
    record Checkerboard(int columns, int rows, Rgb even, Rgb odd) implements Pattern {
        public static final int MOST = 1_000_000;

        public Checkerboard {
            Require.within("checkerboard columns", columns, 1, MOST);
            Require.within("checkerboard rows", rows, 1, MOST);
        }
    }

    /**
     * Cubes of alternating colour filling space, for any shape. The cubes have the given edge and one has its corner at
     * {@code origin}, in the space of the object that declares the material, before its placement; that one is even.
     */
    record Checker(double size, Vec3 origin, Rgb even, Rgb odd) implements Pattern {
        public Checker {
            Require.size("checker size", size);
            Require.place("checker origin", origin);
        }
    }
}
