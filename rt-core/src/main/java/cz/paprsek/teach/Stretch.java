package cz.paprsek.teach;

/** A stretch of a line, and the faces at its ends. */
record Stretch(double enter, int enterFace, double leave, int leaveFace) {
    static final Stretch NONE = new Stretch(Double.POSITIVE_INFINITY, 0, Double.NEGATIVE_INFINITY, 0);
    static final Stretch ALL = new Stretch(Double.NEGATIVE_INFINITY, 0, Double.POSITIVE_INFINITY, 0);

    boolean isEmpty() {
        return !(enter < leave);
    }

    /** What it has in common with another one. */
    Stretch within(double from, int fromFace, double to, int toFace) {
        return new Stretch(from > enter ? from : enter, from > enter ? fromFace : enterFace, to < leave ? to : leave, to < leave ? toFace : leaveFace);
    }

    /** The part where low ≤ o + t·d ≤ high along one axis; the face at high has the number after that at low. */
    Stretch between(double o, double d, double low, double high, int lowFace) {
        double r = 1 / d;
        if (Double.isInfinite(r)) {
            return o >= low && o <= high ? this : NONE;
        }
        double atLow = (low - o) * r;
        double atHigh = (high - o) * r;
        return d > 0 ? within(atLow, lowFace, atHigh, lowFace + 1) : within(atHigh, lowFace + 1, atLow, lowFace);
    }
}
