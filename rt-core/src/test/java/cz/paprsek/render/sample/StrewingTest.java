package cz.paprsek.render.sample;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Pixel filters and what pixels come to, against closed forms. */
class StrewingTest {
    private static final int MANY = 1 << 20;

    /**
     * The filter's area is 1, its centre the pixel's, and ∫x²f is that of the filter: 1/12 of the box, 1/6 of the tent, of the bell curve cut off
     * at 4σ σ²(1 − 8φ(4)/(2Φ(4) − 1)), of Mitchell's with B = C = ⅓ by its polynomials 1/9 … whose first derivative at the end is 0.
     */
    @ParameterizedTest
    @CsvSource({"BOX, 0.083333333", "TENT, 0.166666667", "GAUSS, 0.249732332", "MITCHELL, 0.111111111"})
    void momentsAreThoseOfTheFilter(PixelFilter filter, double square) {
        Strewing strewing = Strewing.of(filter);
        double sign = 0;
        double first = 0;
        double second = 0;
        for (int i = 0; i < MANY; i++) {
            double x = strewing.place((i + 0.5) / MANY);
            double weight = strewing.isNegative(x) ? -1 : 1;
            sign += weight;
            first += weight * (x - 0.5);
            second += weight * (x - 0.5) * (x - 0.5);
            assertThat(x).isBetween(-(double) strewing.reach(), 1.0 + strewing.reach());
        }
        assertThat(sign / MANY * strewing.mass()).isCloseTo(1, within(1e-4));
        assertThat(first / MANY).isCloseTo(0, within(1e-9));
        assertThat(second / MANY * strewing.mass()).isCloseTo(square, within(1e-4));
    }

    @ParameterizedTest
    @EnumSource(PixelFilter.class)
    void anEvenBrightnessStaysWhatItIs(PixelFilter filter) {
        for (int samples : new int[] {1, 2, 3, 4, 7, 16}) {
            Sampling sampling = Sampling.of(RenderSettings.DEFAULT.withSamples(samples, samples).withFilter(filter), false);
            for (int pixel = 0; pixel < 100; pixel++) {
                PixelSums sums = summed(sampling, pixel, pixel % 7, (x, y) -> 0.7);
                assertThat((float) sums.red).isEqualTo(0.7f);
            }
        }
    }

    private interface Scene {
        double light(double x, double y);
    }

    private static PixelSums summed(Sampling sampling, int column, int row, Scene scene) {
        PixelSums sums = sampling.newSums();
        Sampler sampler = sampling.newSampler();
        Place place = new Place();
        for (int more = sampling.rays(); more > 0; more = sampling.further(sums)) {
            for (int i = 0; i < more; i++) {
                sampling.place(sampler, column, row, sums.count(), place);
                double light = scene.light(place.x, place.y);
                sums.add(light, light, light, place.isNegative);
            }
        }
        sums.mean();
        return sums;
    }

    /** Of what is a straight slope in a pixel, the filter shows the middle; of a parabola the middle and its moment. */
    @ParameterizedTest
    @CsvSource({"BOX, 0.083333333", "TENT, 0.166666667", "GAUSS, 0.249732332", "MITCHELL, 0.111111111"})
    void aCurvedBrightnessIsWhatTheFilterMakesOfIt(PixelFilter filter, double square) {
        Sampling sampling = Sampling.of(RenderSettings.DEFAULT.withSamples(16, 16).withFilter(filter), false);
        double mean = 0;
        for (int pixel = 0; pixel < 256; pixel++) {
            PixelSums sums = summed(sampling, pixel % 16, pixel / 16, (x, y) -> 3 + x + 0.5 * y + (x - 0.5) * (x - 0.5));
            assertThat(sums.red).isCloseTo(3.75 + square, within(0.1));
            mean += sums.red / 256;
        }
        assertThat(mean).isCloseTo(3.75 + square, within(1e-3));
    }

    /**
     * Edges of any slope at any place, dark on one side and light on the other: of the pixels whose rays had seen both and were enough, the share
     * that the confidence promises is within the error, by the area of the pixel's lighter part.
     */
    @ParameterizedTest
    @CsvSource({"2, 0.01, 0.95", "2, 0.02, 0.95", "3, 0.02, 0.95", "4, 0.05, 0.99", "2, 0.02, 0.6", "4, 0.1, 0.9"})
    void theErrorIsAsSmallAsIsPromised(int least, double error, double confidence) {
        Sampling sampling = Sampling.of(RenderSettings.DEFAULT.withSamples(least, 16).withError(error).withConfidence(confidence), false);
        Random random = new Random(7);
        int enough = 0;
        int near = 0;
        int rays = 0;
        for (int pixel = 0; pixel < 4000; pixel++) {
            double slope = random.nextDouble();
            double at = random.nextDouble() * (1 + slope);
            double low = 0.2;
            double high = 0.2 + 0.8 * random.nextDouble();
            PixelSums sums = summed(sampling, pixel, 3, (x, y) -> x + slope * y < at ? high : low);
            rays += sums.count();
            if (sums.count() < 256 && ((HeldSums) sums).range(0) > 0) {
                enough++;
                double truth = low + (high - low) * area(slope, at);
                near += Math.abs(shown(sums.red) - shown(truth)) <= error ? 1 : 0;
            }
        }
        assertThat(enough).isGreaterThan(300);
        assertThat((double) near / enough).as("%d of 4000 pixels had enough, %d rays", enough, rays).isGreaterThanOrEqualTo(confidence);
    }

    /** Where x + slope·y lies below a number in the square. */
    private static double area(double slope, double at) {
        double sum = 0;
        for (int i = 0; i < 1000; i++) {
            sum += Math.max(0, Math.min(1, at - slope * (i + 0.5) / 1000)) / 1000;
        }
        return sum;
    }

    private static double shown(double light) {
        return light <= 0.0031308 ? 12.92 * light : 1.055 * Math.pow(light, 1 / 2.4) - 0.055;
    }

    @Test
    void whatIsEvenTakesNoMoreThanTheLeast() {
        Sampling sampling = Sampling.of(RenderSettings.DEFAULT.withSamples(2, 8), false);
        assertThat(summed(sampling, 1, 2, (x, y) -> 0.3).count()).isEqualTo(4);
        assertThat(summed(sampling, 1, 2, (x, y) -> x < 0.4 ? 0 : 1).count()).isGreaterThan(16);
        Sampling fromOne = Sampling.of(RenderSettings.DEFAULT.withSamples(1, 8), false);
        assertThat(summed(fromOne, 1, 2, (x, y) -> 0.3).count()).as("fewer have no spread").isEqualTo(4);
        Sampling onlyOne = Sampling.of(RenderSettings.DEFAULT.withSamples(1, 1), false);
        assertThat(summed(onlyOne, 1, 2, (x, y) -> x).count()).isEqualTo(1);
    }
}
