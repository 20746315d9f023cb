package cz.paprsek.tree;

/** Passes by triangles that a line clearly misses, where this machine tells that of all sides of one at once. Immutable. */
public abstract class Sieve {
    /** How many numbers a triangle takes: x of its corners, then y, z, and one that is not asked. */
    public static final int EACH = 10;
    /** So many numbers more are read behind the last triangle. */
    public static final int BEHIND = 2;

    private static final Sieve COARSE = new Coarse();

    Sieve() {}

    /**
     * The one that suits a tree over triangles.
     *
     * @param cost what it takes to meet one, in units of what a sphere takes
     */
    public static Sieve suitedTo(int triangles, double cost) {
        return Kernel.suitedTo(triangles, triangles * cost).sieve().orElse(COARSE);
    }

    /**
     * The first triangle of some in a row that the line may cross: no two sides clearly have the line on different sides. Space is sheared so that the line becomes the z axis.
     *
     * @param first the number of the first of them
     * @param last the number behind the last of them, which is returned if there is none
     * @param ofX where the coordinates that become x begin among the numbers of a triangle: 0, 3 or 6
     * @param px where the line begins
     * @param sx how much the line goes on along x while it goes on by 1 along z
     */
    public abstract int next(float[] triangles, int first, int last, int ofX, int ofY, int ofZ, double px, double py, double pz, double sx, double sy);

    /** Passes by none. */
    private static final class Coarse extends Sieve {
        @Override
        public int next(float[] triangles, int first, int last, int ofX, int ofY, int ofZ, double px, double py, double pz, double sx, double sy) {
            return first;
        }
    }
}
