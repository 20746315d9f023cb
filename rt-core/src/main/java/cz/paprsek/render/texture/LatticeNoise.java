package cz.paprsek.render.texture;

/**
 * Gradient noise without tables: at the points of a lattice of unit cubes, which repeats every 289, it is 0 and rises along one of twelve
 * directions, which a permutation P(a) = (34a + 1)·a mod 289 of whole numbers chooses. It lies within about ±1. Every octave, of half the size
 * and half the strength, and every seed is another part of it.
 *
 * @source Perlin, Improving Noise, SIGGRAPH 2002; McEwan, Sheets, Gustavson, Richardson, Efficient Computational Noise in GLSL, 2012
 */
public final class LatticeNoise {
    /** How often the lattice repeats itself: the numbers that P permutes. */
    public static final int PERIOD = 289;
    /** Beyond, numbers are all whole. */
    private static final double LARGEST = 0x1p52;

    private final int octaves;
    /** How far into the lattice each octave lies, along x, y and z. */
    private final int[] shifts;

    public LatticeNoise(int octaves, int seed) {
        this.octaves = octaves;
        shifts = new int[3 * octaves];
        for (int i = 0; i < shifts.length; i++) {
            shifts[i] = Math.floorMod(mixed(seed * 64 + i), PERIOD);
        }
    }

    /**
     * How far into the lattice an octave lies.
     *
     * @param axis 0 for x, 1 for y, 2 for z
     */
    public int shift(int octave, int axis) {
        return shifts[3 * octave + axis];
    }

    /** Σ noise(2ⁱp)/2ⁱ. */
    public double sum(double x, double y, double z) {
        double sum = 0;
        double size = 1;
        for (int i = 0; i < octaves; i++) {
            sum += noise(x / size, y / size, z / size, i) * size;
            size /= 2;
        }
        return sum;
    }

    /** Σ |noise(2ⁱp)|/2ⁱ. */
    public double sumOfSizes(double x, double y, double z) {
        double sum = 0;
        double size = 1;
        for (int i = 0; i < octaves; i++) {
            sum += Math.abs(noise(x / size, y / size, z / size, i)) * size;
            size /= 2;
        }
        return sum;
    }

    /** Sets the three numbers to how much {@link #sum} grows along x, y and z. */
    public void slope(double x, double y, double z, double[] out) {
        slope(x, y, z, false, out);
    }

    /** Sets the three numbers to how much {@link #sumOfSizes} grows along x, y and z. */
    public void slopeOfSizes(double x, double y, double z, double[] out) {
        slope(x, y, z, true, out);
    }

    private void slope(double x, double y, double z, boolean ofSizes, double[] out) {
        out[0] = 0;
        out[1] = 0;
        out[2] = 0;
        double factor = 1;
        for (int i = 0; i < octaves; i++) {
            double px = x * factor;
            double py = y * factor;
            double pz = z * factor;
            if (Math.abs(px) < LARGEST && Math.abs(py) < LARGEST && Math.abs(pz) < LARGEST) {
                addSlope(px, py, pz, i, ofSizes && noise(px, py, pz, i) < 0 ? -1 : 1, out);
            }
            factor *= 2;
        }
    }

