package cz.paprsek.render.texture;

import cz.paprsek.image.Image;
import cz.paprsek.image.StoredImage;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.material.Rgb;
import cz.paprsek.ray.Hit;
import org.jspecify.annotations.Nullable;

/**
 * A picture that is looked up by u, which grows to the right, and v, which grows upwards; both are 0–1 within the picture, which repeats beyond.
 * Besides itself it has the same picture in half the size, a quarter, and so on, for looking at it from a distance.
 */
public final class Texture {
    /** How many places along the longer axis of a footprint are looked at. Of longer ones, the mean is taken over more. */
    private static final int MOST_PROBES = 32;
    /** Beyond, where a picture repeats is anybody's guess. */
    private static final double FARTHEST = 1e9;

    private final Raster[] rasters;
    private @Nullable Brightness brightness;

    private Texture(Raster[] rasters) {
        this.rasters = rasters;
    }

    /** @param isLight whether samples mean light, rather than numbers, which are 0–1 as they stand in the file */
    public static Texture of(StoredImage picture, boolean isLight) {
        Image image = picture.image();
        Raster[] rasters = new Raster[Integer.SIZE - Integer.numberOfLeadingZeros(Math.max(image.width(), image.height()))];
        rasters[0] = new Raster(image, !isLight && isEncoded(picture));
        for (int i = 1; i < rasters.length; i++) {
            rasters[i] = rasters[i - 1].halved();
        }
        return new Texture(rasters);
    }

    private static boolean isEncoded(StoredImage picture) {
        return picture.precision() == Precision.EIGHT_BIT || picture.precision() == Precision.SIXTEEN_BIT;
    }

    /** Where it is bright, if it is one of everything around; found out when it is first asked for. */
    public synchronized Brightness brightness() {
        Brightness known = brightness;
        if (known == null) {
            known = Brightness.of(this);
            brightness = known;
        }
        return known;
    }

    public int width() {
        return rasters[0].width;
    }

    public int height() {
        return rasters[0].height;
    }

    /** The column of the picture's point that is nearest. */
    public int column(double u) {
        return rasters[0].column((int) Math.floor(within(u) * width()));
    }

    /** The row from the top of the picture's point that is nearest. */
    public int row(double v) {
        return height() - 1 - (int) Math.floor(within(v) * height());
    }

    /** Sets the hit's colour to that of the nearest point of the picture. */
    public void nearest(double u, double v, Hit out) {
        out.color(0, 0, 0);
        rasters[0].add(column(u), row(v), 1, out);
    }

    /** Sets the hit's colour, mixed linearly of the four nearest points: each lies in the middle of its square. */
    public void bilinear(double u, double v, Hit out) {
        out.color(0, 0, 0);
        rasters[0].addMixed(within(u), within(v), 1, out);
    }

    /**
     * Sets the hit's colour to the mean over a footprint: a parallelogram about (u, v), which is taken for the ellipse of the same axes. Along the
     * longer of these, means as wide as the shorter one are added up, so that what is seen at a grazing angle is not blurred across.
     *
     * @param uX how much u grows along one side of the footprint, and so on
     * @source McCormack, Perry, Farkas, Jouppi, Feline: Fast Elliptical Lines for Anisotropic Texture Mapping, SIGGRAPH 1999
     */
    public void smooth(double u, double v, double uX, double vX, double uY, double vY, Hit out) {
        double ax = uX * width();
        double ay = vX * height();
        double bx = uY * width();
        double by = vY * height();
        // The axes of the ellipse are the roots of the eigenvalues of the sum of both sides' products with themselves.
        double xx = ax * ax + bx * bx;
        double xy = ax * ay + bx * by;
        double yy = ay * ay + by * by;
        double half = (xx - yy) / 2;
        double root = Math.sqrt(half * half + xy * xy);
        double major = Math.sqrt((xx + yy) / 2 + root);
        if (!(major > 1 && major < FARTHEST)) {
            if (major <= 1) {
                bilinear(u, v, out);
            } else {
                out.color(0, 0, 0);
                rasters[rasters.length - 1].add(0, 0, 1, out);
            }
            return;
        }
        double minor = Math.max(Math.sqrt(Math.max(0, (xx + yy) / 2 - root)), Math.max(1, major / MOST_PROBES));
        double dirX = half + root;
        double dirY = xy;
        if (half < 0) {
            dirX = xy;
            dirY = root - half;
        }
        double length = Math.sqrt(dirX * dirX + dirY * dirY);
        double alongU = length > 0 ? dirX / length * major / width() : 0;
        double alongV = length > 0 ? dirY / length * major / height() : 0;
        int probes = (int) Math.ceil(major / minor - 1e-9);
        // log₂ of the width, linear between powers of 2: no other function is the same everywhere, and as fast.
        int level = Math.getExponent(minor);
        double share = minor / Math.scalb(1.0, level) - 1;
        out.color(0, 0, 0);
        for (int i = 0; i < probes; i++) {
            double at = (i + 0.5) / probes - 0.5;
            double atU = within(u + at * alongU);
            double atV = within(v + at * alongV);
            rasters[Math.min(level, rasters.length - 1)].addMixed(atU, atV, (1 - share) / probes, out);
            rasters[Math.min(level + 1, rasters.length - 1)].addMixed(atU, atV, share / probes, out);
        }
    }

