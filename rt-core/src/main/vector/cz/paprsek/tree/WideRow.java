package cz.paprsek.tree;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorSpecies;

/** A row of balls in vectors of doubles: one of eight where the machine has it, else two of four. */
final class WideRow extends Row {
    private static final VectorSpecies<Double> EIGHT = DoubleVector.SPECIES_512;
    private static final VectorSpecies<Double> FOUR = DoubleVector.SPECIES_256;
    private static final boolean HAVE_EIGHT = DoubleVector.SPECIES_PREFERRED.length() >= MOST;

    /** All x, then all y, z and squared radii. */
    private final double[] balls = new double[4 * MOST];

    WideRow(double[] of) {
        for (int i = 0; i < of.length; i++) {
            balls[i % 4 * MOST + i / 4] = of[i];
        }
    }

    /** With both ways in one method, which is too long to be put into another one: there it was 2 to 5 % slower. */
    @Override
    public void ask(double ox, double oy, double oz, double dx, double dy, double dz, double[] halves) {
        double[] b = balls;
        if (HAVE_EIGHT) {
            DoubleVector lx = DoubleVector.fromArray(EIGHT, b, 0).sub(ox);
            DoubleVector ly = DoubleVector.fromArray(EIGHT, b, MOST).sub(oy);
            DoubleVector lz = DoubleVector.fromArray(EIGHT, b, 2 * MOST).sub(oz);
            DoubleVector middle = lx.mul(dx).add(ly.mul(dy)).add(lz.mul(dz));
            DoubleVector px = lx.sub(middle.mul(dx));
            DoubleVector py = ly.sub(middle.mul(dy));
            DoubleVector pz = lz.sub(middle.mul(dz));
            DoubleVector.fromArray(EIGHT, b, 3 * MOST).sub(px.mul(px).add(py.mul(py)).add(pz.mul(pz))).intoArray(halves, 0);
        } else {
            DoubleVector lx = DoubleVector.fromArray(FOUR, b, 0).sub(ox);
            DoubleVector ly = DoubleVector.fromArray(FOUR, b, MOST).sub(oy);
            DoubleVector lz = DoubleVector.fromArray(FOUR, b, 2 * MOST).sub(oz);
            DoubleVector middle = lx.mul(dx).add(ly.mul(dy)).add(lz.mul(dz));
            DoubleVector px = lx.sub(middle.mul(dx));
            DoubleVector py = ly.sub(middle.mul(dy));
            DoubleVector pz = lz.sub(middle.mul(dz));
            DoubleVector.fromArray(FOUR, b, 3 * MOST).sub(px.mul(px).add(py.mul(py)).add(pz.mul(pz))).intoArray(halves, 0);
            lx = DoubleVector.fromArray(FOUR, b, MOST / 2).sub(ox);
            ly = DoubleVector.fromArray(FOUR, b, MOST + MOST / 2).sub(oy);
            lz = DoubleVector.fromArray(FOUR, b, 2 * MOST + MOST / 2).sub(oz);
            middle = lx.mul(dx).add(ly.mul(dy)).add(lz.mul(dz));
            px = lx.sub(middle.mul(dx));
            py = ly.sub(middle.mul(dy));
            pz = lz.sub(middle.mul(dz));
            DoubleVector.fromArray(FOUR, b, 3 * MOST + MOST / 2).sub(px.mul(px).add(py.mul(py)).add(pz.mul(pz))).intoArray(halves, MOST / 2);
        }
    }
}
