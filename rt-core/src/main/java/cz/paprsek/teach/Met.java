package cz.paprsek.teach;

/** A body, and where it is crossed. */
record Met(Body body, Crossing crossing) {
    double t() {
        return crossing.t();
    }

    int number() {
        return crossing.of().number;
    }
}
