package cz.paprsek.format.off;

/** Finds out what white is in a file, 1 or 255, from all the numbers of colours in it. */
final class Scale {
    private boolean isReal;
    private boolean isAboveOne;

    /** Looks at the numbers of a colour, also that of its opacity, and at whether they have points or exponents. */
    void see(double[] row, boolean[] areReal, int from, int count) {
        for (int i = from; i < from + count; i++) {
            isReal |= areReal[i];
            isAboveOne |= row[i] > 1;
        }
    }

    /** Whether there was anything but whole numbers up to 1, which may be of both kinds. */
    boolean isTold() {
        return isReal || isAboveOne;
    }

    /** What a channel is multiplied with, so that white is 255. */
    double white() {
        return isReal || !isAboveOne ? 255 : 1;
    }
}