    /** The place within the picture; 0 for what is no place at all. */
    private static double within(double place) {
        double within = place - Math.floor(place);
        return within < 1 ? within : 0;
    }

    /** The picture in one of its sizes. */
    private static final class Raster {
        private static final float[] LIGHT = table(true);
        private static final float[] NUMBERS = table(false);

        private final Image image;
        private final int width;
        private final int height;
        /** What eight bits stand for, if the image is made of those. */
        private final float[] table;
        /** Whether the image holds light, but numbers are asked for. */
        private final boolean isToEncode;

        Raster(Image image, boolean isToEncode) {
            this.image = image;
            this.isToEncode = isToEncode && !image.isEightBit();
            width = image.width();
            height = image.height();
            table = !image.isEightBit() ? new float[0] : isToEncode ? NUMBERS : LIGHT;
        }

        private static float[] table(boolean isLight) {
            float[] table = new float[256];
            for (int i = 0; i < table.length; i++) {
                table[i] = isLight ? (float) Rgb.linear(i) : i / 255f;
            }
            return table;
        }

        int column(int column) {
            return Math.floorMod(column, width);
        }

        int row(int row) {
            return Math.floorMod(row, height);
        }

        void add(int x, int y, double weight, Hit out) {
            if (table.length > 0) {
                int encoded = image.argb(x, y);
                out.color(out.red + weight * table[encoded >> 16 & 0xFF], out.green + weight * table[encoded >> 8 & 0xFF], out.blue + weight * table[encoded & 0xFF]);
            } else if (isToEncode) {
                out.color(out.red + weight * Rgb.encoded(image.red(x, y)) / 255, out.green + weight * Rgb.encoded(image.green(x, y)) / 255,
                        out.blue + weight * Rgb.encoded(image.blue(x, y)) / 255);
            } else {
                out.color(out.red + weight * image.red(x, y), out.green + weight * image.green(x, y), out.blue + weight * image.blue(x, y));
            }
        }

        /** Adds the mixture of the four nearest points. */
        void addMixed(double u, double v, double weight, Hit out) {
            double x = u * width - 0.5;
            double y = (1 - v) * height - 0.5;
            int left = (int) Math.floor(x);
            int top = (int) Math.floor(y);
            double right = x - left;
            double down = y - top;
            int column = column(left);
            int next = column(left + 1);
            int row = row(top);
            int below = row(top + 1);
            add(column, row, weight * (1 - right) * (1 - down), out);
            add(next, row, weight * right * (1 - down), out);
            add(column, below, weight * (1 - right) * down, out);
            add(next, below, weight * right * down, out);
        }

        /** The same in half the size: each point the mean of those it stands for, four of them, or as many as lie at an odd edge. */
        Raster halved() {
            int columns = Math.max(1, width / 2);
            int rows = Math.max(1, height / 2);
            // Means of numbers are kept as light would be, with the same steps: whoever asks for them knows.
            Image half = image.isEightBit() && !isNumbers() ? Image.ofEightBit(columns, rows) : new Image(columns, rows);
            Hit sum = new Hit();
            for (int y = 0; y < rows; y++) {
                int bottom = y == rows - 1 ? height : 2 * y + 2;
                for (int x = 0; x < columns; x++) {
                    int end = x == columns - 1 ? width : 2 * x + 2;
                    sum.color(0, 0, 0);
                    double weight = 1.0 / ((bottom - 2 * y) * (end - 2 * x));
                    for (int row = 2 * y; row < bottom; row++) {
                        for (int column = 2 * x; column < end; column++) {
                            add(column, row, weight, sum);
                        }
                    }
                    half.set(x, y, sum.red, sum.green, sum.blue);
                }
            }
            return new Raster(half, false);
        }

        private boolean isNumbers() {
            return table == NUMBERS;
        }
    }
}
