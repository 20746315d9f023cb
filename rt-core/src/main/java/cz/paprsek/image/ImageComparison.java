package cz.paprsek.image;

import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.math.Require;
import java.util.Objects;

/**
 * How far two pictures of one size are apart, channel by channel, in steps of the coarser of the two.
 *
 * @param unit what a step is
 * @param isGrey whether brightness alone was compared, because one of the pictures has no more
 * @param tolerance how many steps are allowed
 * @param largest the largest difference, in steps; infinite where a value is not a number
 * @param x column of the pixel with the largest difference
 * @param y its row
 * @param mean the mean difference of channels, in steps
 * @param rootMeanSquare the root of the mean squared difference of channels, in steps
 * @param beyond how many pixels have a channel that differs by more than the tolerance
 * @param pixels how many pixels there are
 */
public record ImageComparison(Unit unit, boolean isGrey, double tolerance, double largest, int x, int y, double mean, double rootMeanSquare,
        long beyond, long pixels) {
    public ImageComparison {
        Objects.requireNonNull(unit, "unit");
    }


    /** What differences are counted in. */
    public enum Unit {
        /** Steps of 8-bit sRGB; both pictures are encoded and rounded. */
        SRGB("1/255 of sRGB", 1),
        /** Of linear light, 256ths of the brightest channel of the pixel, or if that is more, 65535ths. */
        SHARED("1/256 of the pixel's brightest channel", 2),
        /** Of linear light, 2048ths of the channel, or if that is more, 65535ths. */
        HALF("1/2048 of linear light", 1),
        /** 65535ths of linear light, both pictures clamped to 0–1. */
        LINEAR("1/65535 of linear light", 2),
        /** 65535ths of linear light, not clamped. */
        UNCLAMPED("1/65535 of linear light", 2);

        private final String description;
        private final double usualTolerance;

        Unit(String description, double usualTolerance) {
            this.description = description;
            this.usualTolerance = usualTolerance;
        }

        /** The unit for two pictures: that of the less precise. */
        public static Unit of(StoredImage a, StoredImage b) {
            Precision coarser = a.precision().compareTo(b.precision()) < 0 ? a.precision() : b.precision();
            return switch (coarser) {
                case EIGHT_BIT -> SRGB;
                case SHARED_EXPONENT -> SHARED;
                case HALF -> HALF;
                case SIXTEEN_BIT -> LINEAR;
                case FLOAT -> UNCLAMPED;
            };
        }

        /** For people: what a step is. */
        public String description() {
            return description;
        }

        /** How many steps rounding alone explains. */
        public double usualTolerance() {
            return usualTolerance;
        }

        private double steps(double light) {
            return switch (this) {
                case SRGB -> Srgb.encode((float) light);
                // Not Math.min and max: a value that is not a number must stay one.
                case LINEAR -> (light < 0 ? 0 : light > 1 ? 1 : light) * 65_535;
                case UNCLAMPED, SHARED, HALF -> light * 65_535;
            };
        }
    }

    /**
     * Compares two pictures.
     *
     * @param tolerance in steps of the {@linkplain Unit#of unit} for both
     * @throws IllegalArgumentException if they differ in size
     */
    public static ImageComparison of(StoredImage a, StoredImage b, double tolerance) {
        Unit unit = Unit.of(a, b);
        boolean isGrey = a.isGrey() || b.isGrey();
        Image first = a.image();
        Image second = b.image();
        requireSameSize(first, second);
        double largest = -1;
        int column = 0;
        int row = 0;
        long beyond = 0;
        double sum = 0;
        double squares = 0;
        for (int y = 0; y < first.height(); y++) {
            for (int x = 0; x < first.width(); x++) {
                double most = 0;
                for (int channel = 0; channel < (isGrey ? 1 : 3); channel++) {
                    double difference = difference(unit, first, second, x, y, channel, isGrey);
                    sum += difference;
                    squares += difference * difference;
                    most = Math.max(most, difference);
                }
                beyond += most <= tolerance ? 0 : 1;
                if (most > largest) {
                    largest = most;
                    column = x;
                    row = y;
                }
            }
        }
        long pixels = (long) first.width() * first.height();
        double values = pixels * (isGrey ? 1.0 : 3.0);
        return new ImageComparison(unit, isGrey, tolerance, largest, column, row, sum / values, Math.sqrt(squares / values), beyond, pixels);
    }

    /** The share of pixels that differ by more than the tolerance, 0–1. */
    public double shareBeyond() {
        return beyond / (double) pixels;
    }

    /**
     * A picture of the differences: black where there are none, blue within the tolerance, from red through yellow to white the farther
     * beyond it, white at the 1024-fold.
     */
    public static Image heatmap(StoredImage a, StoredImage b, double tolerance) {
        Unit unit = Unit.of(a, b);
        boolean isGrey = a.isGrey() || b.isGrey();
        Image first = a.image();
        requireSameSize(first, b.image());
        Image map = new Image(first.width(), first.height());
        for (int y = 0; y < first.height(); y++) {
            for (int x = 0; x < first.width(); x++) {
                double most = 0;
                for (int channel = 0; channel < 3; channel++) {
                    most = Math.max(most, difference(unit, first, b.image(), x, y, channel, isGrey));
                }
                if (most > tolerance) {
                    double heat = Math.min(1, StrictMath.log(most / Math.max(tolerance, 1)) / StrictMath.log(1024));
                    map.set(x, y, 1, Math.max(0, 2 * heat - 0.2) / 1.8, Math.max(0, 2 * heat - 1));
                } else if (most > 0) {
                    map.set(x, y, 0, 0.02, 0.1 + 0.4 * most / tolerance);
                }
            }
        }
        return map;
    }

    private static void requireSameSize(Image a, Image b) {
        Require.that(a.width() == b.width() && a.height() == b.height(),
                "the pictures differ in size: " + a.width() + "x" + a.height() + " and " + b.width() + "x" + b.height());
    }

    private static double difference(Unit unit, Image first, Image second, int x, int y, int channel, boolean isGrey) {
        double a = value(first, x, y, channel, isGrey);
        double b = value(second, x, y, channel, isGrey);
        double difference = Math.abs(unit.steps(a) - unit.steps(b)) / switch (unit) {
            case SRGB, LINEAR, UNCLAMPED -> 1;
            case HALF -> Math.max(1, Math.max(Math.abs(a), Math.abs(b)) * 65_535 / 2048);
            case SHARED -> Math.max(1, Math.max(brightest(first, x, y), brightest(second, x, y)) * 65_535 / 256);
        };
        return Double.isNaN(difference) ? Double.POSITIVE_INFINITY : difference;
    }

    private static double brightest(Image image, int x, int y) {
        return Math.max(image.red(x, y), Math.max(image.green(x, y), image.blue(x, y)));
    }

    private static double value(Image image, int x, int y, int channel, boolean isGrey) {
        if (isGrey) {
            return Brightness.luminance(image, x, y);
        }
        return channel == 0 ? image.red(x, y) : channel == 1 ? image.green(x, y) : image.blue(x, y);
    }
}
