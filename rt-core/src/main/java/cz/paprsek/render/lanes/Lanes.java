package cz.paprsek.render.lanes;

/** What is done with numbers side by side. */
public final class Lanes {
    private Lanes() {}

    /** Multiplies the first so many by others, which may be themselves. */
    public static void multiply(double[] numbers, double[] by, int count) {
        for (int i = 0; i < count; i++) {
            numbers[i] *= by[i];
        }
    }
}
