package cz.paprsek.teach.grade;

import cz.paprsek.image.Image;
import cz.paprsek.material.Rgb;
import cz.paprsek.teach.PlainTracer;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.Arrays;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** Some pixels of a picture by the numbers, 0–255, that a file has for them: three each, or one if only brightness is known; NaN where nothing is. */
final class Sheet {
    /** So many steps count as half of the worst: an edge that is elsewhere weighs no more than a surface that is too dark. */
    private static final double HALF = 8;
    /** What rounding explains, in steps. */
    private static final double ROUNDING = 1;
    /** Where less than this share of pixels is known on both sheets, nothing can be said. */
    private static final double ENOUGH = 0.2;
    /** Light that is not known. */
    static final double[] UNKNOWN = {};

    private final float[] numbers;
    private final boolean isGrey;

    /** @param numbers pixel by pixel */
    private Sheet(float[] numbers, boolean isGrey) {
        this.numbers = numbers;
        this.isGrey = isGrey;
    }

    /** Of a picture that was read. */
    static Sheet of(Image image, Places places, int[] at, boolean isGrey) {
        return of(IntStream.of(at).mapToObj(i -> new double[] {image.red(places.column(i), places.row(i)), image.green(places.column(i), places.row(i)),
                image.blue(places.column(i), places.row(i))}).toArray(double[][]::new), Mistakes.NONE, isGrey);
    }

    /** Of light. */
    static Sheet of(double[][] light, Mistakes made, boolean isGrey) {
        int channels = isGrey ? 1 : 3;
        float[] numbers = new float[channels * light.length];
        for (int i = 0; i < light.length; i++) {
            if (light[i] == UNKNOWN) {
                Arrays.fill(numbers, channels * i, channels * (i + 1), Float.NaN);
                continue;
            }
            double[] shown = PlainTracer.developed(light[i], made);
            if (isGrey) {
                numbers[i] = number(0.2126 * shown[0] + 0.7152 * shown[1] + 0.0722 * shown[2]);
            } else {
                numbers[3 * i] = number(shown[0]);
                numbers[3 * i + 1] = number(shown[1]);
                numbers[3 * i + 2] = number(shown[2]);
            }
        }
        return new Sheet(numbers, isGrey);
    }

    private static float number(double light) {
        return light > 0 ? (float) Rgb.encoded(Math.min(1, light)) : 0;
    }

    /** How far two sheets are apart, 0–1, in what is known of both; 1 if that is too little. */
    double distance(Sheet other) {
        double[] known = IntStream.range(0, count()).mapToDouble(i -> distance(other, i)).filter(apart -> !Double.isNaN(apart)).toArray();
        return known.length < ENOUGH * count() ? 1 : DoubleStream.of(known).sum() / known.length;
    }

    /** How far they are apart in one of their pixels, 0–1, by its worst channel; NaN if it is not known on both. */
    double distance(Sheet other, int pixel) {
        int channels = isGrey ? 1 : 3;
        double most = 0;
        for (int k = channels * pixel; k < channels * (pixel + 1); k++) {
            most = Math.max(most, Math.abs(numbers[k] - other.numbers[k]) - ROUNDING);
        }
        return most / (most + HALF);
    }

    int count() {
        return numbers.length / (isGrey ? 1 : 3);
    }
}
