package cz.paprsek.render.sample;

/** Scratch of one worker: of points of the unit square, the directions of light that a matt surface strews, with its normal for z. */
final class PassTurns {
    final double[] x;
    final double[] y;
    final double[] z;
    private final double[] shares;
    private final double[] sines;

    PassTurns(int most) {
        x = new double[most];
        y = new double[most];
        z = new double[most];
        shares = new double[most];
        sines = new double[most];
    }

    /**
     * Makes the directions.
     *
     * @param us digits of the points
     * @param width how many of each row there are
     * @param row how long a row is
     */
    void fill(int[] us, int[] vs, int width, int row, int rows) {
        int count = 0;
        for (int i = 0; i < rows; i++) {
            for (int k = i * row; k < i * row + width; k++) {
                z[count] = Sampler.unit(us[k]);
                shares[count++] = Sampler.unit(vs[k]);
            }
        }
        split(count, z, sines);
        Turn.by(count, shares, sines, x, y);
    }

    private static void split(int count, double[] squares, double[] sines) {
        for (int i = 0; i < count; i++) {
            sines[i] = Math.sqrt(squares[i]);
            squares[i] = Math.sqrt(1 - squares[i]);
        }
    }
}
