package cz.paprsek.render.account;

import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.Pixel.PathPixel.Source;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What one class of a pixel's paths brings, by the sequence that each is of. */
final class Tally {
    /** A class: where light comes from, and the numbers of the objects from there to the eye. */
    record Key(Source source, int number, List<Integer> objects, boolean isShortened) {}

    /** So many of its paths are remembered, among which a typical one is found. */
    private static final int MOST_REMEMBERED = 256;
    private static final int CHANNELS = 3;

    final Key key;
    /** Light that the filter adds and light that it takes away, of each sequence three channels. */
    private final double[] added;
    private final double[] taken;
    private final List<Remembered> remembered = new ArrayList<>();
    private int paths;
    private int last = -1;

    private record Remembered(int sample, LinearRgb light) {}

    Tally(Key key, int sequences) {
        this.key = key;
        added = new double[CHANNELS * sequences];
        taken = new double[CHANNELS * sequences];
    }

    /** A path brings light this way; it may do so several times. */
    void add(int sample, int sequence, boolean isNegative, double red, double green, double blue) {
        double[] to = isNegative ? taken : added;
        to[CHANNELS * sequence] += red;
        to[CHANNELS * sequence + 1] += green;
        to[CHANNELS * sequence + 2] += blue;
        LinearRgb light = new LinearRgb(red, green, blue);
        if (sample != last) {
            paths++;
            last = sample;
            if (remembered.size() < MOST_REMEMBERED) {
                remembered.add(new Remembered(sample, light));
            }
        } else if (remembered.get(remembered.size() - 1).sample == sample) {
            remembered.set(remembered.size() - 1, new Remembered(sample, remembered.get(remembered.size() - 1).light.plus(light)));
        }
    }

    int paths() {
        return paths;
    }

    /**
     * What the pixel gets.
     *
     * @param weight of each sample that the filter adds, in the pixel
     * @param negativeWeight of each that it takes away
     */
    LinearRgb light(double weight, double negativeWeight) {
        LinearRgb sum = LinearRgb.BLACK;
        for (int i = 0; i < added.length / CHANNELS; i++) {
            sum = sum.plus(ofSequence(i, weight, negativeWeight));
        }
        return sum;
    }

    private LinearRgb ofSequence(int sequence, double weight, double negativeWeight) {
        int at = CHANNELS * sequence;
        return new LinearRgb(added[at] * weight + taken[at] * negativeWeight, added[at + 1] * weight + taken[at + 1] * negativeWeight,
                added[at + 2] * weight + taken[at + 2] * negativeWeight);
    }

    /**
     * How far that may be from the truth.
     *
     * @param t what Student's t is within with the confidence that is asked for
     */
    LinearRgb halfWidth(double weight, double negativeWeight, double t) {
        int sequences = added.length / CHANNELS;
        LinearRgb mean = light(weight, negativeWeight).times(1.0 / sequences);
        double red = 0;
        double green = 0;
        double blue = 0;
        for (int i = 0; i < sequences; i++) {
            LinearRgb one = ofSequence(i, weight, negativeWeight);
            red += (one.red() - mean.red()) * (one.red() - mean.red());
            green += (one.green() - mean.green()) * (one.green() - mean.green());
            blue += (one.blue() - mean.blue()) * (one.blue() - mean.blue());
        }
        // The pixel has the sum of the sequences: its deviation is that of one of them times the root of their number.
        double k = (double) sequences / (sequences - 1);
        return new LinearRgb(t * Math.sqrt(k * red), t * Math.sqrt(k * green), t * Math.sqrt(k * blue));
    }

    /** Of the paths that are remembered, that whose light is nearest to the mean of all. */
    int typical() {
        double share = 1.0 / paths;
        LinearRgb mean = light(share, share);
        int best = 0;
        for (int i = 1; i < remembered.size(); i++) {
            best = remembered.get(i).light.distance(mean) < remembered.get(best).light.distance(mean) ? i : best;
        }
        return remembered.get(best).sample;
    }

    /** What a path that is remembered brings this way. */
    Optional<LinearRgb> brought(int sample) {
        return remembered.stream().filter(one -> one.sample == sample).findFirst().map(one -> one.light);
    }
}