    /** Adds the derivative of the noise: of the rise from each corner of the cube times its weight there, by the rule of products. */
    private void addSlope(double x, double y, double z, int octave, double sign, double[] out) {
        double floorX = Math.floor(x);
        double floorY = Math.floor(y);
        double floorZ = Math.floor(z);
        int j = wrapped(floorY) + shifts[3 * octave + 1];
        int k = wrapped(floorZ) + shifts[3 * octave + 2];
        for (int corner = 0; corner < 8; corner++) {
            int cx = corner & 1;
            int cy = corner >> 1 & 1;
            int cz = corner >> 2;
            int i = permuted(wrapped(floorX) + shifts[3 * octave] + cx);
            double fx = x - floorX - cx;
            double fy = y - floorY - cy;
            double fz = z - floorZ - cz;
            double weightX = cx == 0 ? 1 - fade(fx) : fade(fx + 1);
            double weightY = cy == 0 ? 1 - fade(fy) : fade(fy + 1);
            double weightZ = cz == 0 ? 1 - fade(fz) : fade(fz + 1);
            double rise = slope(i, j + cy, k + cz, fx, fy, fz);
            double weight = sign * weightX * weightY * weightZ;
            out[0] += weight * slope(i, j + cy, k + cz, 1, 0, 0) + sign * rise * fadeSlope(fx + cx, cx) * weightY * weightZ;
            out[1] += weight * slope(i, j + cy, k + cz, 0, 1, 0) + sign * rise * fadeSlope(fy + cy, cy) * weightX * weightZ;
            out[2] += weight * slope(i, j + cy, k + cz, 0, 0, 1) + sign * rise * fadeSlope(fz + cz, cz) * weightX * weightY;
        }
    }

    /** How fast the weight of the lower corner, 0, falls, or that of the upper one, 1, rises. */
    private static double fadeSlope(double t, int corner) {
        double steep = 30 * t * t * (t - 1) * (t - 1);
        return corner == 0 ? -steep : steep;
    }

    private double noise(double x, double y, double z, int octave) {
        // Not NaN either.
        if (!(Math.abs(x) < LARGEST && Math.abs(y) < LARGEST && Math.abs(z) < LARGEST)) {
            return 0;
        }
        double floorX = Math.floor(x);
        double floorY = Math.floor(y);
        double floorZ = Math.floor(z);
        double fx = x - floorX;
        double fy = y - floorY;
        double fz = z - floorZ;
        int j = wrapped(floorY) + shifts[3 * octave + 1];
        int k = wrapped(floorZ) + shifts[3 * octave + 2];
        int left = permuted(wrapped(floorX) + shifts[3 * octave]);
        int right = permuted(wrapped(floorX) + shifts[3 * octave] + 1);
        double u = fade(fx);
        double v = fade(fy);
        double w = fade(fz);
        return mix(w,
                mix(v, mix(u, slope(left, j, k, fx, fy, fz), slope(right, j, k, fx - 1, fy, fz)),
                        mix(u, slope(left, j + 1, k, fx, fy - 1, fz), slope(right, j + 1, k, fx - 1, fy - 1, fz))),
                mix(v, mix(u, slope(left, j, k + 1, fx, fy, fz - 1), slope(right, j, k + 1, fx - 1, fy, fz - 1)),
                        mix(u, slope(left, j + 1, k + 1, fx, fy - 1, fz - 1), slope(right, j + 1, k + 1, fx - 1, fy - 1, fz - 1))));
    }

    /** How high the rise from one lattice point is at a place, which is given as seen from there. */
    private static double slope(int i, int j, int k, double x, double y, double z) {
        int direction = permuted(permuted(i + j) + k) % 12;
        double first = direction < 8 ? x : y;
        double second = direction < 4 ? y : z;
        return ((direction & 1) == 0 ? first : -first) + ((direction & 2) == 0 ? second : -second);
    }

    private static int wrapped(double whole) {
        return (int) (whole - PERIOD * Math.floor(whole / PERIOD));
    }

    private static int permuted(int a) {
        return (34 * a + 1) * a % PERIOD;
    }

    private static double fade(double t) {
        return t * t * t * (t * (t * 6 - 15) + 10);
    }

    private static double mix(double share, double a, double b) {
        return a + share * (b - a);
    }

    /**
     * Spreads the bits of a number.
     *
     * @source Appleby, MurmurHash3, fmix32
     */
    private static int mixed(int number) {
        int h = number;
        h = (h ^ (h >>> 16)) * 0x85EBCA6B;
        h = (h ^ (h >>> 13)) * 0xC2B2AE35;
        return h ^ (h >>> 16);
    }
}
