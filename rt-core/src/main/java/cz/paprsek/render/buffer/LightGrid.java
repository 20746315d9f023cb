package cz.paprsek.render.buffer;

/** The cells of a light's view: rows of squares or oblongs. Immutable. */
final class LightGrid {
    /** By so much of a cell what is seen is taken to be larger on all sides, for what rounding does. */
    static final double MARGIN = 0.01;
    /** How much of a cell the numbers of a ray may be off by: so little that what touches its start lies in its cell as well. */
    private static final double OFF = 1e-6;
    private static final double ROUNDING = 1e-15;

    final int size;
    final double minU;
    final double minV;
    /** Cells for each unit of u and v. */
    final double perU;
    final double perV;
    /** The {@link cz.paprsek.ray.Hit#size} of hits must be less, whose rays are to be known by their cell. */
    final double farthest;

    /**
     * Over a view.
     *
     * @param size cells in a row, and rows
     * @param nearest nothing seen is less far from the light
     */
    LightGrid(int size, double minU, double minV, double maxU, double maxV, double nearest) {
        double edgeU = (maxU - minU) / size;
        double edgeV = (maxV - minV) / size;
        this.size = size;
        this.minU = minU - edgeU;
        this.minV = minV - edgeV;
        this.perU = size / (maxU - minU + 2 * edgeU);
        this.perV = size / (maxV - minV + 2 * edgeV);
        this.farthest = OFF / ROUNDING * nearest / Math.max(perU, perV);
    }

    /** The first column that reaches as far as u. */
    int firstColumn(double u) {
        return Math.max(0, (int) ((u - minU) * perU - MARGIN));
    }

    int lastColumn(double u) {
        return Math.min(size - 1, (int) ((u - minU) * perU + MARGIN));
    }

    int firstRow(double v) {
        return Math.max(0, (int) ((v - minV) * perV - MARGIN));
    }

    int lastRow(double v) {
        return Math.min(size - 1, (int) ((v - minV) * perV + MARGIN));
    }

    double middleU(int column) {
        return minU + (column + 0.5) / perU;
    }

    double middleV(int row) {
        return minV + (row + 0.5) / perV;
    }

    /** From the middle of a cell to its corners, with the margin. */
    double halfDiagonal() {
        return (0.5 + MARGIN) * Math.sqrt(1 / (perU * perU) + 1 / (perV * perV));
    }
}
