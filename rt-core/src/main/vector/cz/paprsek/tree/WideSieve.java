package cz.paprsek.tree;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorShuffle;
import jdk.incubator.vector.VectorSpecies;

/** In vectors of four doubles, of which three are the corners of a triangle: the same numbers as those made one by one. */
final class WideSieve extends Sieve {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_128;
    private static final VectorSpecies<Double> DOUBLES = DoubleVector.SPECIES_256;
    private static final VectorShuffle<Double> NEXT = VectorShuffle.fromValues(DOUBLES, 1, 2, 0, 3);

    @Override
    public int next(float[] triangles, int first, int last, int ofX, int ofY, int ofZ, double px, double py, double pz, double sx, double sy) {
        for (int i = first; i < last; i++) {
            int at = EACH * i;
            DoubleVector z = ((DoubleVector) FloatVector.fromArray(FLOATS, triangles, at + ofZ).convertShape(VectorOperators.F2D, DOUBLES, 0)).sub(pz);
            DoubleVector x = ((DoubleVector) FloatVector.fromArray(FLOATS, triangles, at + ofX).convertShape(VectorOperators.F2D, DOUBLES, 0)).sub(px).sub(z.mul(sx));
            DoubleVector y = ((DoubleVector) FloatVector.fromArray(FLOATS, triangles, at + ofY).convertShape(VectorOperators.F2D, DOUBLES, 0)).sub(py).sub(z.mul(sy));
            DoubleVector sides = x.mul(y.rearrange(NEXT)).sub(y.mul(x.rearrange(NEXT)));
            // Of three numbers two that follow each other, the first behind the last, have different signs; what is in the fourth place has that of itself.
            if (!sides.mul(sides.rearrange(NEXT)).compare(VectorOperators.LT, 0).anyTrue()) {
                return i;
            }
        }
        return last;
    }
}
